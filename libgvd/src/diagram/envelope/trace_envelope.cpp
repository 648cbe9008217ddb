#include "diagram/envelope/trace_envelope.hpp"

#include <algorithm>
#include <utility>

#include "diagram/envelope/edge_crossings.hpp"
#include "diagram/envelope/edge_envelope.hpp"
#include "diagram/envelope/exact_face_assembler.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Chunks of so many edges, or of faces with so much work: the sum of the squares of their crossings. Half a
/// millisecond, long enough to occupy a thread and short enough to cancel after.
constexpr std::size_t kChunkEdges = 128, kChunkWork = 512;

/// Finds the crossings of one edge after the other.
class EdgeCrosser {
 public:
  EdgeCrosser(const Mesh& mesh, const NearestLabels& labels, const DistanceField& field, const SymbolicOffset& offset)
      : mesh_(mesh), labels_(labels), field_(field), offset_(offset) {}

  /// Appends the crossings of e; with `at_most_once` only one, between different labels of its ends.
  void cross(EdgeId e, bool at_most_once) {
    const HalfedgeId h = mesh_.halfedge(e);
    const GeneratorId first = labels_.label[mesh_.from(h)], last = labels_.label[mesh_.to(h)];
    if (at_most_once && first == last) return;
    field_.collect(e, sources_);
    envelope_.build(sources_, mesh_.length(e), offset_);
    if (at_most_once) {
      crossings_.append_single(envelope_, e, first, last, result_);
    } else {
      crossings_.append_all(envelope_, e, first, last, result_);
    }
  }

  std::vector<Crossing> take_result() { return std::move(result_); }

 private:
  const Mesh& mesh_;
  const NearestLabels& labels_;
  const DistanceField& field_;
  SymbolicOffset offset_;
  EdgeEnvelope envelope_;  // of the current edge
  EdgeCrossings crossings_;
  std::vector<EdgeSource> sources_;
  std::vector<Crossing> result_;
};

}  // namespace

EnvelopeTracer::EnvelopeTracer(const WorkingMesh& working, const DistanceField& field, double tolerance,
                               const ParallelChunks& parallel)
    : mesh_(working.mesh()),
      field_(field),
      parallel_(parallel),
      tolerance_(tolerance),
      offset_(SymbolicOffset::of_envelope(mesh_.bbox_diagonal(), working.generator_vertices().size())) {}

Crossings EnvelopeTracer::cross_edges(const NearestLabels& labels) const {
  return Crossings(mesh_.edge_count(), cross(field_.contested_edges(parallel_), labels, Limit::none));
}

void EnvelopeTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                        Crossings& crossings) const {
  crossings.replace(edges, cross(edges, labels, Limit::one_crossing));
}

std::vector<Crossing> EnvelopeTracer::cross(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                            Limit limit) const {
  const StepPart step = limit == Limit::none ? steps::kCrossings : steps::kCrossingsAgain;
  return parallel_.collect(cut_into_chunks(edges.size(), kChunkEdges), step, [&](const Chunk& chunk) {
    EdgeCrosser crosser(mesh_, labels, field_, offset_);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) crosser.cross(edges[i], limit == Limit::one_crossing);
    return crosser.take_result();
  });
}

void EnvelopeTracer::close_faces(TracedDiagram& traced) const {
  report_progress(parallel_.progress(), steps::kFaces, 0);
  const auto counts = count_by_face(mesh_, traced.crossings);
  const std::vector<FaceId> faces = crossed_faces(counts);
  const auto work = [&](std::size_t i) {
    const auto count = static_cast<std::size_t>(counts[faces[i]]);
    return count * count;
  };
  const auto close = [&](const Chunk& chunk) {
    ExactFaceAssembler assembler(mesh_, traced.crossings, field_, offset_, tolerance_);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) assembler.assemble(faces[i]);
    return assembler.take_result();
  };
  const auto chunks = cut_by_work(faces.size(), kChunkWork, work);
  for (const AssembledFaces& assembled : parallel_.map(chunks, StepPart{steps::kFaces}, close)) {
    traced.faces.append(assembled.diagram);
    traced.counts.straightened_faces += assembled.straightened;
    traced.counts.straightened_error = std::max(traced.counts.straightened_error, assembled.straightened_error);
  }
  report_progress(parallel_.progress(), steps::kBisectors, 0.5);
}

}  // namespace gvd
