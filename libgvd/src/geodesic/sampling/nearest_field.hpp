#pragma once

#include <functional>
#include <limits>
#include <utility>

#include "geodesic/marching/local_march.hpp"

namespace gvd {

/// The nearest of the generators inserted so far, at every vertex.
///
/// An insertion updates only the vertices that are nearest to the new generator, so N insertions cost about
/// O(n log n log N) in all. Of two generators at the same distance the earlier one is kept.
class NearestField {
 public:
  NearestField(const Mesh& mesh, Front front)
      : march_(mesh, front),
        distance_(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity()),
        label_(static_cast<std::size_t>(mesh.vertex_count())) {}

  /// Adds the next generator. Cost: O(k log k) for the k vertices that are nearest to it.
  GeneratorId insert(const SurfacePoint& point) {
    const GeneratorId g(count_++);
    march_.run(point, std::numeric_limits<double>::infinity(), &distance_);
    for (const VertexId v : march_.reached()) {
      const double d = march_.distance(v);
      if (!(d < distance_[v])) continue;
      distance_[v] = d;
      label_[v] = g;
    }
    return g;
  }

  /// See LocalMarch::watch_runs.
  void watch_insertions(std::function<void(std::size_t reached)> watch) { march_.watch_runs(std::move(watch)); }

  /// Mesh units; infinity where no generator reaches.
  double distance(VertexId v) const { return distance_[v]; }
  /// Invalid where no generator reaches.
  GeneratorId label(VertexId v) const { return label_[v]; }

 private:
  LocalMarch march_;
  IdVector<VertexId, double> distance_;
  IdVector<VertexId, GeneratorId> label_;
  std::int32_t count_ = 0;
};

}  // namespace gvd
