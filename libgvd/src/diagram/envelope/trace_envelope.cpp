// Traces the diagram of a distance field by lower envelopes: first all edges are crossed, then all crossed faces are
// closed.
//
// In a face, the crossings are joined by straight arcs, the arcs are refined along the bisectors, and arcs that
// intersect are separated: a refined arc that intersects itself loses its loops, and of refined arcs that intersect
// each other, some stay straight. If even straight arcs intersect, because rounded distances contradict each other, the
// face is assembled again by convex steps alone. A face therefore closes whatever the distances are.
//
// Chunks of edges and of faces share nothing but the input, and their results are joined in order (ParallelChunks).
// Source: not in the paper, which interpolates crossings and draws straight arcs (section 4.2); docs/developer/exact.md
// describes the method. Cost: O(n) to find the contested edges, then the work of the k edges and faces near bisectors.
#include "diagram/envelope/trace_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "diagram/assembly/face_assembly.hpp"
#include "diagram/envelope/edge_crossings.hpp"
#include "diagram/envelope/refine_arcs.hpp"
#include "diagram/envelope/separate_arcs.hpp"
#include "diagram/envelope/source_distances.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// The number of edges in a chunk, and the work of the faces in a chunk, which is the sum of the squares of their
/// numbers of crossings. A chunk takes half a millisecond, which is long enough to occupy a thread and short enough to
/// cancel after it.
constexpr std::size_t kChunkEdges = 128, kChunkWork = 512;

/// Number of samples of a segment in a face whose error is measured.
constexpr int kErrorSamples = 16;

/// Traces face after face: assembles it, refines its arcs, and separates arcs that intersect.
class EnvelopeFaceTracer {
 public:
  explicit EnvelopeFaceTracer(const EnvelopeFaces& input)
      : input_(input), plain_(input.field), with_offsets_(input.field), refiner_(input.tolerance) {}

  /// Appends face f to the result.
  ///
  /// Ties between branch points are decided as on the edges, by the symbolic offsets. The refinement uses these
  /// offsets, too: between generators that nearly coincide, the offsets turn bisectors, and arcs that were refined
  /// without them would intersect.
  void assemble(FaceId f) {
    OpenFace face(result_.diagram, boundary_);
    boundary_crossings(input_.mesh, input_.crossings, f, boundary_);
    plain_.enter(input_.mesh, f);
    const bool may_branch = boundary_.size() > 2;
    if (may_branch) with_offsets_.enter_with_offsets(plain_, input_.offset);
    const SourceDistances& deciding = may_branch ? with_offsets_ : plain_;
    assemble_face(f, boundary_, deciding, result_.diagram, &deciding);
    for (FaceArc& arc : face.arcs()) refine(deciding, face, arc);
    bool straightened = separator_.separate(face);
    if (may_branch && separator_.is_inverted(face)) {
      face.clear();
      assemble_face(f, boundary_, deciding, result_.diagram);
      straightened = true;
    }
    if (straightened) result_.straightened.push_back({f, largest_error(face)});
    measure_branches(face);
  }

  AssembledFaces take_result() { return std::move(result_); }

 private:
  /// Refines an arc. A bisector can follow a side by a tie, or lie beyond it by rounding. Then the search in the face
  /// ends on the side and not on the bisector. Points that are not inside the face are therefore dropped.
  void refine(const SourceDistances& distances, const OpenFace& face, FaceArc& arc) {
    std::vector<Bary>& points = result_.diagram.points;
    arc.first_point = static_cast<std::int32_t>(points.size());
    refiner_.refine(distances, arc, face.position(arc.begin), face.position(arc.end), points);
    const auto is_outside = [](const Bary& p) { return !(*std::min_element(p.begin(), p.end()) >= kInsideFace); };
    points.erase(std::remove_if(points.begin() + arc.first_point, points.end(), is_outside), points.end());
    arc.point_count = static_cast<std::int32_t>(points.size()) - arc.first_point;
  }

  /// Sets the distance of the branch points to the generators round them, which is the length of the shortest path that
  /// the face knows. All these paths are equally long, with one exception: from a generator that nearly coincides with
  /// another one, or nearly lies on a side, the face may only know a longer path, or none.
  void measure_branches(const OpenFace& face) {
    for (BranchPointId id = face.first_branch(); id < face.end_branch(); id = BranchPointId(id.value() + 1)) {
      FaceBranch& branch = result_.diagram.branches[id];
      double least = kInfinity;
      for (const FaceArc& arc : face.arcs()) {
        if (arc.ends_at(at(id))) least = std::min(least, plain_.at(arc.left_from(at(id)), branch.bary));
      }
      branch.distance = std::isfinite(least) ? least : plain_.nearest_of_all(branch.bary);
    }
  }

