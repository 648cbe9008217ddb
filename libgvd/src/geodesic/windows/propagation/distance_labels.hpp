#pragma once

#include <cstddef>
#include <limits>

#include "geodesic/windows/geometry/departure.hpp"
#include "geodesic/windows/geometry/propagation_ids.hpp"
#include "geodesic/windows/geometry/window_filters.hpp"

namespace gvd {

/// The best path so far to each copy of a vertex: its length and its generator.
struct DistanceLabels {
  IdVector<VertexCopyId, double> distance;      ///< mesh units; infinity if there is no path yet
  IdVector<VertexCopyId, GeneratorId> label;    ///< invalid if there is no path yet, or provisional
  IdVector<VertexCopyId, Departure> departure;  ///< empty unless departures are recorded

  explicit DistanceLabels(std::size_t copies, bool with_departures = false)
      : distance(copies, std::numeric_limits<double>::infinity()),
        label(copies),
        departure(with_departures ? copies : 0) {}

  /// Whether a path of this length from this generator precedes the best one so far (is_before).
  bool is_improved_by(VertexCopyId v, double d, GeneratorId generator) const {
    return is_before(d, generator, distance[v], label[v]);
  }
  /// Whether a vertex copy has another label than this. One without a path takes the label provisionally: whoever gives
  /// it a path later sees whether the label changes.
  bool has_other_label(VertexCopyId v, GeneratorId generator) {
    GeneratorId& known = label[v];
    if (!known.valid()) known = generator;
    return known != generator;
  }
};

}  // namespace gvd
