// Exact distances from the nearest generator, by windows that several threads propagate.
//
// Idea: the mesh is cut into partitions, each with a queue of its own. Generators start in the partitions of their
// vertices. All partitions work in rounds until nothing waits. Then their windows are sorted by face, and the distances
// of the vertices are read off.
// Source: Chen and Han (1990), with the filters of Xin and Wang (2009), for many generators at once.
// Invariant: the distance of a vertex copy is always the length of a path, and only falls, up to rounding.
#include "geodesic/windows/propagation/propagate_windows.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "geodesic/windows/propagation/curve_sectors.hpp"
#include "geodesic/windows/propagation/partition_propagator.hpp"
#include "geodesic/windows/propagation/propagation_rounds.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"

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
  // From a window to the next one, or to a vertex and its windows, the key rises by at most two edge lengths.
  return static_cast<std::size_t>(std::min(kMaxBuckets / partitions, 3 * longest_edge(mesh) / width + 3));
}

/// Keys are floats: the propagation goes on to this fraction beyond the largest distance, so that none is missed.
constexpr double kKeyRounding = 1e-6;

/// The propagation in all partitions.
class Propagation {
 public:
  Propagation(const Mesh& mesh, const PropagationOptions& options, const CurveEdges& curves, const Progress& progress)
      : progress_(progress),
        max_distance_(options.max_distance),
        parallel_(options.threads, silent_),
        state_(mesh, options, parallel_) {
    if (!curves.empty()) state_.on_curve.assign(mesh.halfedge_count(), 0);
    for (const HalfedgeId h : curves.edges) {
      state_.on_curve[h] = 1;
      if (const HalfedgeId twin = mesh.twin(h); twin.valid()) state_.on_curve[twin] = 1;
    }
    for (std::int32_t i = 0; i < state_.partitions.count(); ++i) {
      partitions_.push_back(std::make_unique<PartitionPropagator>(state_, PartitionId(i)));
    }
  }

  void start(VertexId v, GeneratorId g, double d) {
    for_each_copy(v, [&](PartitionPropagator& partition, VertexCopyId copy) { partition.start_vertex(copy, g, d); });
  }

  /// All vertices before the first window: their distances are known when windows meet them. Then the vertices send
  /// windows before the segments do, in ascending order: what waits at the start is the same for any partitions.
  void start(const CurveEdges& curves) {
    for (const auto& [v, generator] : curves.vertices) {
      for_each_copy(v, [&, g = generator](PartitionPropagator& partition, VertexCopyId copy) {
        partition.start_curve_vertex(copy, g);
      });
    }
    const CurveSectors sectors(state_.mesh, state_.frames, curves);
    for (const auto& [v, generator] : curves.vertices) {
      const std::vector<CurveSector> at_vertex = sectors.at(v);
      for_each_copy(
          v, [&](PartitionPropagator& partition, VertexCopyId copy) { partition.send_from_curve(copy, at_vertex); });
    }
    for (const HalfedgeId h : curves.edges) {
      for (const HalfedgeId side : {h, state_.mesh.twin(h)}) {
        if (side.valid()) propagator(state_.partitions.of_halfedge(side)).send_from_segment(side);
      }
    }
  }

  WindowField run() {
    PropagationRounds<PartitionPropagator>(partitions_, state_.mailboxes, state_.bucket_width, parallel_)
        .run(max_distance_ * (1 + kKeyRounding), [&] { report(); });
    WindowField field;
    for (const auto& partition : partitions_) {
      field.carried += partition->carried();
      field.events += partition->events();
    }
    field.windows = collect_windows();
    take_labels(field);
    return field;
  }

 private:
  PartitionPropagator& propagator(PartitionId i) { return *partitions_[i.index()]; }

  /// Calls visit(PartitionPropagator&, VertexCopyId) for all copies of a vertex.
  template <class Visit>
  void for_each_copy(VertexId v, Visit visit) {
    const MeshPartitions& partitions = state_.partitions;
    const SharedCopyId shared = partitions.shared(first_copy(v));
    if (!shared.valid()) return visit(propagator(partitions.of_halfedge(state_.mesh.halfedge(v))), first_copy(v));
    for (const MeshPartitions::VertexCopy& copy : partitions.copies(shared)) {
      visit(propagator(copy.partition), copy.vertex);
    }
  }

