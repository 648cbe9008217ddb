// The map of a surface onto its remesh: one-to-one where the proof's conditions hold, else by nearest points.
//
// The one-to-one map works cell by cell, in parallel: cut the surface into cells, lay out the polygons of the branch
// points, then flatten each cell and read the points off. Each vertex of the surface lies in one cell, or on the border
// of two, which agree. If a check fails anywhere, all points are nearest points instead, so that a map is always one of
// the two kinds. At last the images of all faces are measured.
//
// A branch point of k cells is k - 2 faces of the remesh. A regular polygon with a corner for each cell, cut as these
// faces are, gives all of them one set of coordinates. The branch point goes to the polygon's centre, and the parts of
// the cells are bounded by the lines from the centre to the crossings on the sides. Each face of the remesh belongs to
// exactly one polygon, or there is no map.
#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "base/barycentric.hpp"
#include "base/least.hpp"
#include "base/parallel_chunks.hpp"
#include "base/plane.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/surface_point.hpp"
#include "map/map_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Least barycentric coordinate of a triangle's centre: the branch point of an obtuse triangle is outside of it. A
/// centre near a side would squeeze the parts of the cells there.
constexpr double kLeastOfCentre = 0.08;

[[noreturn]] void refuse_cells_at(VertexId at, const char* what) {
  throw Error(ErrorCode::no_valid_result,
              fmt::format("the cells round vertex {} of the cut surface {}", at.value(), what), at.value());
}

/// The labels round v, counter-clockwise, without repetitions; from boundary to boundary where v is on it.
std::vector<GeneratorId> cells_round(const Mesh& cut, const IdVector<FaceId, GeneratorId>& label, VertexId v) {
  std::vector<GeneratorId> cells;
  for_each_outgoing(cut, v, [&](HalfedgeId h) {
    const GeneratorId g = label[Mesh::face(h)];
    if (cells.empty() || cells.back() != g) cells.push_back(g);
  });
  if (!cut.is_boundary(v) && cells.size() > 1 && cells.back() == cells.front()) cells.pop_back();
  return cells;
}

Bary coordinates(const DualPolygon& polygon, const DualPolygon::Triangle& triangle, const Vec2& point) {
  std::array<Vec2, 3> at;
  for (std::size_t i = 0; i < 3; ++i) at[i] = polygon.corner(triangle.corners[i]);
  return bary_by_areas(at, point,
                       [](const Vec2& a, const Vec2& b, const Vec2& c) { return twice_signed_area(a, b, c); });
}

/// The point of a triangle nearest to a branch point, but not at a side.
Vec2 inner_centre(const DualPolygon& polygon, const Mesh& remesh, const Vec3& branch_point) {
  const DualPolygon::Triangle& triangle = polygon.triangles.front();
  const Bary bary = closest_point_on_face(remesh, triangle.face, branch_point).point.bary;
  Vec2 centre = Vec2::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double weight = std::max(bary[i], kLeastOfCentre);
    centre += weight * polygon.corner(triangle.corners[i]);
    sum += weight;
  }
  return centre / sum;
}

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
      : cells_(cut_into_cells(surface, result, progress)),
        polygons_(cells_.cut.mesh, cells_.cut.label, result.mesh),
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
      for (const Image& image : cell.images) map.points[image.vertex] = image.point;
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
      cell.images.push_back({vertex(input_.surface, plane.origin), vertex_point(input_.result.mesh, plane.vertex)});
    }
    return cell;
  }

  CellSurface cells_;
  DualPolygons polygons_;
  CellMapInput input_;
  IdVector<GeneratorId, std::vector<FaceId>> faces_;
};

/// Vertices of a chunk: each takes some tens of closest points.
constexpr std::size_t kVerticesPerChunk = 512;

/// The triangles at a vertex and its neighbours, ascending, and their boundary halfedges.
struct Patch {
  std::vector<FaceId> faces;
  std::vector<HalfedgeId> boundary;
};

