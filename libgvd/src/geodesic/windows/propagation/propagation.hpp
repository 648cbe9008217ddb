#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/parallel_chunks.hpp"
#include "geodesic/windows/propagation/curve_sectors.hpp"
#include "geodesic/windows/propagation/partition_propagator.hpp"
#include "geodesic/windows/propagation/propagation_rounds.hpp"
#include "geodesic/windows/propagation/propagation_state.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/progress.hpp"

namespace gvd {

/// Because keys are floats, the propagation continues beyond the largest distance by this fraction of it, so that no
/// distance is missed.
inline constexpr double kKeyRounding = 1e-6;

/// One propagation in all partitions, on the state of its mesh.
template <class Recorder>
class Propagation {
 public:
  using Partition = RecordedPartition<Recorder>;

  /// All arguments must outlive this object. `parallel` must not report progress.
  Propagation(PropagationState& state, const ParallelChunks& parallel, double max_distance, const Progress& progress,
              Recorder recorder = {})
      : progress_(progress), max_distance_(max_distance), parallel_(parallel), state_(state) {
    for (std::int32_t i = 0; i < state_.partitions.count(); ++i) {
      partitions_.push_back(std::make_unique<Partition>(state_, PartitionId(i), recorder));
    }
  }

  void start(VertexId v, GeneratorId g, double d) {
    for_each_copy(v, [&](Partition& partition, VertexCopyId copy) { partition.start_vertex(copy, g, d); });
  }

  /// Starts curves. All vertices of curves get their distances before the first window, so that windows that meet them
  /// find these distances. Then first the vertices and after them the segments send windows, in ascending order, so
  /// that the same windows wait at the start for any partitions.
  void start(const CurveEdges& curves) {
    for (const auto& [v, generator] : curves.vertices) {
      for_each_copy(
          v, [&, g = generator](Partition& partition, VertexCopyId copy) { partition.start_curve_vertex(copy, g); });
    }
    const CurveSectors sectors(*state_.mesh, state_.frames, curves);
    for (const auto& [v, generator] : curves.vertices) {
      const std::vector<CurveSector> at_vertex = sectors.at(v);
      for_each_copy(v, [&](Partition& partition, VertexCopyId copy) { partition.send_from_curve(copy, at_vertex); });
    }
    for (const HalfedgeId h : curves.edges) {
      for (const HalfedgeId side : {h, state_.mesh->twin(h)}) {
        if (side.valid()) propagator(state_.partitions.of_halfedge(side)).send_from_segment(side);
      }
    }
  }

  WindowField run() {
    PropagationRounds<Partition>(partitions_, state_.mailboxes, state_.bucket_width, parallel_)
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
  Partition& propagator(PartitionId i) { return *partitions_[i.index()]; }

  /// Calls visit(Partition&, VertexCopyId) for all copies of a vertex.
  template <class Visit>
  void for_each_copy(VertexId v, Visit visit) {
    const MeshPartitions& partitions = state_.partitions;
    const SharedCopyId shared = partitions.shared(first_copy(v));
    if (!shared.valid()) return visit(propagator(partitions.of_halfedge(state_.mesh->halfedge(v))), first_copy(v));
    for (const MeshPartitions::VertexCopy& copy : partitions.copies(shared)) {
      visit(propagator(copy.partition), copy.vertex);
    }
  }

  /// Reports once per kProgressStride windows, because there can be many short rounds.
  void report() {
    std::int64_t carried = 0;
    for (const auto& partition : partitions_) carried += partition->carried();
    if (carried < next_report_) return;
    next_report_ = carried + kProgressStride;
    const double share = double(carried) / (10.0 * state_.mesh->face_count());
    report_progress(progress_, steps::kDistances, share / (1 + share));
  }

  EdgeWindows collect_windows() {
    std::vector<KeptWindows> kept(partitions_.size());
    parallel_.run(partitions_.size(), {steps::kDistances}, [&](std::size_t i) { kept[i] = partitions_[i]->finish(); });
    EdgeWindows windows(std::move(kept), state_.frames.frame.size(), parallel_);
    if (state_.keep == KeepWindows::near_bisectors) windows.sort(parallel_);
    return windows;
  }

  /// Takes the distances and labels of the vertices from their first copies. Labels of vertices without a path are only
  /// provisional, and are removed.
  void take_labels(WindowField& field) {
    field.distance = IdVector<VertexId, double>(std::move(state_.labels.distance.raw()));
    field.label = IdVector<VertexId, GeneratorId>(std::move(state_.labels.label.raw()));
    field.departure = IdVector<VertexId, Departure>(std::move(state_.labels.departure.raw()));
    field.distance.resize(state_.mesh->vertex_count());
    field.label.resize(field.distance.size());
    for (const VertexId v : state_.mesh->vertices()) {
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
  const ParallelChunks& parallel_;
  PropagationState& state_;
  std::vector<std::unique_ptr<Partition>> partitions_;
  std::int64_t next_report_ = kProgressStride;
};

}  // namespace gvd
