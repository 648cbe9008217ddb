#pragma once

#include <cstdint>
#include <limits>

#include "geodesic/edge_windows.hpp"
#include "geodesic/face_frames.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// What window propagation leaves: exact distances at the vertices, and windows on the edges.
struct WindowField {
  FaceFrames frames;
  IdVector<VertexId, double> distance;    ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, GeneratorId> label;  ///< the nearest generator; invalid where none reaches
  EdgeWindows windows;
  std::int64_t carried = 0;  ///< windows that were carried across a face: what the time goes with
  std::int64_t events = 0;   ///< generators and pseudo-sources that sent windows

  WindowField(const Mesh& mesh, const ParallelChunks& parallel)
      : frames(mesh, parallel),
        distance(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity()),
        label(static_cast<std::size_t>(mesh.vertex_count())) {}
};

}  // namespace gvd
