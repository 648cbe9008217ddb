#pragma once

#include <optional>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/crossings.hpp"

namespace gvd {

/// Least barycentric coordinate at which a computed branch point still counts as one of the face. A point that should
/// lie on a side may be computed beyond it, because crossings near it are rounded and keep a gap.
inline constexpr double kBeyondFace = 1e-9;

/// Least barycentric coordinate of a confirmed branch point: points between here and -kBeyondFace are moved inside.
inline constexpr double kInsideFace = 2e-12;

/// The distances inside one face, as its assembly compares them.
class FaceDistances {
 public:
  virtual ~FaceDistances() = default;

  /// A number that grows with the distance from generator g to p, comparable between generators at the same p.
  virtual double at(GeneratorId g, const Bary& p) const = 0;
  /// A point equally far from the three generators, found by a search from `start`; it may lie outside the face.
  virtual std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const = 0;
};

/// The shortest paths inside one face, which only accurate distances have. They confirm branch points; without paths,
/// branch points are guessed.
class FacePaths {
 public:
  virtual ~FacePaths() = default;

  /// Where the shortest path from g to p enters the face: corner + t on the halfedge of that corner, in [0, 3]; nothing
  /// if it is unknown. The path stays in g's cell, so that p and the boundary there belong to one piece.
  virtual std::optional<double> entry(GeneratorId g, const Bary& p) const = 0;
  /// Candidates to search from: all points in the face that are equally far from the three generators, and some points
  /// that are not.
  virtual std::vector<Bary> equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const = 0;
  /// Whether p is a branch point of the diagram, with the cells of a, b, c counter-clockwise round it. Such a point is
  /// never moved.
  virtual bool is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& p) const = 0;
  /// How far rounding may have moved a crossing along its edge, as a fraction of the edge. It is large if the two
  /// generators nearly coincide.
  virtual double crossing_error(const BoundaryCrossing& crossing) const = 0;
};

}  // namespace gvd
