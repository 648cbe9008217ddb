#pragma once

#include <cstddef>
#include <cstdint>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/propagation/face_crossing.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// Knowledge of the distances in a face.
enum class FaceState : std::uint8_t {
  open,
  single_label,  ///< they are settled and have one label
  multi_label,   ///< they have several labels, or had so at some time
};

/// The data that the partitions of the mesh share. While they work, each one uses only the items of its own faces and
/// vertex copies.
struct PropagationState {
  PropagationState(const Mesh& of_mesh, const PropagationOptions& options, const ParallelChunks& parallel);

  const Mesh& mesh;
  KeepWindows keep;
  StartDistances starts;
  FaceFrames frames;
  CornerAngles angles;  // empty unless departures are recorded
  MeshPartitions partitions;
  DistanceLabels labels;
  Mailboxes mailboxes;
  double bucket_width;  // of the partitions' queues
  std::size_t bucket_count;
  IdVector<HalfedgeId, std::int32_t> first_waiting;  // of WaitingWindows
  IdVector<HalfedgeId, ApexPath> apex_path;          // across the halfedge; empty if there are no needles
  IdVector<FaceId, FaceState> face_state;            // empty unless windows near bisectors are kept
  IdVector<SharedCopyId, LastSent> last_sent;
  IdVector<HalfedgeId, std::uint8_t> on_curve;  // 1 for those of a curve; empty if there is none
};

}  // namespace gvd
