#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/sound_diagram.hpp"

namespace gvd::test {

/// Crossings and branch points of exact diagrams are equidistant to this fraction of the bounding box's diagonal. The
/// oracle's own error is 1e-9 of the distance at worst; on the meshes of the tests it is much less.
inline constexpr double kEquidistant = 1e-12;

/// An exact diagram that has passed its check.
inline Diagram compute_sound_exact(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                                   double chord_tolerance = 1e-4) {
  DiagramOptions options;
  options.method = Method::exact;
  options.chord_tolerance = chord_tolerance;
  return compute_sound(mesh, generators, options);
}

/// How far a diagram is from equal distances, by CGAL's exact shortest paths, one run a generator; mesh units.
struct Unequal {
  double crossings = 0;      ///< where bisectors cross edges: the largest difference of the two distances
  double branch_points = 0;  ///< the largest difference among the distances to the generators of one
  double nearer = 0;         ///< how much nearer another generator is, at any of these
};

inline Unequal measure_inequality(const Mesh& mesh, const Diagram& diagram) {
  std::vector<SurfacePoint> points;
  std::vector<std::vector<GeneratorId>> equal;
  for (const BranchPoint& b : diagram.branch_points) {
    points.push_back(b.point);
    equal.push_back(b.generators);
  }
  for (const Bisector& b : diagram.bisectors) {
    for (std::size_t i = b.ends[0].valid() ? 1 : 0; i + (b.ends[1].valid() ? 1 : 0) < b.points.size(); ++i) {
      if (b.points[i].kind() == SurfacePoint::Kind::face) continue;
      points.push_back(b.points[i]);
      equal.push_back({b.left, b.right});
    }
  }
  std::vector<DistanceQuery> queries;
  for (const SurfacePoint& g : diagram.generators) queries.push_back({g, points});
  const auto distances = compute_exact_distances(mesh, queries);
  Unequal unequal;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double least = distances[equal[i][0].index()][i], most = least, nearest = least;
    for (const GeneratorId g : equal[i]) {
      least = std::min(least, distances[g.index()][i]);
      most = std::max(most, distances[g.index()][i]);
    }
    for (const auto& row : distances) nearest = std::min(nearest, row[i]);
    double& worst = i < diagram.branch_points.size() ? unequal.branch_points : unequal.crossings;
    worst = std::max(worst, most - least);
    unequal.nearer = std::max(unequal.nearer, least - nearest);
  }
  return unequal;
}

/// `most`: in mesh units.
inline void require_equidistant(const Mesh& mesh, const Diagram& diagram, const Unequal& most) {
  const Unequal unequal = measure_inequality(mesh, diagram);
  CHECK(unequal.crossings / most.crossings <= 1);  // parts: a failure shows how far it is
  CHECK(unequal.branch_points / most.branch_points <= 1);
  CHECK(unequal.nearer / most.nearer <= 1);
}

/// To kEquidistant, as it holds but for ties at vertices and along edges.
inline void require_equidistant(const Mesh& mesh, const Diagram& diagram) {
  const double most = kEquidistant * mesh.bbox_diagonal();
  require_equidistant(mesh, diagram, {most, most, most});
}

}  // namespace gvd::test
