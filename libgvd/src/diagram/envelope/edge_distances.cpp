#include "diagram/envelope/edge_distances.hpp"

#include <algorithm>
#include <limits>

namespace gvd {

void EdgeDistances::build(const std::vector<EdgeSource>& sources) {
  // Pairs of numbers are sorted several times faster than sources.
  order_.clear();
  for (const EdgeSource& s : sources) order_.emplace_back(s.generator, order_.size());
  std::sort(order_.begin(), order_.end());
  sources_.clear();
  for (const auto& [generator, i] : order_) sources_.push_back(sources[i]);
}

double EdgeDistances::at(GeneratorId g, double t) const {
  auto source =
      std::partition_point(sources_.begin(), sources_.end(), [g](const EdgeSource& s) { return s.generator < g; });
  double least = std::numeric_limits<double>::infinity();
  for (; source != sources_.end() && source->generator == g; ++source) {
    // No path of a source is shorter than the straight one. This test costs no square root.
    const double rest = least - source->offset, along = t - source->x;
    if (rest > 0 && along * along + source->depth * source->depth < rest * rest) {
      least = std::min(least, source->distance(t));
    }
  }
  return least;
}

}  // namespace gvd
