#pragma once

#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// A path that leaves a vertex.
struct VertexPath {
  double angle;   ///< on the surface, in [0, total angle of the vertex), radians
  double weight;  ///< distance times mass
};

/// The slope of the energy at a generator on a vertex, in every direction.
///
/// A short step of a generator in direction u shortens a path that departs in direction t by cos(u, t) of the step. A
/// path that departs at more than 180 degrees from u bends round the vertex: the whole step lengthens it. So
/// the slope is -2 times the integral of density times distance times the cosine of the lesser of that angle and 180
/// degrees. Where the vertex is flat that is the scalar product with the gradient. Where the total angle is larger, the
/// slope can be positive in all directions: the energy has a minimum with a kink.
/// Source: the first variation of length; see docs/developer/lloyd.md.
class VertexSlope {
 public:
  /// `total`: angle of the faces round the vertex, radians, > 0. `is_closed`: whether they lie all round it.
  /// Cost: O(p log p) for p paths.
  VertexSlope(double total, bool is_closed, std::vector<VertexPath> paths);

  /// Derivative of the energy along a step in a direction, radians as in VertexPath; mesh units cubed. Cost: O(log p).
  double at(double angle) const;
  /// The direction of the least slope, and that slope.
  struct Least {
    double angle, slope;
  };
  /// By a search in 64 directions, and a golden-section search round the best one. Cost: O(log p).
  Least least() const;

 private:
  /// Sum of the paths' unit vectors, times their weights, at angles from `begin` to `end`; and of the weights.
  struct Sum {
    Vec2 vector = Vec2::Zero();
    double weight = 0;
  };
  Sum between(double begin, double end) const;

  double total_;
  bool is_closed_;
  std::vector<double> angles_;  // ascending
  std::vector<Sum> sums_;       // of the first 0, 1, 2 ... paths
};

}  // namespace gvd
