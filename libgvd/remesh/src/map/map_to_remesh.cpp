// The map of a surface onto its remesh: one-to-one if the proof's conditions hold, otherwise by nearest points.
//
// The one-to-one map works cell by cell, in parallel: cut the surface into cells, lay out the polygons of the branch
// points, then flatten each cell and read the points off. Each vertex of the surface lies in one cell, or on the border
// of two, which agree. All of that is done on the dual; if edges of it were flipped, the points then follow the flips.
// If a check fails anywhere, all points are nearest points instead, so that a map is always one of the two kinds.
// Finally, the images of all faces are measured.
#include <algorithm>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/surface_point.hpp"
#include "map/cell_map.hpp"
#include "map/cut_into_cells.hpp"
#include "map/dual_polygons.hpp"
#include "map/follow_flips.hpp"
#include "map/nearest_points.hpp"

namespace gvd {
namespace {

/// The number of faces of a chunk of cells. Their systems take milliseconds.
constexpr std::size_t kMapFacesPerChunk = 2048;

/// The points to which a cell takes its vertices of the surface, and the point that it takes to its vertex of the
/// remesh.
struct CellImages {
  SurfacePoint origin;
  std::vector<std::pair<VertexId, SurfacePoint>> points;
};

/// A vertex between two cells is on the borders of both, which give it the same point.
CellImages list_images(const CellMapInput& input, const PlaneCell& plane) {
  const auto is_of_surface = [&](VertexId v) { return v.value() < input.surface.vertex_count(); };
  CellImages images{plane.origin, {}};
  for (std::size_t i = 0; i < plane.disc.vertices.size(); ++i) {
    const VertexId v = plane.disc.vertices[i];
    if (is_of_surface(v)) images.points.emplace_back(v, plane.image(plane.disc.points[i]));
  }
  for (const BorderTarget& t : plane.targets) {
    const VertexId v = input.cells.cut.mesh.from(t.halfedge);
    if (is_of_surface(v)) images.points.emplace_back(v, t.polygon->on_remesh(t.from));
  }
  if (plane.origin.kind() == SurfacePoint::Kind::vertex) {
    images.points.emplace_back(vertex(input.surface, plane.origin),
                               vertex_point(input.polygons.remesh(), plane.vertex));
  }
  return images;
}

/// Flattens all cells in parallel. Returns the first error of a cell.
OrError<std::vector<CellImages>> map_cells(const CellMapInput& input, int threads, const Progress& progress) {
  const auto& label = input.cells.cut.label;
  IdVector<GeneratorId, std::vector<FaceId>> faces(input.result.generators.size());
  for (const FaceId f : label.ids()) faces[label[f]].push_back(f);
  const ParallelChunks parallel(threads, progress);
  const auto chunks =
      cut_by_work(faces.size(), kMapFacesPerChunk, [&](std::size_t i) { return faces.raw()[i].size(); });
  auto mapped = parallel.collect(chunks, {"map"}, [&](const Chunk& chunk) {
    std::vector<OrError<CellImages>> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      auto plane = flatten_cell(input, GeneratorId(i), faces[GeneratorId(i)]);
      if (Error* const error = std::get_if<Error>(&plane)) {
        found.emplace_back(std::move(*error));
        break;
      }
      found.emplace_back(list_images(input, std::get<PlaneCell>(plane)));
    }
    return found;
  });
  std::vector<CellImages> images;
  for (OrError<CellImages>& cell : mapped) {
    if (Error* const error = std::get_if<Error>(&cell)) return std::move(*error);
    images.push_back(std::get<CellImages>(std::move(cell)));
  }
  return images;
}

/// The map without the measurements of its images. Returns Error{no_valid_result} with the first condition of the proof
/// that fails, if any does. Deterministic, for every number of threads.
OrError<RemeshMap> map_one_to_one(const Mesh& surface, const RemeshResult& result, int threads,
                                  const Progress& progress) {
  auto cut = cut_into_cells(surface, result, progress);
  if (Error* const error = std::get_if<Error>(&cut)) return std::move(*error);
  const auto& cells = std::get<CellSurface>(cut);
  const Mesh dual(result.mesh.positions(), undo_flips(result.mesh.face_vertices(), result.flips));
  auto built = DualPolygons::try_to_build(cells.cut.mesh, cells.cut.label, dual);
  if (Error* const error = std::get_if<Error>(&built)) return std::move(*error);
  auto& polygons = std::get<DualPolygons>(built);
  place_crossings(cells, polygons);
  auto mapped = map_cells({surface, result, cells, polygons}, threads, progress);
  if (Error* const error = std::get_if<Error>(&mapped)) return std::move(*error);
  const FlipFollower flips(dual, result.mesh, result.flips);
  RemeshMap map;
  map.one_to_one = true;
  map.points.resize(surface.vertex_count());
  for (const CellImages& cell : std::get<std::vector<CellImages>>(mapped)) {
    map.origins.push_back(cell.origin);
    for (const auto& [vertex, point] : cell.points) map.points[vertex] = flips.follow(point);
  }
  return map;
}

/// An image has no area unless twice its area exceeds this fraction of its longest edge squared. It is above the
/// rounding of the corners of images that are a millionth of the mesh in size.
constexpr double kFlatImage = 1e-9;

/// Measures how far the vertices move, and compares the image of each face with the normals of the remesh at its
/// corners. A point at a vertex of the remesh has faces on all sides, so that the normal of the one face that it names
/// would tell nothing.
void measure_images(const Mesh& surface, const Mesh& remesh, RemeshMap& map) {
  const auto image = [&](VertexId v) { return position(remesh, map.points[v]); };
  double sum = 0;
  for (const VertexId v : surface.vertices()) {
    const double move = (image(v) - surface.position(v)).norm();
    map.largest_move = std::max(map.largest_move, move);
    sum += move;
  }
  map.mean_move = sum / surface.vertex_count();
  for (const FaceId f : surface.faces()) {
    const auto& [a, b, c] = surface.vertices(f);
    const Vec3 along = image(b) - image(a), across = image(c) - image(a);
    const Vec3 area = along.cross(across);
    const double square = std::max({along.squaredNorm(), across.squaredNorm(), (across - along).squaredNorm()});
    Vec3 normal = Vec3::Zero();
    for (const VertexId v : {a, b, c}) normal += surface_normal(remesh, map.points[v]);
    if (!(area.norm() > kFlatImage * square)) {
      ++map.collapsed_faces;
    } else {
      ++(area.dot(normal) > 0 ? map.kept_faces : map.reversed_faces);
    }
  }
}

}  // namespace

RemeshMap map_to_remesh(const Mesh& surface, const RemeshResult& result, int threads, const Progress& progress) {
  if (result.diagram.vertex_label.count() != surface.vertex_count() ||
      std::ssize(result.generators) != result.mesh.vertex_count()) {
    throw Error(ErrorCode::precondition, "the remesh is not one of this surface");
  }
  OrError<RemeshMap> one_to_one =
      result.decimated.components > 0
          ? Error(ErrorCode::no_valid_result, "a connected part is decimated, and not the dual of its cells")
          : map_one_to_one(surface, result, threads, progress);
  RemeshMap map;
  if (const Error* const obstacle = std::get_if<Error>(&one_to_one)) {
    map.obstacle = obstacle->what();
    map.points = nearest_points(surface, result, threads, progress);
    map.origins = IdVector<VertexId, SurfacePoint>(result.generators);
  } else {
    map = std::get<RemeshMap>(std::move(one_to_one));
  }
  measure_images(surface, result.mesh, map);
  return map;
}

}  // namespace gvd
