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
  VertexSlope(double total, bool is_closed, std::vector<DepartingPath> paths);

  /// Derivative of the energy along a step in a direction, radians as in DepartingPath; mesh units cubed. Cost: O(log
  /// p).
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

/// Marks the generators at vertices, and those beside an inner saddle vertex, within `reach` of it.
WatchedGenerators watch_generators(const Mesh& mesh, const std::vector<SurfacePoint>& generators, double reach);

/// The way in which the energy falls fastest from a generator at a vertex: a tangent vector, of which -2 mass times the
/// length is the slope. Zero where the energy falls in no direction.
/// `paths`: to the points of the generator's cell. Where the vertex is flat, the mean of the log map, `mean`, is the
/// way.
Vec2 steepest_way(const Mesh& mesh, const SurfacePoint& vertex, std::span<const PathSample> paths, double mass,
                  const Vec2& mean);

/// The inner saddle vertex within `reach` that lies on the generator's way, less than 90 degrees off, and where its
/// paths would let it rest: a saddle that holds a generator draws it from all sides. The paths are taken for those from
/// the vertex. The ones that bend there spread evenly over the angle that the vertex has in excess of 360 degrees. For
/// short distances that is nearly so. What holds at the vertex is found out there.
std::optional<VertexId> find_rest(const Mesh& mesh, const SurfacePoint& generator, const Vec2& way, double reach,
                                  std::span<const PathSample> paths);

/// The vertices at which generators would rest, one for each generator that would (see find_rest).
using Rests = std::vector<std::optional<VertexId>>;

}  // namespace gvd
