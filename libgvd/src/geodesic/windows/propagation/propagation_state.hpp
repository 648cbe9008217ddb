#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/propagation/face_crossing.hpp"
#include "geodesic/windows/propagation/mesh_partitions.hpp"
#include "geodesic/windows/propagation/partition_exchange.hpp"
#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_field.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// The state of a face's distances.
enum class FaceState : std::uint8_t {
  open,
  single_label,  ///< the distances are settled and have one label
  multi_label,   ///< the distances have, or at some time had, several labels
};

/// The data that the partitions of the mesh share. While they work, each partition uses only the items of its own faces
/// and vertex copies.
struct PropagationState {
  /// `before` are the numbers of elements before generators were inserted.
  PropagationState(const Mesh& of_mesh, const ElementCounts& before, const PropagationOptions& options,
                   const ParallelChunks& parallel);
  PropagationState(const Mesh& of_mesh, const PropagationOptions& options, const ParallelChunks& parallel)
      : PropagationState(of_mesh, {of_mesh.vertex_count(), of_mesh.face_count()}, options, parallel) {}

  /// Prepares another propagation on the same mesh, after one that has ended.
  void restart();
  /// The same on a mesh with other generators. `changed` are the faces that have changed: all split faces, and their
  /// neighbours. Cost: O(n) with small constants.
  void restart(const Mesh& changed_mesh, std::span<const FaceId> changed);
  /// Marks the edges of curves, to which no window may come.
  void mark_curves(const CurveEdges& curves);

  const Mesh* mesh;
  KeepWindows keep;
  StartDistances starts;
  FaceFrames frames;
  CornerAngles angles;  // empty unless departures are recorded
  MeshPartitions partitions;
  DistanceLabels labels;
  Mailboxes mailboxes;
  double bucket_width;  // bucket width of the partitions' queues
  std::size_t bucket_count;
  IdVector<HalfedgeId, std::int32_t> first_waiting;  // the array `first` of WaitingWindows
  IdVector<HalfedgeId, ApexPath> apex_path;          // across the halfedge; empty if there are no needles
  IdVector<FaceId, FaceState> face_state;            // empty unless windows near bisectors are kept
  IdVector<SharedCopyId, LastSent> last_sent;
  IdVector<HalfedgeId, std::uint8_t> on_curve;  // 1 for halfedges of a curve; empty if there are no curves
};

/// Propagates generators from their vertices on a prepared state. Distances that the state already has are upper
/// bounds. `parallel` must not report progress.
WindowField propagate_on(PropagationState& state, std::span<const std::pair<VertexId, GeneratorId>> generators,
                         const ParallelChunks& parallel, const Progress& progress);

}  // namespace gvd