Patch collect_patch(const Mesh& mesh, VertexId centre) {
  Patch patch;
  const auto add_star = [&](VertexId v) {
    for_each_outgoing(mesh, v, [&](HalfedgeId h) { patch.faces.push_back(Mesh::face(h)); });
  };
  add_star(centre);
  for_each_neighbour(mesh, centre, [&](VertexId v, HalfedgeId) { add_star(v); });
  std::sort(patch.faces.begin(), patch.faces.end());
  patch.faces.erase(std::unique(patch.faces.begin(), patch.faces.end()), patch.faces.end());
  for (const FaceId f : patch.faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!mesh.twin(h).valid()) patch.boundary.push_back(h);
    }
  }
  return patch;
}

class NearestMapper {
 public:
  NearestMapper(const Mesh& surface, const RemeshResult& result) : surface_(surface), result_(result) {
    at_vertex_.resize(result.diagram.vertex_label.size());
    for (const VertexId v : result.mesh.vertices()) {
      patches_.push_back(collect_patch(result.mesh, v));
      remember(result.generators[v.index()], v);
    }
  }

  IdVector<VertexId, SurfacePoint> run(int threads, const Progress& progress) const {
    const ParallelChunks parallel(threads, progress);
    const auto chunks = cut_into_chunks(result_.diagram.vertex_label.size(), kVerticesPerChunk);
    return IdVector<VertexId, SurfacePoint>(parallel.collect(chunks, {"map"}, [&](const Chunk& chunk) {
      std::vector<SurfacePoint> points;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) points.push_back(map_vertex(VertexId(i)));
      return points;
    }));
  }

 private:
  void remember(const SurfacePoint& generator, VertexId vertex) {
    const auto corner = std::find(generator.bary.begin(), generator.bary.end(), 1.0) - generator.bary.begin();
    if (corner < 3) at_vertex_[surface_.vertices(generator.face)[corner]] = vertex;
  }

  SurfacePoint map_vertex(VertexId v) const {
    if (at_vertex_[v].valid()) return vertex_point(result_.mesh, at_vertex_[v]);
    const GeneratorId label = result_.diagram.vertex_label[v];
    if (!label.valid()) throw Error(ErrorCode::precondition, "a vertex is in no cell", v.value());
    const Patch& patch = patches_[label.index()];
    return surface_.is_boundary(v) && !patch.boundary.empty() ? on_boundary(v, patch) : on_faces(v, patch);
  }

  SurfacePoint on_boundary(VertexId v, const Patch& patch) const {
    const Vec3& at = surface_.position(v);
    Least<SurfacePoint> nearest;
    for (const HalfedgeId h : patch.boundary) {
      const SurfacePoint found = edge_point(h, std::clamp(foot_on_edge(result_.mesh, h, at), 0.0, 1.0));
      nearest.offer((position(result_.mesh, found) - at).norm(), found);
    }
    return nearest.value;
  }

  SurfacePoint on_faces(VertexId v, const Patch& patch) const {
    const Vec3 normal = surface_normal(surface_, vertex_point(surface_, v));
    const SurfacePoint best = find_nearest_facing(result_.mesh, patch.faces, surface_.position(v), normal);
    return make_surface_point(best.face, best.bary);
  }

  const Mesh& surface_;
  const RemeshResult& result_;
  std::vector<Patch> patches_;              // per vertex of the remesh
  IdVector<VertexId, VertexId> at_vertex_;  // per vertex of the surface: of the remesh; invalid without a generator
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

SurfacePoint DualPolygon::on_remesh(const Vec2& point) const {
  Least<SurfacePoint> inside;  // in the triangle that the point is least outside of
  for (const Triangle& triangle : triangles) {
    const Bary bary = coordinates(*this, triangle, point);
    inside.offer(-std::min({bary[0], bary[1], bary[2]}), {triangle.face, bary});
  }
  for (double& b : inside.value.bary) b = std::max(b, 0.0);
  return make_surface_point(inside.value.face, inside.value.bary);
}

