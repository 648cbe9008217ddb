#pragma once

#include <optional>
#include <span>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "window_integrals.hpp"

namespace gvd {

/// A path that leaves a vertex.
struct DepartingPath {
  double angle;   ///< on the surface, in [0, total angle of the vertex), radians
  double weight;  ///< distance times mass
};

/// The slope of the energy at a generator on a vertex, in every direction.
///
/// A short step of a generator in direction u shortens a path that departs in direction t by cos(u, t) times the step.
/// A path that departs at more than 180 degrees from u bends around the vertex, so the whole step lengthens it. So the
/// slope is -2 times the integral of density times distance times the cosine of this angle, limited to 180 degrees. At
/// a flat vertex that is the scalar product with the gradient. If the total angle is larger, the slope can be positive
/// in all directions, and the energy has a minimum with a kink.
/// Source: the first variation of length; see docs/developer/lloyd.md.
class VertexSlope {
 public:
  /// `total`: the angle of the faces around the vertex, radians, > 0. `is_closed`: whether the faces surround the
  /// vertex.
  /// Cost: O(p log p) for p paths.
  VertexSlope(double total, bool is_closed, std::vector<DepartingPath> paths);

  /// The derivative of the energy along a step in a direction, given in radians as in DepartingPath; mesh units cubed.
  /// Cost: O(log p).
  double at(double angle) const;
  /// The direction of the least slope, and the slope.
  struct Least {
    double angle, slope;
  };
  /// Finds the least slope by evaluating 64 directions and a golden-section search around the best one. Cost: O(log p).
  Least least() const;

 private:
  /// The sum of the paths' unit vectors times their weights, and the sum of the weights.
  struct Sum {
    Vec2 vector = Vec2::Zero();
    double weight = 0;
  };
  Sum between(double begin, double end) const;

  double total_;
  bool is_closed_;
  std::vector<double> angles_;  // ascending
  std::vector<Sum> sums_;       // sums over the first 0, 1, 2 ... paths
};

/// Marks the generators at vertices, and the generators within `reach` of an inner saddle vertex.
WatchedGenerators watch_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double reach);

/// The direction in which the energy falls fastest from a generator at a vertex: a tangent vector such that -2 mass
/// times its length is the slope. Zero if the energy falls in no direction. `paths`: the paths to the points of the
/// generator's cell. At a flat vertex, the result is `mean`, the mean of the log map.
Vec2 steepest_way(const Mesh& mesh, const SurfacePoint& vertex, std::span<const PathSample> paths, double mass,
                  const Vec2& mean);

/// Finds the inner saddle vertex within `reach` in the direction of the generator's way (less than 90 degrees off)
/// where its paths would let the generator rest. A saddle that holds a generator attracts it from all sides. The
/// generator's paths serve as an estimate of the paths from the vertex, and the paths that bend there are spread evenly
/// over the excess of its angle over 360 degrees, which is nearly true for short distances. Whether the generator does
/// rest is decided at the vertex.
std::optional<VertexId> find_rest(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way, double reach,
                                  std::span<const PathSample> paths);

/// For each generator, the vertex at which it would rest, if any (see `find_rest`).
using Rests = std::vector<std::optional<VertexId>>;

}  // namespace gvd
