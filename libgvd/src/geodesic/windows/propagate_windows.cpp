#include "geodesic/windows/propagate_windows.hpp"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "geodesic/windows/partition_propagator.hpp"
#include "geodesic/windows/propagation_rounds.hpp"

namespace gvd {
namespace {

/// The propagation in all parts.
class Propagation {
 public:
  Propagation(const Mesh& mesh, const PropagationOptions& options, const Progress& progress)
      : progress_(progress), parallel_(options.threads, silent_), state_(mesh, options, parallel_) {
    for (std::int32_t part = 0; part < state_.parts.count(); ++part) {
      partitions_.push_back(make_partition_propagation(state_, part));
    }
  }

  void start(VertexId v, GeneratorId g, double d) {
    const std::int32_t shared = state_.parts.shared(v.value());
    if (shared < 0) {
      part(state_.parts.of_halfedge(state_.mesh.halfedge(v).value())).start_vertex(v.value(), g, d);
      return;
    }
    for (const MeshPartitions::Place& place : state_.parts.places(shared)) {
      part(place.part).start_vertex(place.vertex, g, d);
    }
  }

  WindowField run() {
    PropagationRounds(partitions_, state_.mail, state_.bucket_width, parallel_).run([&] { report(); });
    for (const auto& part : partitions_) {
      state_.field.carried += part->carried();
      state_.field.events += part->events();
    }
    keep_windows();
    forget_places();
    return std::move(state_.field);
  }

 private:
  PartitionPropagation& part(std::int32_t i) { return *partitions_[static_cast<std::size_t>(i)]; }

  /// Reports once in so many windows: rounds can be many, and short.
  void report() {
    std::int64_t carried = 0;
    for (const auto& part : partitions_) carried += part->carried();
    if (carried < next_report_) return;
    next_report_ = carried + kProgressStride;
    const double share = static_cast<double>(carried) / (10.0 * state_.mesh.face_count());
    report_progress(progress_, "distances", share / (1 + share));
  }

  void keep_windows() {
    const StepPart end{"distances"};
    std::vector<BlockList<KeptWindow>> kept(partitions_.size());
    parallel_.run(partitions_.size(), end, [&](std::size_t i) { kept[i] = partitions_[i]->finish(); });
    state_.field.windows = EdgeWindows(std::move(kept), state_.frames.frame.size(), parallel_);
  }

  /// The places of shared vertices, and the labels of vertices that nothing reaches.
  void forget_places() {
    WindowField& field = state_.field;
    field.distance.resize(static_cast<std::size_t>(state_.mesh.vertex_count()));
    field.label.resize(field.distance.size());
    for (std::int32_t i = 0; i < state_.mesh.vertex_count(); ++i) {
      if (std::isinf(field.distance[VertexId(i)])) field.label[VertexId(i)] = GeneratorId();
    }
  }

  static constexpr std::int64_t kProgressStride = 1 << 14;

  const Progress& progress_;
  const Progress silent_;
  const ParallelChunks parallel_;
  PropagationState state_;
  std::vector<std::unique_ptr<PartitionPropagation>> partitions_;
  std::int64_t next_report_ = kProgressStride;
};

}  // namespace

WindowField propagate_windows(const Mesh& mesh, const std::vector<VertexId>& generators,
                              const PropagationOptions& options, const Progress& progress) {
  report_progress(progress, "distances", 0);
  Propagation propagation(mesh, options, progress);
  for (std::size_t g = 0; g < generators.size(); ++g) {
    propagation.start(generators[g], GeneratorId(static_cast<std::int64_t>(g)),
                      options.offsets.empty() ? 0 : options.offsets[g]);
  }
  return propagation.run();
}

}  // namespace gvd
