// The polygons of branch points.
//
// A branch point of k cells is k - 2 faces of the remesh. A regular polygon with a corner for each cell, cut as these
// faces are, gives all of them one set of coordinates. The branch point goes to the polygon's centre, and the parts of
// the cells are bounded by the lines from the centre to the crossings on the sides. Each face of the remesh belongs to
// exactly one polygon, or there is no map.
#include "map/dual_polygons.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/barycentric.hpp"
#include "base/least.hpp"
#include "base/plane.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The least barycentric coordinate of a triangle's centre, because the branch point of an obtuse triangle is outside
/// the triangle. A centre near a side would squeeze the parts of the cells there.
constexpr double kLeastOfCentre = 0.08;

/// The labels around v, counter-clockwise, without repetitions; from boundary to boundary if v is on it.
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

OrError<DualPolygons> DualPolygons::try_to_build(const Mesh& cut, const IdVector<FaceId, GeneratorId>& label,
                                                 const Mesh& remesh) {
  DualPolygons polygons(cut.vertex_count(), remesh);
  for (const VertexId v : cut.vertices()) {
    std::vector<GeneratorId> cells = cells_round(cut, label, v);
    if (cells.size() < 3) continue;
    if (const char* const obstacle = polygons.add(cut, v, std::move(cells))) {
      return Error(ErrorCode::no_valid_result,
                   fmt::format("the cells round vertex {} of the cut surface {}", v.value(), obstacle), v.value());
    }
  }
  const auto& is_used = polygons.is_used_;
  const std::int64_t unused = std::find(is_used.begin(), is_used.end(), 0) - is_used.begin();
  if (unused == std::ssize(is_used)) return polygons;
  return Error(ErrorCode::no_valid_result,
               fmt::format("face {} of the remesh stands for no point of the cut surface", unused), unused);
}

const char* DualPolygons::add(const Mesh& cut, VertexId v, std::vector<GeneratorId> cells) {
  DualPolygon polygon{std::move(cells), {}, Vec2::Zero(), {}};
  polygon.crossings.assign(polygon.cells.size(), 0.5);
  if (const char* const obstacle = fill(polygon)) return obstacle;
  if (cut.is_boundary(v)) {
    polygon.centre = polygon.crossing(polygon.cells.size() - 1);
  } else if (polygon.cells.size() == 3) {
    polygon.centre = inner_centre(polygon, remesh_, cut.position(v));
  }
  number_[v] = static_cast<std::int32_t>(polygons_.size());
  polygons_.push_back(std::move(polygon));
  return nullptr;
}

/// Fills a polygon with the faces of the remesh, from the side between the last corner and the first one, which
/// determines one triangle, across its other two sides.
const char* DualPolygons::fill(DualPolygon& polygon) {
  std::vector<std::pair<std::size_t, std::size_t>> chains{{0, polygon.cells.size() - 1}};
  while (!chains.empty()) {
    const auto [first, last] = chains.back();
    chains.pop_back();
    const HalfedgeId side = find_halfedge(polygon.cells[last], polygon.cells[first]);
    if (!side.valid()) return "are not joined by edges of the remesh";
    const std::size_t apex = polygon.find(GeneratorId(remesh_.opposite(side).value()));
    if (apex <= first || apex >= last || is_used_[Mesh::face(side)]) return "are not those of faces of the remesh";
    is_used_[Mesh::face(side)] = 1;
    DualPolygon::Triangle triangle{Mesh::face(side), {}};
    for (std::size_t i = 0; i < 3; ++i) {
      triangle.corners[i] = polygon.find(GeneratorId(remesh_.vertices(triangle.face)[i].value()));
    }
    polygon.triangles.push_back(triangle);
    if (apex > first + 1) chains.emplace_back(first, apex);
    if (last > apex + 1) chains.emplace_back(apex, last);
  }
  return nullptr;
}

HalfedgeId DualPolygons::find_halfedge(GeneratorId from, GeneratorId to) const {
  HalfedgeId found;
  for_each_outgoing(remesh_, VertexId(from.value()), [&](HalfedgeId h) {
    if (remesh_.to(h).value() == to.value()) found = h;
  });
  return found;
}

}  // namespace gvd
