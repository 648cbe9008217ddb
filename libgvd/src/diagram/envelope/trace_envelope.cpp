#include "diagram/envelope/trace_envelope.hpp"

#include <algorithm>
#include <iterator>

#include "diagram/envelope/edge_crossings.hpp"
#include "diagram/envelope/edge_envelope.hpp"
#include "diagram/envelope/exact_face_assembler.hpp"
#include "diagram/graph/connected_tracer.hpp"

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
      EdgeCrossings::append_single(envelope_, e, first, last, result_);
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

class EnvelopeTracer final : public ConnectedTracer {
 public:
  EnvelopeTracer(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field, double tolerance,
                 const ParallelChunks& parallel)
      : ConnectedTracer(working, labels, parallel.progress()),
        field_(field),
        parallel_(parallel),
        tolerance_(tolerance),
        offset_(SymbolicOffset::of_envelope(mesh_.bbox_diagonal(), working.generator_vertices().size())) {}

 private:
  Crossings cross_edges() override {
    return Crossings(mesh_.edge_count(), cross(field_.contested_edges(parallel_), false, {"bisectors", 0, 0.5}));
  }

  void cross_at_most_once(const std::vector<EdgeId>& edges, Crossings& crossings) override {
    std::vector<Crossing> others, all;
    std::copy_if(crossings.items().begin(), crossings.items().end(), std::back_inserter(others),
                 [&](const Crossing& c) { return !std::binary_search(edges.begin(), edges.end(), c.edge); });
    const std::vector<Crossing> plain = cross(edges, true, {"bisectors", 0.5, 0.5});
    std::merge(others.begin(), others.end(), plain.begin(), plain.end(), std::back_inserter(all),
               [](const Crossing& a, const Crossing& b) { return a.edge < b.edge; });
    crossings = Crossings(mesh_.edge_count(), std::move(all));
  }

  /// The crossings of these edges, ascending as they are.
  std::vector<Crossing> cross(const std::vector<EdgeId>& edges, bool at_most_once, const StepPart& step) const {
    return parallel_.collect(cut_into_chunks(edges.size(), kChunkEdges), step, [&](const Chunk& chunk) {
      EdgeCrosser crosser(mesh_, labels_, field_, offset_);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) crosser.cross(edges[i], at_most_once);
      return crosser.take_result();
    });
  }

  void close_faces(TracedDiagram& traced, DiagramReport& report) override {
    report_progress(progress_, "faces", 0);
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
    report.straightened_faces = 0;
    for (const AssembledFaces& part :
         parallel_.map(cut_by_work(faces.size(), kChunkWork, work), {"faces", 0, 1}, close)) {
      traced.faces.append(part.diagram);
      report.straightened_faces += part.straightened;
    }
    report_progress(progress_, "bisectors", 0.5);
  }

  const DistanceField& field_;
  const ParallelChunks& parallel_;
  double tolerance_;
  SymbolicOffset offset_;
};

}  // namespace

TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const ParallelChunks& parallel, DiagramReport& report) {
  return EnvelopeTracer(working, labels, field, tolerance, parallel).run(report);
}

}  // namespace gvd
