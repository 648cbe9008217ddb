#pragma once

#include <optional>
#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "diagram/assembly/face_polygon.hpp"

namespace gvd::test {

/// A crossing on the boundary of a face, before the label `next`.
inline BoundaryCrossing crossing(int id, int corner, double t, int previous, int next) {
  return {CrossingId(id), corner, t, GeneratorId(previous), GeneratorId(next)};
}

/// A boundary whose crossings are in order round the face, between the labels that follow them.
inline std::vector<BoundaryCrossing> boundary_of(const std::vector<std::pair<double, int>>& positions_and_labels) {
  std::vector<BoundaryCrossing> boundary;
  const std::size_t n = positions_and_labels.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [position, next] = positions_and_labels[i];
    const int corner = static_cast<int>(position);
    boundary.push_back(
        crossing(static_cast<int>(i), corner, position - corner, positions_and_labels[(i + n - 1) % n].second, next));
  }
  return boundary;
}

/// The polygon of all crossings of a face, as its assembly begins.
inline FacePolygon polygon_of(const std::vector<BoundaryCrossing>& boundary) {
  FacePolygon polygon;
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    polygon.push_back({at(boundary[i].id), boundary[i].bary(), boundary[i].next, static_cast<int>(i)});
  }
  return polygon;
}

/// Distances from points in the plane of barycentric coordinates, with all answers known. Every path comes straight
/// through the boundary position that `entries` gives its generator.
class PointDistances : public FaceDistances, public FacePaths {
 public:
  std::vector<Vec2> points;                    ///< of the generators, as affine points of the face
  std::vector<std::optional<double>> entries;  ///< corner + t for each generator; nothing where it is unknown
  std::optional<Bary> equal;                   ///< the answer to every search
  bool is_branch = true;
  double error = 0;          ///< of all crossings
  mutable int searches = 0;  ///< calls of equidistant()

  double at(GeneratorId g, const Bary& p) const override { return (affine_point(p) - points[g.index()]).norm(); }
  std::optional<Bary> equidistant(GeneratorId, GeneratorId, GeneratorId, const Bary&) const override {
    ++searches;
    return equal;
  }
  std::vector<Bary> equidistant_points(GeneratorId, GeneratorId, GeneratorId) const override { return {}; }
  std::optional<double> entry(GeneratorId g, const Bary&) const override {
    return g.index() < entries.size() ? entries[g.index()] : std::nullopt;
  }
  double crossing_error(const BoundaryCrossing&) const override { return error; }
  bool is_branch_point(GeneratorId, GeneratorId, GeneratorId, const Bary&) const override { return is_branch; }
};

}  // namespace gvd::test
