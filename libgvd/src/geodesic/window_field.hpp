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
  IdVector<VertexId, double> distance;     ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, std::int32_t> label;  ///< GeneratorId of the nearest generator, or -1
  EdgeWindows windows;
  std::int64_t window_count = 0;  ///< windows that were carried across a face
  std::int64_t created_count = 0;

  explicit WindowField(const Mesh& mesh)
      : frames(mesh),
        distance(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity()),
        label(static_cast<std::size_t>(mesh.vertex_count()), -1) {}
};

}  // namespace gvd
