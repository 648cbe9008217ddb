#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "geodesic/distance_field.hpp"

namespace gvd {

/// The distances of the generators along one edge: for each, the shortest path over all its sources.
class EdgeDistances {
 public:
  /// Takes over the sources of an edge. Cost: O(k log k) for k sources.
  void build(const std::vector<EdgeSource>& sources);

  /// Length of the shortest path of generator g to t; infinite where it has no source.
  /// Cost: O(log k + sources of g), most of them without a square root.
  double at(GeneratorId g, double t) const;

 private:
  std::vector<EdgeSource> sources_;  // ascending by generator
  std::vector<std::pair<GeneratorId, std::size_t>> order_;
};

}  // namespace gvd
