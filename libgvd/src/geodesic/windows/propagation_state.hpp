#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/face_frames.hpp"
#include "geodesic/windows/mesh_partitions.hpp"
#include "geodesic/windows/partition_messages.hpp"
#include "geodesic/windows/propagate_windows.hpp"
#include "geodesic/windows/window_field.hpp"
#include "geodesic/windows/window_filters.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// What is known of the distances in a face.
enum class FaceState : std::uint8_t {
  open,
  single_label,  ///< they are settled and have one label
  multi_label,   ///< they have several labels, or had so at some time
};

/// The path with which a vertex last sent windows.
struct SentPath {
  double distance = std::numeric_limits<double>::infinity();
  std::int32_t generator = -1;
};

/// What the parts of the mesh have in common. While they work, each one touches only what belongs to its faces and to
/// its places of vertices.
struct PropagationState {
  PropagationState(const Mesh& of_mesh, const PropagationOptions& options, const ParallelChunks& parallel);

  const Mesh& mesh;
  KeepWindows keep;
  FaceFrames frames;
  MeshPartitions parts;
  WindowField field;  // its arrays hold all places of vertices
  Mailboxes mail;
  double bucket_width;  // of the parts' queues
  std::size_t bucket_count;
  std::vector<std::int32_t> first_waiting;  // [halfedge] of WaitingWindows
  std::vector<ApexPath> apex_path;          // [halfedge that windows cross into the face]; where there are needles
  std::vector<FaceState> face_state;
  std::vector<SentPath> sent;  // [place of a shared vertex]
};

}  // namespace gvd
