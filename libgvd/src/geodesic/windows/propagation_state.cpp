#include "geodesic/windows/propagation_state.hpp"

#include <algorithm>

namespace gvd {
namespace {

/// Bucket width in mean edge lengths. Between 0.2 and 0.8 the time of one thread is the same. Narrow ones let faces
/// settle earlier, so that fewer windows are in memory; wide ones leave more work to a round, which threads share
/// better.
constexpr double kBucketWidth = 0.4;

/// The same where there are needles: they bring many vertices within one edge's length of each other, and each one that
/// is taken out of its turn sends windows that are in vain. With a hundredth of the width they are an eighth.
constexpr double kFineBucketWidth = 0.01;

/// Bound on the number of buckets in all parts: beyond it keys share the last one, which costs repeated events, not
/// exactness.
constexpr double kMaxBuckets = 1 << 16;

std::size_t count_buckets(const Mesh& mesh, double width, std::int32_t parts) {
  double longest = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    for (const double length : mesh.shape(FaceId(f)).length) longest = std::max(longest, length);
  }
  // From a window to the one that it becomes, or to a vertex and its windows, the key rises by two edges at the most.
  return static_cast<std::size_t>(std::min(kMaxBuckets / parts, 3 * longest / width + 3));
}

}  // namespace

PropagationState::PropagationState(const Mesh& of_mesh, const PropagationOptions& options,
                                   const ParallelChunks& parallel)
    : mesh(of_mesh),
      keep(options.keep),
      frames(mesh, parallel),
      parts(mesh, options.partition_faces, frames),
      field(parts.place_count()),
      mail(parts.count()),
      bucket_width((frames.has_needles ? kFineBucketWidth : kBucketWidth) * mesh.mean_edge_length()),
      bucket_count(count_buckets(mesh, bucket_width, parts.count())),
      first_waiting(static_cast<std::size_t>(mesh.halfedge_count()), -1),
      apex_path(frames.has_needles ? static_cast<std::size_t>(mesh.halfedge_count()) : 0),
      face_state(keep == KeepWindows::near_bisectors ? frames.frame.size() : 0, FaceState::open),
      sent(parts.shared_count()) {}

}  // namespace gvd
