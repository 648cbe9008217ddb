#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>

#include "geodesic/marching/local_march.hpp"
#include "gvd/front.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Distance of every vertex from the nearest of the generators inserted so far.
///
/// An insertion updates only the vertices that are nearest to the new generator, so N insertions cost about
/// O(n log n log N) in all.
class NearestField {
 public:
  NearestField(const Mesh& mesh, Front front, const Progress& progress = {})
      : march_(mesh, front, progress), distance_(mesh.vertex_count(), kInfinity) {}

  /// Adds the next generator. Cost: O(k log k) for the k vertices that are nearest to it.
  void insert(const SurfacePoint& point) {
    march_.run(point, kInfinity, &distance_);
    for (const PlaceId p : march_.reached()) distance_[p] = std::min(distance_[p], march_.distance(p));
  }

  /// See LocalMarch::watch_runs.
  void watch_insertions(std::function<void(std::size_t reached)> watch) { march_.watch_runs(std::move(watch)); }

  const MarchFans& fans() const { return march_.fans(); }
  /// Mesh units; infinity where no generator reaches.
  double distance(PlaceId p) const { return distance_[p]; }
  double distance(VertexId v) const { return distance_[fans().place(v)]; }

 private:
  LocalMarch march_;
  IdVector<PlaceId, double> distance_;
};

}  // namespace gvd
