// Exact distances from the nearest generator. Several threads propagate the windows.
//
// Idea: the mesh is cut into partitions, each of which has its own queue. Generators start in the partitions of their
// vertices. All partitions work in rounds until nothing waits in any queue. Then their windows are sorted by face, and
// the distances of the vertices are taken from the labels.
// Source: Chen and Han (1990), with the filters of Xin and Wang (2009), for many generators at once.
// Invariant: the distance of a vertex copy is always the length of a path, and only falls, up to rounding.
#include "geodesic/windows/propagation/propagate_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "geodesic/windows/propagation/propagation.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// Width of a bucket in mean edge lengths. Between 0.2 and 0.8, one thread takes the same time. With narrow buckets,
/// faces settle earlier, so that fewer windows are in memory. With wide buckets, a round has more work, which threads
/// share better.
constexpr double kBucketWidth = 0.4;

/// The same for meshes with needles, where many vertices lie within one edge length of each other. A vertex that is
/// taken too early sends windows in vain. With a hundredth of the width, there are an eighth as many such windows.
constexpr double kFineBucketWidth = 0.01;

/// Largest number of buckets of all partitions together. Larger keys share the last bucket, which costs repeated events
/// but no exactness.
constexpr double kMaxBuckets = 1 << 16;

std::size_t count_buckets(const FaceFrames& frames, double width, std::int32_t partitions) {
  double longest = 0;
  for (const FaceFrame& f : frames.frame) longest = std::max({longest, f.length[0], f.length[1], f.length[2]});
  // From a window to the next one, or to a vertex and its windows, the key rises by at most two edge lengths.
  return static_cast<std::size_t>(std::min(kMaxBuckets / partitions, 3 * longest / width + 3));
}

WindowField propagate_from_points(const Mesh& mesh, const ElementCounts& before,
                                  const std::vector<VertexId>& generators, const PropagationOptions& options,
                                  const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  const Progress silent;
  const ParallelChunks parallel(options.threads, silent);
  PropagationState state(mesh, before, options, parallel);
  Propagation<NoRecorder> propagation(state, parallel, options.max_distance, progress);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    propagation.start(generators[g], GeneratorId(g), options.offsets.empty() ? 0 : options.offsets[g]);
  }
  return propagation.run();
}

}  // namespace

PropagationState::PropagationState(const Mesh& of_mesh, const ElementCounts& before, const PropagationOptions& options,
                                   const ParallelChunks& parallel)
    : mesh(&of_mesh),
      keep(options.keep),
      starts{options.offsets},
      frames(of_mesh, parallel),
      angles(options.departures ? CornerAngles(of_mesh, frames, parallel) : CornerAngles()),
      partitions(of_mesh, before, options.partition_faces, frames),
      labels(partitions.copy_count(), options.departures),
      mailboxes(partitions.count()),
      bucket_width((frames.has_needles ? kFineBucketWidth : kBucketWidth) * of_mesh.mean_edge_length()),
      bucket_count(count_buckets(frames, bucket_width, partitions.count())),
      first_waiting(of_mesh.halfedge_count(), -1),
      apex_path(frames.has_needles ? of_mesh.halfedge_count() : 0),
      face_state(keep == KeepWindows::near_bisectors ? frames.frame.size() : 0, FaceState::open),
      last_sent(partitions.shared_count()) {}

void PropagationState::restart() {
  labels = DistanceLabels(partitions.copy_count(), !labels.departure.empty());
  std::ranges::fill(apex_path.raw(), ApexPath());
  std::ranges::fill(face_state.raw(), FaceState::open);
  last_sent.assign(partitions.shared_count(), LastSent());
}

void PropagationState::restart(const Mesh& changed_mesh, std::span<const FaceId> changed) {
  mesh = &changed_mesh;
  frames.update(*mesh, changed);
  partitions.update(*mesh, frames);
  first_waiting.resize(mesh->halfedge_count(), -1);
  if (frames.has_needles) apex_path.resize(mesh->halfedge_count());
  face_state.resize(mesh->face_count());
  bucket_count = count_buckets(frames, bucket_width, partitions.count());
  restart();
}

void PropagationState::mark_curves(const CurveEdges& curves) {
  on_curve.assign(mesh->halfedge_count(), 0);
  for (const HalfedgeId h : curves.edges) {
    on_curve[h] = 1;
    if (const HalfedgeId twin = mesh->twin(h); twin.valid()) on_curve[twin] = 1;
  }
}

WindowField propagate_on(PropagationState& state, std::span<const std::pair<VertexId, GeneratorId>> generators,
                         const ParallelChunks& parallel, const Progress& progress) {
  Propagation<NoRecorder> propagation(state, parallel, kInfinity, progress);
  for (const auto& [v, g] : generators) propagation.start(v, g, 0);
  return propagation.run();
}

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress) {
  return propagate_from_points(mesh, {mesh.vertex_count(), mesh.face_count()}, generators, options, progress);
}

WindowField propagate_windows(const WorkingMesh& working, const PropagationOptions& options, const Progress& progress) {
  const CurveEdges& curves = working.curves();
  const ElementCounts before{working.input().vertex_count(), working.input().face_count()};
  if (curves.empty()) {
    return propagate_from_points(working.mesh(), before, working.generator_vertices().raw(), options, progress);
  }
  if (!options.offsets.empty() || options.departures) {
    throw Error(ErrorCode::invalid_option, "curves take no offsets and no directions of departure; leave them out");
  }
  report_progress(progress, steps::kDistances, 0);
  const Progress silent;
  const ParallelChunks parallel(options.threads, silent);
  PropagationState state(working.mesh(), before, options, parallel);
  state.mark_curves(curves);
  Propagation<NoRecorder> propagation(state, parallel, options.max_distance, progress);
  propagation.start(curves);
  IdVector<GeneratorId, bool> is_curve(working.generator_vertices().size(), false);
  for (const auto& [v, g] : curves.vertices) is_curve.raw()[g.index()] = true;
  for (const GeneratorId g : working.generator_vertices().ids()) {
    if (!is_curve.raw()[g.index()]) propagation.start(working.vertex(g), g, 0);
  }
  return propagation.run();
}

}  // namespace gvd
