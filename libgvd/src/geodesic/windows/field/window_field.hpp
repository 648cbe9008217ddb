#pragma once

#include <cstdint>

#include "geodesic/windows/field/edge_windows.hpp"
#include "geodesic/windows/geometry/corner_angles.hpp"
#include "geodesic/windows/geometry/face_frames.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// The result of window propagation: exact distances at the vertices, and windows on the edges.
struct WindowField {
  IdVector<VertexId, double> distance;      ///< mesh units; infinity where no generator reaches
  IdVector<VertexId, GeneratorId> label;    ///< the nearest generator; invalid where none reaches
  IdVector<VertexId, Departure> departure;  ///< of the shortest path, if departures are recorded
  IdVector<FaceId, FaceFrame> frame;        ///< of all faces, if departures are recorded
  CornerAngles angles;                      ///< of the working mesh, if departures are recorded
  EdgeWindows windows;
  std::int64_t carried = 0;  ///< number of windows that were carried across a face; the time is proportional to it
  std::int64_t events = 0;   ///< number of generators and pseudo-sources that sent windows
};

}  // namespace gvd
