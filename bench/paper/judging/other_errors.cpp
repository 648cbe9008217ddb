#include "judging/other_errors.hpp"

#include <algorithm>
#include <cmath>

#include "base/barycentric.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {
namespace {

/// Midpoints of this many equal parts of each segment are sampled: the figures are compared to two digits.
constexpr int kParts = 4;

IdVector<VertexId, double> march_from(const Mesh& mesh, const SurfacePoint& generator) {
  DiagramOptions options;
  options.method = Method::gbgvd;
  options.front = Front::planar;
  options.threads = 1;
  return compute_diagram(mesh, {generator}, options).vertex_distance;
}

}  // namespace

OtherJudge::OtherJudge(const Mesh& mesh, const std::vector<SurfacePoint>& generators) : mesh_(mesh) {
  for (const SurfacePoint& g : generators) {
    exact_.emplace_back(mesh, std::vector<SurfacePoint>{g});
    marched_.push_back(march_from(mesh, g));
  }
}

double OtherJudge::march(GeneratorId g, const SurfacePoint& p) const {
  const auto& [a, b, c] = mesh_.vertices(p.face);
  const auto& distance = marched_[g.index()];
  return interpolate(p.bary, distance[a], distance[b], distance[c]);
}

OtherJudge::Owners OtherJudge::find_owners(const Diagram& diagram) const {
  Owners owners(static_cast<std::size_t>(mesh_.face_count()));
  for (std::size_t f = 0; f < owners.size(); ++f) {
    const GeneratorId label = diagram.face_label.raw()[f];
    if (label.valid()) owners[f].push_back(label);
  }
  for (const FacePiece& piece : diagram.pieces) {
    if (piece.generator.valid()) owners[piece.face.index()].push_back(piece.generator);
  }
  return owners;
}

/// The largest difference of the distances from all owners of a face and from the bisector's generators.
double OtherJudge::find_spread(const std::vector<GeneratorId>& owners, const Bisector& bisector,
                               const SurfacePoint& p) const {
  double least = exact(bisector.left, p), most = least;
  const auto add = [&](GeneratorId g) {
    const double d = exact(g, p);
    least = std::min(least, d);
    most = std::max(most, d);
  };
  add(bisector.right);
  for (const GeneratorId g : owners) {
    if (g != bisector.left && g != bisector.right) add(g);
  }
  return most - least;
}

void OtherJudge::add_segment(const Bisector& bisector, std::size_t i, const Owners& owners, OtherErrors& sum) const {
  const auto view = find_common_view(mesh_, bisector.points[i], bisector.points[(i + 1) % bisector.points.size()]);
  if (!view) return;
  const auto& [from, to] = *view;
  const double length = (position(mesh_, to) - position(mesh_, from)).norm() / kParts;
  if (length == 0) return;
  for (int part = 0; part < kParts; ++part) {
    const SurfacePoint p = make_surface_point(from.face, mix(from.bary, to.bary, (part + 0.5) / kParts));
    sum.by_marching += length * std::abs(march(bisector.left, p) - march(bisector.right, p));
    sum.of_face += length * find_spread(owners[from.face.index()], bisector, p);
    sum.distance += length * exact(bisector.left, p);
  }
}

OtherErrors OtherJudge::judge(const Diagram& diagram) const {
  const Owners owners = find_owners(diagram);
  OtherErrors sum;
  for (const Bisector& bisector : diagram.bisectors) {
    if (bisector.points.size() < 2) continue;
    const std::size_t segments = bisector.points.size() - (bisector.closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) add_segment(bisector, i, owners, sum);
  }
  return sum;
}

}  // namespace gvd::paper