  /// Reports once every kProgressStride windows: there can be many short rounds.
  void report() {
    std::int64_t carried = 0;
    for (const auto& partition : partitions_) carried += partition->carried();
    if (carried < next_report_) return;
    next_report_ = carried + kProgressStride;
    const double share = double(carried) / (10.0 * state_.mesh.face_count());
    report_progress(progress_, steps::kDistances, share / (1 + share));
  }

  EdgeWindows collect_windows() {
    std::vector<KeptWindows> kept(partitions_.size());
    parallel_.run(partitions_.size(), {steps::kDistances}, [&](std::size_t i) { kept[i] = partitions_[i]->finish(); });
    return EdgeWindows(std::move(kept), state_.frames.frame.size(), parallel_);
  }

  /// Takes the distances and labels of the vertices: those of their first copies. Labels of vertices without a path
  /// are provisional.
  void take_labels(WindowField& field) {
    field.distance = IdVector<VertexId, double>(std::move(state_.labels.distance.raw()));
    field.label = IdVector<VertexId, GeneratorId>(std::move(state_.labels.label.raw()));
    field.departure = IdVector<VertexId, Departure>(std::move(state_.labels.departure.raw()));
    field.distance.resize(state_.mesh.vertex_count());
    field.label.resize(field.distance.size());
    for (const VertexId v : state_.mesh.vertices()) {
      if (field.distance[v] > max_distance_) field.distance[v] = kInfinity;
      if (std::isinf(field.distance[v])) field.label[v] = GeneratorId();
    }
    if (field.departure.empty()) return;
    field.departure.resize(field.distance.size());
    field.frame = IdVector<FaceId, FaceFrame>(std::move(state_.frames.frame.raw()));
    field.angles = std::move(state_.angles);
    field.starts = std::move(state_.starts);
  }

  static constexpr std::int64_t kProgressStride = 1 << 14;

  const Progress& progress_;
  const double max_distance_;
  const Progress silent_;
  const ParallelChunks parallel_;
  PropagationState state_;
  std::vector<std::unique_ptr<PartitionPropagator>> partitions_;
  std::int64_t next_report_ = kProgressStride;
};

}  // namespace

PropagationState::PropagationState(const Mesh& of_mesh, const PropagationOptions& options,
                                   const ParallelChunks& parallel)
    : mesh(of_mesh),
      keep(options.keep),
      starts{options.offsets},
      frames(mesh, parallel),
      angles(options.departures ? CornerAngles(mesh, frames, parallel) : CornerAngles()),
      partitions(mesh, options.partition_faces, frames),
      labels(partitions.copy_count(), options.departures),
      mailboxes(partitions.count()),
      bucket_width((frames.has_needles ? kFineBucketWidth : kBucketWidth) * mesh.mean_edge_length()),
      bucket_count(count_buckets(mesh, bucket_width, partitions.count())),
      first_waiting(mesh.halfedge_count(), -1),
      apex_path(frames.has_needles ? mesh.halfedge_count() : 0),
      face_state(keep == KeepWindows::near_bisectors ? frames.frame.size() : 0, FaceState::open),
      last_sent(partitions.shared_count()) {}

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress) {
  report_progress(progress, steps::kDistances, 0);
  Propagation propagation(mesh, options, {}, progress);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    propagation.start(generators[g], GeneratorId(g), options.offsets.empty() ? 0 : options.offsets[g]);
  }
  return propagation.run();
}

WindowField propagate_windows(const WorkingMesh& working, const PropagationOptions& options, const Progress& progress) {
  const CurveEdges& curves = working.curves();
  if (curves.empty()) return propagate_windows(working.mesh(), working.generator_vertices().raw(), options, progress);
  if (!options.offsets.empty() || options.departures) {
    throw Error(ErrorCode::invalid_option, "curves have neither offsets nor directions of departure");
  }
  report_progress(progress, steps::kDistances, 0);
  Propagation propagation(working.mesh(), options, curves, progress);
  propagation.start(curves);
  IdVector<GeneratorId, bool> is_curve(working.generator_vertices().size(), false);
  for (const auto& [v, g] : curves.vertices) is_curve.raw()[g.index()] = true;
  for (const GeneratorId g : working.generator_vertices().ids()) {
    if (!is_curve.raw()[g.index()]) propagation.start(working.vertex(g), g, 0);
  }
  return propagation.run();
}

}  // namespace gvd
