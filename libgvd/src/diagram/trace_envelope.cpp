#include "diagram/trace_envelope.hpp"

#include <algorithm>

#include "diagram/bend_arcs.hpp"
#include "diagram/cell_topology.hpp"
#include "diagram/edge_envelope.hpp"
#include "diagram/face_assembly.hpp"
#include "diagram/face_pieces.hpp"

namespace gvd {
namespace {

/// Symbolic offset between the first and the last generator, as a part of the bounding box's diagonal. Mirror-symmetric
/// models put whole bisectors exactly on edges; offsets that grow with the generator's id decide every such tie the same way
/// all along. Far above rounding where generators are few, and a tenth of what a crossing may be off.
constexpr double kTieOffset = 1e-13;

/// A piece of less than no area, as a part of its face's, beyond rounding.
constexpr double kTurned = 1e-11;

class EnvelopeTracer {
 public:
  EnvelopeTracer(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field, double tolerance)
      : mesh_(working.mesh()),
        labels_(labels),
        field_(field),
        tolerance_(tolerance),
        tie_step_(kTieOffset * mesh_.bbox_diagonal() / static_cast<double>(working.generator_vertices().size())) {}

  Crossings find_crossings() const {
    std::vector<Crossing> crossings;
    std::vector<EdgeSource> sources;
    EdgeEnvelope envelope;
    for (const EdgeId e : field_.contested_edges()) {
      field_.collect(e, sources);
      envelope.build(sources, mesh_.length(e), tie_step_);
      const HalfedgeId h = mesh_.halfedge(e);
      envelope.append_crossings(e, labels_.label[mesh_.from(h)], labels_.label[mesh_.to(h)], crossings);
    }
    return Crossings(mesh_.edge_count(), std::move(crossings));
  }

  void assemble(const Crossings& crossings, FaceDiagram& faces) {
    SourceMetric metric(field_);
    std::vector<BoundaryCrossing> boundary;
    for (const FaceId f : crossed_faces(mesh_, crossings)) {
      boundary_crossings(mesh_, crossings, f, boundary);
      metric.enter(mesh_, f);
      const std::size_t first_arc = faces.arcs.size(), first_branch = faces.branches.size(), first_point = faces.points.size();
      assemble_face(f, boundary, metric, faces);
      for (std::size_t i = first_arc; i < faces.arcs.size(); ++i) bend(metric, boundary, faces, i);
      if (boundary.size() > 2 && arcs_cross(boundary, first_arc, faces)) {
        faces.arcs.resize(first_arc);
        faces.branches.resize(first_branch);
        faces.points.resize(first_point);
        metric.set_sure(false);
        assemble_face(f, boundary, metric, faces);
        metric.set_sure(true);
        ++straightened_faces_;
      }
      measure_branches(metric, first_arc, first_branch, faces);
    }
  }

  std::int64_t straightened_faces() const { return straightened_faces_; }

 private:
  /// Arcs that cross turn a piece inside out. True arcs don't; rounding can bring it about where nearly everything is a tie.
  /// Straight arcs of the assembly's convex steps never cross.
  bool arcs_cross(const std::vector<BoundaryCrossing>& boundary, std::size_t first_arc, const FaceDiagram& faces) {
    trace_pieces(boundary, std::span(faces.arcs).subspan(first_arc), faces, pieces_);
    return std::any_of(pieces_.pieces.begin(), pieces_.pieces.end(), [](const WorkingPiece& piece) {
      double twice = 0;
      for (std::size_t i = 0, n = piece.corners.size(); i < n; ++i) {
        const auto &p = piece.corners[i], &q = piece.corners[(i + 1) % n];
        twice += p[1] * q[2] - p[2] * q[1];
      }
      return twice < -kTurned;
    });
  }

  static FaceMetric::Bary place(const ArcEnd& end, const std::vector<BoundaryCrossing>& boundary, const FaceDiagram& faces) {
    if (end.branch.valid()) return faces.branches[end.branch].bary;
    return std::find_if(boundary.begin(), boundary.end(), [&](const auto& c) { return c.id == end.crossing; })->bary();
  }

  void bend(const SourceMetric& metric, const std::vector<BoundaryCrossing>& boundary, FaceDiagram& faces,
            std::size_t i) const {
    FaceArc& arc = faces.arcs[i];
    const std::size_t first = faces.points.size();
    bend_arc(metric, arc, place(arc.begin, boundary, faces), place(arc.end, boundary, faces), tolerance_, faces.points);
    arc.first_point = static_cast<std::int32_t>(first);
    arc.point_count = static_cast<std::int32_t>(faces.points.size() - first);
  }

  /// Mean distance of the new branch points to the generators that meet there.
  static void measure_branches(const SourceMetric& metric, std::size_t first_arc, std::size_t first_branch,
                               FaceDiagram& faces) {
    for (std::size_t b = first_branch; b < faces.branches.size(); ++b) {
      const BranchPointId id(static_cast<std::int64_t>(b));
      double sum = 0;
      int arcs = 0;
      for (std::size_t a = first_arc; a < faces.arcs.size(); ++a) {
        const FaceArc& arc = faces.arcs[a];
        if (arc.begin != at(id) && arc.end != at(id)) continue;
        sum += metric.at(arc.begin == at(id) ? arc.left : arc.right, faces.branches[id].bary);
        ++arcs;
      }
      faces.branches[id].distance = sum / arcs;
    }
  }

  const Mesh& mesh_;
  const NearestLabels& labels_;
  const DistanceField& field_;
  double tolerance_, tie_step_;
  WorkingPieces pieces_;  // of the face at work
  std::int64_t straightened_faces_ = 0;
};

}  // namespace

TracedDiagram trace_envelope(const WorkingMesh& working, const NearestLabels& labels, const DistanceField& field,
                             double tolerance, const Progress& progress, DiagramReport& report) {
  report_progress(progress, "bisectors", 0);
  EnvelopeTracer tracer(working, labels, field, tolerance);
  TracedDiagram traced{labels, tracer.find_crossings(), {}, {}, {}};
  report_progress(progress, "growth", 0);
  tracer.assemble(traced.crossings, traced.faces);
  report_progress(progress, "bisectors", 0.5);
  report.straightened_faces = tracer.straightened_faces();
  CellParts parts(working, traced);
  traced.cell_components = parts.count_components();
  return traced;
}

}  // namespace gvd
