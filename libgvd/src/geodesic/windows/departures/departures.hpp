#pragma once

#include <vector>

#include "base/plane.hpp"
#include "geodesic/windows/geometry/departure.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Turns departures, which count angles on the working mesh, into tangent vectors of the input mesh at the generators
/// (see geodesic_tracing.hpp).
class Departures {
 public:
  /// `generators`: of the working mesh, in the input. Cost: O(generators).
  Departures(const WorkingMesh& working, const std::vector<SurfacePoint>& generators);

  /// The tangent direction of generator g, a unit vector, in which a path departs.
  Vec2 direction(GeneratorId g, Departure departure) const {
    const Plane& plane = planes_[g];
    return unit_vector(plane.start + plane.scale * (plane.scale == 1 ? departure.turned() : departure.angle()));
  }
  /// Whether tangent angles are angles on the surface. They are scaled at vertices with curvature.
  bool is_flat(GeneratorId g) const { return planes_[g].scale == 1; }

 private:
  struct Plane {
    double start;  // tangent angle of the first side at the generator, radians
    double scale;  // ratio of tangent angles to angles on the surface
  };
  IdVector<GeneratorId, Plane> planes_;
};

}  // namespace gvd
