// The map of a surface onto its remesh: one-to-one where the proof's conditions hold, else by nearest points.
//
// The one-to-one map works cell by cell, in parallel: cut the surface into cells, lay out the polygons of the branch
// points, then flatten each cell and read the points off. Each vertex of the surface lies in one cell, or on the border
// of two, which agree. All that is done on the dual: where edges of it were flipped, the points go on to the flipped
// faces. If a check fails anywhere, all points are nearest points instead, so that a map is always one of
// the two kinds. At last the images of all faces are measured.
#include <algorithm>
#include <string>
#include <utility>

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

/// Faces of a chunk of cells: their systems take milliseconds.
constexpr std::size_t kMapFacesPerChunk = 2048;

struct Image {
  VertexId vertex;  ///< of the surface
  SurfacePoint point;
};

struct CellPoints {
  SurfacePoint origin;
  std::vector<Image> images;
};

/// Maps cell by cell. Throws Error{no_valid_result} where a condition of the proof does not hold, with the first one
/// that fails. Deterministic, for every number of threads.
class OneToOneMapper {
 public:
  OneToOneMapper(const Mesh& surface, const RemeshResult& result, const Progress& progress)
      : dual_(result.mesh.positions(), undo_flips(result.mesh.face_vertices(), result.flips)),
        flips_(dual_, result.mesh, result.flips),
        cells_(cut_into_cells(surface, result, progress)),
        polygons_(cells_.cut.mesh, cells_.cut.label, dual_),
        input_{surface, result, cells_, polygons_},
        faces_(result.generators.size()) {
    place_crossings(cells_, polygons_);
    for (const FaceId f : cells_.cut.label.ids()) faces_[cells_.cut.label[f]].push_back(f);
  }

  /// The map without the measurements of its images.
  RemeshMap run(int threads, const Progress& progress) const {
    const ParallelChunks parallel(threads, progress);
    const auto chunks =
        cut_by_work(faces_.size(), kMapFacesPerChunk, [&](std::size_t i) { return faces_.raw()[i].size(); });
    const std::vector<CellPoints> cells = parallel.collect(chunks, {"map"}, [&](const Chunk& chunk) {
      std::vector<CellPoints> found;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) found.push_back(map_cell(GeneratorId(i)));
      return found;
    });
    RemeshMap map;
    map.one_to_one = true;
    map.points.resize(input_.surface.vertex_count());
    for (const CellPoints& cell : cells) {
      map.origins.push_back(cell.origin);
      for (const Image& image : cell.images) map.points[image.vertex] = flips_.follow(image.point);
    }
    return map;
  }

 private:
  /// Vertices between two cells are on both borders; there, they have the same point.
  CellPoints map_cell(GeneratorId g) const {
    const PlaneCell plane = flatten_cell(input_, g, faces_[g]);
    CellPoints cell{plane.origin, {}};
    for (std::size_t i = 0; i < plane.disc.vertices.size(); ++i) {
      const VertexId v = plane.disc.vertices[i];
      if (v.value() < input_.surface.vertex_count()) cell.images.push_back({v, plane.image(plane.disc.points[i])});
    }
    for (const BorderTarget& t : plane.targets) {
      const VertexId v = cells_.cut.mesh.from(t.halfedge);
      if (v.value() < input_.surface.vertex_count()) cell.images.push_back({v, t.polygon->on_remesh(t.from)});
    }
    if (plane.origin.kind() == SurfacePoint::Kind::vertex) {
      cell.images.push_back({vertex(input_.surface, plane.origin), vertex_point(dual_, plane.vertex)});
    }
    return cell;
  }

  Mesh dual_;
  FlipFollower flips_;
  CellSurface cells_;
  DualPolygons polygons_;
  CellMapInput input_;
  IdVector<GeneratorId, std::vector<FaceId>> faces_;
};

/// An image has no area unless twice its area exceeds this fraction of its longest edge squared. It is above the
/// rounding of the corners of images that are a millionth of the mesh in size.
constexpr double kFlatImage = 1e-9;

/// Measures how far the vertices move, and compares the image of each face with the normals of the remesh at its
/// corners. A vertex there has faces on all sides: the one that its point names would tell nothing.
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
  RemeshMap map;
  const auto map_to_nearest = [&](const std::string& obstacle) {
    map.obstacle = obstacle;
    map.points = nearest_points(surface, result, threads, progress);
    map.origins = IdVector<VertexId, SurfacePoint>(result.generators);
  };
  if (result.decimated.components > 0) {
    map_to_nearest("a connected part is decimated, and not the dual of its cells");
  } else {
    try {
      map = OneToOneMapper(surface, result, progress).run(threads, progress);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::no_valid_result) throw;
      map_to_nearest(error.what());
    }
  }
  measure_images(surface, result.mesh, map);
  return map;
}

}  // namespace gvd
