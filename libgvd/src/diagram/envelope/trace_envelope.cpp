#include "diagram/envelope/trace_envelope.hpp"

#include <algorithm>
#include <iterator>

#include "diagram/envelope/edge_envelope.hpp"
#include "diagram/envelope/exact_face_assembler.hpp"
#include "diagram/graph/connected_tracer.hpp"

namespace gvd {
namespace {

/// Symbolic offset between the first and the last generator, as a part of the bounding box's diagonal. Mirror-symmetric
/// models put whole bisectors exactly on edges; offsets that grow with the generator's id decide every such tie the
/// same way all along. Far above rounding where generators are few, and a tenth of what a crossing may be off.
constexpr double kTieOffset = 1e-13;

/// Chunks of so many edges, or of faces with so much work, the square of the crossings round them: half a millisecond,
/// which is long enough for threads and short enough to be cancelled after.
constexpr std::size_t kChunkEdges = 128, kChunkWork = 512;

/// Crosses edges one after the other, where the lower envelope of their distances passes from cell to cell.
class EdgeCrosser {
 public:
  EdgeCrosser(const Mesh& mesh, const NearestLabels& labels, const DistanceField& field, double tie_step)
      : mesh_(mesh), labels_(labels), field_(field), tie_step_(tie_step) {}

  /// Appends the crossings of e; `plainly`: at most one, between the labels of its ends.
  void cross(EdgeId e, bool plainly) {
    const HalfedgeId h = mesh_.halfedge(e);
    const GeneratorId first = labels_.label[mesh_.from(h)], last = labels_.label[mesh_.to(h)];
    if (plainly && first == last) return;
    field_.collect(e, sources_);
    envelope_.build(sources_, mesh_.length(e), tie_step_);
    if (plainly) {
      envelope_.append_plain_crossing(e, first, last, crossings_);
    } else {
      envelope_.append_crossings(e, first, last, crossings_);
    }
  }

  std::vector<Crossing> take_result() { return std::move(crossings_); }

 private:
  const Mesh& mesh_;
  const NearestLabels& labels_;
  const DistanceField& field_;
  double tie_step_;
  EdgeEnvelope envelope_;  // of the edge at work
  std::vector<EdgeSource> sources_;
  std::vector<Crossing> crossings_;
};

class EnvelopeTracer final : public ConnectedTracer {
 public:
  EnvelopeTracer(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field, double tolerance,
                 const ParallelChunks& parallel)
      : ConnectedTracer(working, labels, parallel.progress()),
        field_(field),
        parallel_(parallel),
        tolerance_(tolerance),
        tie_step_(kTieOffset * mesh_.bbox_diagonal() / static_cast<double>(working.generator_vertices().size())) {}

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
  std::vector<Crossing> cross(const std::vector<EdgeId>& edges, bool plainly, const StepPart& step) const {
    return parallel_.collect(cut_into_chunks(edges.size(), kChunkEdges), step, [&](const Chunk& chunk) {
      EdgeCrosser crosser(mesh_, labels_, field_, tie_step_);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) crosser.cross(edges[i], plainly);
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
      ExactFaceAssembler closer(mesh_, traced.crossings, field_, tie_step_, tolerance_);
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) closer.close(faces[i]);
      return closer.take_result();
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
  double tolerance_, tie_step_;
};

}  // namespace

TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const ParallelChunks& parallel, DiagramReport& report) {
  return EnvelopeTracer(working, labels, field, tolerance, parallel).run(report);
}

}  // namespace gvd
