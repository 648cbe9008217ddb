#include "diagram/trace_envelope.hpp"

#include <algorithm>
#include <string_view>

#include "diagram/area_share.hpp"
#include "diagram/bend_arcs.hpp"
#include "diagram/connected_tracer.hpp"
#include "diagram/edge_envelope.hpp"
#include "diagram/face_assembly.hpp"
#include "diagram/face_pieces.hpp"

namespace gvd {
namespace {

/// Symbolic offset between the first and the last generator, as a part of the bounding box's diagonal. Mirror-symmetric
/// models put whole bisectors exactly on edges; offsets that grow with the generator's id decide every such tie the
/// same way all along. Far above rounding where generators are few, and a tenth of what a crossing may be off.
constexpr double kTieOffset = 1e-13;

/// A piece of less than no area, as a part of its face's, beyond rounding.
constexpr double kTurned = 1e-11;

/// Progress is reported once in so many edges, or in faces with so much work: the square of the crossings round them.
constexpr std::size_t kProgressStride = 1 << 10, kProgressWork = 1 << 12;

class EnvelopeTracer final : public ConnectedTracer {
 public:
  EnvelopeTracer(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field, double tolerance,
                 const Progress& progress)
      : ConnectedTracer(working, labels, progress),
        field_(field),
        metric_(field),
        tolerance_(tolerance),
        tie_step_(kTieOffset * mesh_.bbox_diagonal() / static_cast<double>(working.generator_vertices().size())) {}

 private:
  Crossings cross_edges() override {
    std::vector<Crossing> crossings;
    const std::vector<EdgeId> edges = field_.contested_edges();
    for (std::size_t i = 0; i < edges.size(); ++i) {
      cross(edges[i], false, crossings);
      if ((i + 1) % kProgressStride == 0) report_part("bisectors", 0.5 * static_cast<double>(i), edges.size());
    }
    return Crossings(mesh_.edge_count(), std::move(crossings));
  }

  void cross_plainly(const std::vector<EdgeId>& edges, Crossings& crossings) override {
    std::vector<Crossing> items;
    auto next = edges.begin();
    for (const Crossing& c : crossings.items()) {
      for (; next != edges.end() && *next < c.edge; ++next) cross(*next, true, items);
      if (next == edges.end() || *next != c.edge) items.push_back(c);
    }
    for (; next != edges.end(); ++next) cross(*next, true, items);
    crossings = Crossings(mesh_.edge_count(), std::move(items));
  }

  void cross(EdgeId e, bool plainly, std::vector<Crossing>& crossings) {
    const HalfedgeId h = mesh_.halfedge(e);
    const GeneratorId first = labels_.label[mesh_.from(h)], last = labels_.label[mesh_.to(h)];
    if (plainly && first == last) return;
    field_.collect(e, sources_);
    envelope_.build(sources_, mesh_.length(e), tie_step_);
    if (plainly) {
      envelope_.append_plain_crossing(e, first, last, crossings);
    } else {
      envelope_.append_crossings(e, first, last, crossings);
    }
  }

  void close_faces(TracedDiagram& traced, DiagramReport& report) override {
    report_progress(progress_, "growth", 0);
    report.straightened_faces = 0;
    const std::vector<FaceId> faces = crossed_faces(mesh_, traced.crossings);
    std::size_t work = 0;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      close_face(faces[i], traced, report);
      work += boundary_.size() * boundary_.size();
      if (work < kProgressWork) continue;
      work = 0;
      report_part("growth", static_cast<double>(i), faces.size());
    }
    report_progress(progress_, "bisectors", 0.5);
  }

  void report_part(std::string_view step, double done, std::size_t all) const {
    report_progress(progress_, step, done / static_cast<double>(all));
  }

  void close_face(FaceId f, TracedDiagram& traced, DiagramReport& report) {
    FaceDiagram& faces = traced.faces;
    const std::size_t arcs = faces.arcs.size(), branches = faces.branches.size(), points = faces.points.size();
    boundary_crossings(mesh_, traced.crossings, f, boundary_);
    metric_.enter(mesh_, f);
    assemble_face(f, boundary_, metric_, faces);
    for (std::size_t i = arcs; i < faces.arcs.size(); ++i) bend(faces, i);
    if (boundary_.size() > 2 && arcs_cross(arcs, faces)) {
      faces.arcs.resize(arcs);
      faces.branches.resize(branches);
      faces.points.resize(points);
      metric_.set_sure(false);
      assemble_face(f, boundary_, metric_, faces);
      metric_.set_sure(true);
      ++report.straightened_faces;
    }
    measure_branches(arcs, branches, faces);
  }

  /// Arcs that cross turn a piece inside out. True arcs don't; rounding can bring it about where nearly everything is a
  /// tie. Straight arcs of the assembly's convex steps never cross.
  bool arcs_cross(std::size_t first_arc, const FaceDiagram& faces) {
    trace_pieces(boundary_, std::span(faces.arcs).subspan(first_arc), faces, pieces_);
    return std::any_of(pieces_.pieces.begin(), pieces_.pieces.end(),
                       [](const WorkingPiece& piece) { return area_share(piece.corners) < -kTurned; });
  }

  FaceMetric::Bary place(const ArcEnd& end, const FaceDiagram& faces) const {
    if (end.branch.valid()) return faces.branches[end.branch].bary;
    return std::find_if(boundary_.begin(), boundary_.end(), [&](const auto& c) { return c.id == end.crossing; })
        ->bary();
  }

  void bend(FaceDiagram& faces, std::size_t i) const {
    FaceArc& arc = faces.arcs[i];
    const std::size_t first = faces.points.size();
    bend_arc(metric_, arc, place(arc.begin, faces), place(arc.end, faces), tolerance_, faces.points);
    arc.first_point = static_cast<std::int32_t>(first);
    arc.point_count = static_cast<std::int32_t>(faces.points.size() - first);
  }

  /// Mean distance of the new branch points to the generators that meet there.
  void measure_branches(std::size_t first_arc, std::size_t first_branch, FaceDiagram& faces) const {
    for (std::size_t b = first_branch; b < faces.branches.size(); ++b) {
      const BranchPointId id(static_cast<std::int64_t>(b));
      double sum = 0;
      int arcs = 0;
      for (std::size_t a = first_arc; a < faces.arcs.size(); ++a) {
        const FaceArc& arc = faces.arcs[a];
        if (arc.begin != at(id) && arc.end != at(id)) continue;
        sum += metric_.at(arc.begin == at(id) ? arc.left : arc.right, faces.branches[id].bary);
        ++arcs;
      }
      faces.branches[id].distance = sum / arcs;
    }
  }

  const DistanceField& field_;
  SourceMetric metric_;  // of the face at work
  double tolerance_, tie_step_;
  // Of the edge or the face at work, to save allocations.
  EdgeEnvelope envelope_;
  std::vector<EdgeSource> sources_;
  std::vector<BoundaryCrossing> boundary_;
  WorkingPieces pieces_;
};

}  // namespace

TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const Progress& progress, DiagramReport& report) {
  return EnvelopeTracer(working, labels, field, tolerance, progress).run(report);
}

}  // namespace gvd