  /// The largest difference of the distances to an arc's two generators, over samples of all arcs of the face.
  double largest_error(const OpenFace& face) const {
    double largest = 0;
    for (const FaceArc& arc : face.arcs()) {
      Bary from = face.position(arc.begin);
      const auto follow = [&](const Bary& to) {
        for (int k = 1; k <= kErrorSamples; ++k) {
          const Bary p = mix(from, to, static_cast<double>(k) / kErrorSamples);
          const double error = std::abs(plain_.at(arc.left, p) - plain_.at(arc.right, p));
          if (std::isfinite(error)) largest = std::max(largest, error);
        }
        from = to;
      };
      for (const Bary& p : face.inner_points(arc)) follow(p);
      follow(face.position(arc.end));
    }
    return largest;
  }

  const EnvelopeFaces& input_;
  SourceDistances plain_, with_offsets_;  // in the current face; with_offsets_ only if it may have a branch point
  ArcRefiner refiner_;
  ArcSeparator separator_;
  std::vector<BoundaryCrossing> boundary_;
  AssembledFaces result_;
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
  return {mesh_.edge_count(), cross(field_.contested_edges(parallel_), labels)};
}

std::vector<Crossing> EnvelopeTracer::cross(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                            bool at_most_once) const {
  const StepPart& step = at_most_once ? steps::kCrossingsAgain : steps::kCrossings;
  return parallel_.collect(cut_into_chunks(edges.size(), kChunkEdges), step, [&](const Chunk& chunk) {
    std::vector<EdgeSource> sources;  // of the current edge
    EdgeEnvelope envelope;            // of the current edge
    EdgeCrossings crossings;
    std::vector<Crossing> result;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const EdgeId e = edges[i];
      const HalfedgeId h = mesh_.halfedge(e);
      const GeneratorId first = labels.label[mesh_.from(h)], last = labels.label[mesh_.to(h)];
      if (at_most_once && first == last) continue;
      field_.collect(e, sources);
      envelope.build(sources, mesh_.length(e), offset_);
      if (at_most_once) {
        crossings.append_single(envelope, e, first, last, result);
      } else {
        crossings.append_all(envelope, e, first, last, result);
      }
    }
    return result;
  });
}

void EnvelopeTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                        Crossings& crossings) const {
  crossings.replace(edges, cross(edges, labels, true));
}

void EnvelopeTracer::close_faces(TracedDiagram& traced) {
  report_progress(parallel_.progress(), steps::kFaces, 0);
  const auto counts = count_by_face(mesh_, traced.crossings);
  AssembledFaces assembled = assemble(crossed_faces(counts), counts, traced.crossings);
  traced.faces = std::move(assembled.diagram);
  traced.straightened = std::move(assembled.straightened);
  report_progress(parallel_.progress(), steps::kBisectors, 0.5);
}

AssembledFaces EnvelopeTracer::assemble(const std::vector<FaceId>& faces, const IdVector<FaceId, std::int32_t>& counts,
                                        const Crossings& crossings) const {
  const auto work = [&](std::size_t i) { return std::size_t(counts[faces[i]]) * std::size_t(counts[faces[i]]); };
  const EnvelopeFaces input{mesh_, crossings, field_, offset_, tolerance_};
  const auto assemble_chunk = [&](const Chunk& chunk) {
    return assemble_envelope(input, std::span(faces).subspan(chunk.begin, chunk.end - chunk.begin));
  };
  AssembledFaces all;
  const auto chunks = cut_by_work(faces.size(), kChunkWork, work);
  for (const AssembledFaces& part : parallel_.map(chunks, StepPart{steps::kFaces}, assemble_chunk)) {
    all.diagram.append(part.diagram);
    all.straightened.insert(all.straightened.end(), part.straightened.begin(), part.straightened.end());
  }
  return all;
}

AssembledFaces assemble_envelope(const EnvelopeFaces& input, std::span<const FaceId> faces) {
  EnvelopeFaceTracer assembler(input);
  for (const FaceId f : faces) assembler.assemble(f);
  return assembler.take_result();
}

}  // namespace gvd
