// Where a vertex of a curve is the nearest point of the curve.
//
// A shortest path that leaves a curve at a vertex forms an angle of at least pi / 2 with both segments beside it; if an
// angle were smaller, a path from a point of that segment would be shorter. Between two segments that form the angle
// theta, paths therefore leave only in [pi / 2, theta - pi / 2]. All other paths leave the segments at right angles.
// Error: angles are sums of a dozen arc tangents, 1e-15 radians. A sector narrower than kFlatAngle is left out;
// kGrazingAngle lets the windows on its two sides find the vertices in it.
#include "geodesic/windows/propagation/curve_sectors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr double kRightAngle = std::numbers::pi / 2;

}  // namespace

CurveSectors::CurveSectors(const Mesh& mesh, const FaceFrames& frames, const CurveEdges& curves)
    : mesh_(mesh), frames_(frames), is_curve_(mesh.edge_count(), false) {
  for (const HalfedgeId h : curves.edges) is_curve_[mesh.edge(h).index()] = true;
}

/// At a boundary vertex, the last edge has no halfedge that leaves the vertex; its halfedge precedes the one of the
/// last corner.
CurveSectors::Spokes CurveSectors::spokes(VertexId v) const {
  Spokes found;
  double angle = 0;
  const auto add_edge = [&](HalfedgeId h) {
    if (is_curve_[mesh_.edge(h).index()]) found.curve_angle.push_back(angle);
  };
  for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
    add_edge(h);
    found.corner.push_back(h);
    found.angle.push_back(angle);
    const FaceFrame& f = frames_.frame[Mesh::face(h)];
    angle += std::atan2(f.sine[Mesh::corner(h)], f.cosine[Mesh::corner(h)]);
  });
  if (mesh_.is_boundary(v)) add_edge(Mesh::previous(found.corner.back()));
  found.angle.push_back(angle);
  return found;
}

/// The ray at an angle in [0, 2 total), where angles of at least the total angle have gone round once.
FanRay CurveSectors::ray(const Spokes& spokes, double angle) {
  if (angle >= spokes.angle.back()) angle -= spokes.angle.back();
  const auto next = std::upper_bound(spokes.angle.begin(), spokes.angle.end() - 1, angle);
  const auto i = std::max<std::ptrdiff_t>(next - spokes.angle.begin(), 1) - 1;
  const double inside = angle - spokes.angle[i];
  return {spokes.corner[i], {std::cos(inside), std::sin(inside)}};
}

std::vector<CurveSector> CurveSectors::at(VertexId v) const {
  const Spokes all = spokes(v);
  const std::vector<double>& curve = all.curve_angle;
  const double total = all.angle.back();
  std::vector<CurveSector> sectors;
  const auto add = [&](double from, double to) {
    if (to - from > 2 * kRightAngle + kFlatAngle) {
      sectors.push_back({ray(all, from + kRightAngle), ray(all, to - kRightAngle)});
    }
  };
  for (std::size_t i = 1; i < curve.size(); ++i) add(curve[i - 1], curve[i]);
  if (!mesh_.is_boundary(v)) {
    add(curve.back(), curve.front() + total);
    return sectors;
  }
  if (curve.front() > kRightAngle + kFlatAngle) sectors.push_back({{}, ray(all, curve.front() - kRightAngle)});
  if (total - curve.back() > kRightAngle + kFlatAngle) sectors.push_back({ray(all, curve.back() + kRightAngle), {}});
  return sectors;
}

}  // namespace gvd
