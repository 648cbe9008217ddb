#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>

#include "geodesic/windows/edge_windows.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// What window propagation leaves: exact distances at the vertices, and windows on the edges.
struct WindowField {
  IdVector<VertexId, double> distance;    ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, GeneratorId> label;  ///< the nearest generator; invalid where none reaches
  EdgeWindows windows;
  std::int64_t carried = 0;  ///< windows that were carried across a face: what the time goes with
  std::int64_t events = 0;   ///< generators and pseudo-sources that sent windows

  /// Nothing is reached yet.
  explicit WindowField(std::size_t vertices)
      : distance(vertices, std::numeric_limits<double>::infinity()), label(vertices) {}
};

}  // namespace gvd
