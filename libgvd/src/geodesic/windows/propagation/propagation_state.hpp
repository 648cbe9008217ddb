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

/// Knowledge of the distances in a face.
enum class FaceState : std::uint8_t {
  open,
  single_label,  ///< they are settled and have one label
  multi_label,   ///< they have several labels, or had so at some time
};

/// The data that the partitions of the mesh share. While they work, each one uses only the items of its own faces and
/// vertex copies.
struct PropagationState {
  /// `before`: the elements that were there before generators were inserted.
  PropagationState(const Mesh& of_mesh, const ElementCounts& before, const PropagationOptions& options,
                   const ParallelChunks& parallel);
  PropagationState(const Mesh& of_mesh, const PropagationOptions& options, const ParallelChunks& parallel)
      : PropagationState(of_mesh, {of_mesh.vertex_count(), of_mesh.face_count()}, options, parallel) {}

  /// Prepares another propagation on the same mesh, after one that has ended.
  void restart();
  /// The same on a mesh with other generators, in which these faces, with all that are split, and their neighbours have
  /// changed. Cost: O(n) with small constants.
  void restart(const Mesh& changed_mesh, std::span<const FaceId> changed);
  /// Lets no window come to the edges of curves.
  void mark_curves(const CurveEdges& curves);

  const Mesh* mesh;
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

/// Propagates generators from their vertices on a prepared state. Distances that it has already are bounds.
/// `parallel` reports no progress.
WindowField propagate_on(PropagationState& state, std::span<const std::pair<VertexId, GeneratorId>> generators,
                         const ParallelChunks& parallel, const Progress& progress);

}  // namespace gvd
