#include "geodesic/windows/propagation/propagation_state.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Bucket width in mean edge lengths. Between 0.2 and 0.8 the time of one thread is the same. Narrow buckets let faces
/// settle earlier, so that fewer windows are in memory. Wide buckets put more work into a round, which threads share
/// better.
constexpr double kBucketWidth = 0.4;

/// The same for meshes with needles, where many vertices lie within one edge length of each other. Each vertex that is
/// taken too early sends windows in vain. With a hundredth of the width there are an eighth of them.
constexpr double kFineBucketWidth = 0.01;

/// Bound on the number of buckets of all partitions. Keys beyond it share the last bucket, which costs repeated events
/// but no exactness.
constexpr double kMaxBuckets = 1 << 16;

std::size_t count_buckets(const Mesh& mesh, double width, std::int32_t partitions) {
  double longest = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (const double length : mesh.shape(FaceId(f)).length) longest = std::max(longest, length);
  }
  // From a window to the next one, or to a vertex and its windows, the key rises by at most two edge lengths.
  return static_cast<std::size_t>(std::min(kMaxBuckets / partitions, 3 * longest / width + 3));
}

}  // namespace

PropagationState::PropagationState(const Mesh& of_mesh, const PropagationOptions& options,
                                   const ParallelChunks& parallel)
    : mesh(of_mesh),
      keep(options.keep),
      frames(mesh, parallel),
      angles(options.departures ? CornerAngles(mesh, frames, parallel) : CornerAngles()),
      partitions(mesh, options.partition_faces, frames),
      labels(partitions.copy_count(), options.departures),
      mailboxes(partitions.count()),
      bucket_width((frames.has_needles ? kFineBucketWidth : kBucketWidth) * mesh.mean_edge_length()),
      bucket_count(count_buckets(mesh, bucket_width, partitions.count())),
      first_waiting(static_cast<std::size_t>(mesh.halfedge_count()), -1),
      apex_path(frames.has_needles ? static_cast<std::size_t>(mesh.halfedge_count()) : 0),
      face_state(keep == KeepWindows::near_bisectors ? frames.frame.size() : 0, FaceState::open),
      last_sent(partitions.shared_count()) {}

}  // namespace gvd