DualPolygons::DualPolygons(const Mesh& cut, const IdVector<FaceId, GeneratorId>& label, const Mesh& remesh)
    : remesh_(remesh), number_(cut.vertex_count(), -1), is_used_(remesh.face_count(), 0) {
  for (const VertexId v : cut.vertices()) {
    std::vector<GeneratorId> cells = cells_round(cut, label, v);
    if (cells.size() >= 3) add(cut, v, std::move(cells));
  }
  const auto unused = std::find(is_used_.begin(), is_used_.end(), 0);
  if (unused == is_used_.end()) return;
  const std::int64_t f = unused - is_used_.begin();
  throw Error(ErrorCode::no_valid_result,
              fmt::format("face {} of the remesh stands for no point of the cut surface", f), f);
}

void DualPolygons::add(const Mesh& cut, VertexId v, std::vector<GeneratorId> cells) {
  DualPolygon polygon{std::move(cells), {}, Vec2::Zero(), {}};
  polygon.crossings.assign(polygon.cells.size(), 0.5);
  fill(polygon, v);
  if (cut.is_boundary(v)) {
    polygon.centre = polygon.crossing(polygon.cells.size() - 1);
  } else if (polygon.cells.size() == 3) {
    polygon.centre = inner_centre(polygon, remesh_, cut.position(v));
  }
  number_[v] = static_cast<std::int32_t>(polygons_.size());
  polygons_.push_back(std::move(polygon));
}

/// Fills a polygon with the faces of the remesh, from the side between the last corner and the first one, which
/// determines one triangle, across its other two sides.
void DualPolygons::fill(DualPolygon& polygon, VertexId at) {
  std::vector<std::pair<std::size_t, std::size_t>> chains{{0, polygon.cells.size() - 1}};
  while (!chains.empty()) {
    const auto [first, last] = chains.back();
    chains.pop_back();
    const HalfedgeId side = find_halfedge(polygon.cells[last], polygon.cells[first], at);
    const std::size_t apex = polygon.find(GeneratorId(remesh_.opposite(side).value()));
    if (apex <= first || apex >= last || is_used_[Mesh::face(side)])
      refuse_cells_at(at, "are not those of faces of the remesh");
    is_used_[Mesh::face(side)] = 1;
    DualPolygon::Triangle triangle{Mesh::face(side), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = polygon.find(GeneratorId(remesh_.vertices(triangle.face)[i].value()));
    }
    polygon.triangles.push_back(triangle);
    if (apex > first + 1) chains.emplace_back(first, apex);
    if (last > apex + 1) chains.emplace_back(apex, last);
  }
}

HalfedgeId DualPolygons::find_halfedge(GeneratorId from, GeneratorId to, VertexId at) const {
  HalfedgeId found;
  for_each_outgoing(remesh_, VertexId(from.value()), [&](HalfedgeId h) {
    if (remesh_.to(h).value() == to.value()) found = h;
  });
  if (!found.valid()) refuse_cells_at(at, "are not joined by edges of the remesh");
  return found;
}

IdVector<VertexId, SurfacePoint> nearest_points(const Mesh& surface, const RemeshResult& result, int threads,
                                                const Progress& progress) {
  return NearestMapper(surface, result).run(threads, progress);
}

RemeshMap map_to_remesh(const Mesh& surface, const RemeshResult& result, int threads, const Progress& progress) {
  if (result.diagram.vertex_label.count() != surface.vertex_count() ||
      std::ssize(result.generators) != result.mesh.vertex_count()) {
    throw Error(ErrorCode::precondition, "the remesh is not one of this surface");
  }
  RemeshMap map;
  try {
    map = OneToOneMapper(surface, result, progress).run(threads, progress);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::no_valid_result) throw;
    map.obstacle = error.what();
    map.points = nearest_points(surface, result, threads, progress);
    map.origins = IdVector<VertexId, SurfacePoint>(result.generators);
  }
  measure_images(surface, result.mesh, map);
  return map;
}

}  // namespace gvd
