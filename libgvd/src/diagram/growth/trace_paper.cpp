// Sections 4.1 to 4.3 exactly as in the paper (`--method paper`). docs/developer/paper-steps.md compares the results.
//
// A rough segment joins the midpoints of two edges in every face of two labels. Both generators are unfolded from their
// distances at these midpoints (figure 6), which moves the segment to the bisector of the two images. The segments then
// grow through the branching faces of section 3 with the paper's rules: a segment keeps its direction and its images
// over each edge, one queue orders events by distance, and branch points are accepted by distance.
// Deviations: two ends of one bisector that face each other are joined, which is a third kind of event. The paper does
// not say what happens if growth fails; here, the gap is enlarged, and the assembly completes the diagram in the end.
#include "diagram/growth/trace_paper.hpp"

#include <utility>

#include "diagram/graph/nearest_labels.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/marching/unfold.hpp"

namespace gvd {
namespace {

void append_midpoint(const Mesh& mesh, EdgeId e, const NearestLabels& labels, std::vector<Crossing>& crossings) {
  const HalfedgeId h = mesh.halfedge(e);
  const GeneratorId from = labels.label[mesh.from(h)], to = labels.label[mesh.to(h)];
  if (from != to) crossings.push_back({e, 0.5, from, to});
}

/// The corner between two edges of a face. Edge i leads from corner i to the next corner.
int corner_between(int first_edge, int second_edge) { return second_edge == first_edge + 1 ? second_edge : 0; }

/// The images in f of the apex's generator, on the apex's side of the rough segment, and of the other generator, on the
/// other side.
std::optional<FaceImages> unfold_apart(const Mesh& mesh, const GeneratorTable& table, FaceId f, int apex,
                                       const BoundaryCrossing& leaving) {
  const auto corner = FaceLayout(mesh, f).corner;
  const int next = (apex + 1) % 3, before = (apex + 2) % 3;
  const Vec2 t1 = 0.5 * (corner[apex] + corner[next]), t2 = 0.5 * (corner[before] + corner[apex]);
  // The cell of the apex lies before the crossing on the edge that leaves it.
  const auto own = find_midpoint_distances(table, f, leaving.previous);
  const auto others = find_midpoint_distances(table, f, leaving.next);
  if (!own || !others) return std::nullopt;
  // From t1 to t2 the apex lies on the left.
  return FaceImages{f, corner, unfold_source(t2, t1, (*own)[before], (*own)[apex]),
                    unfold_source(t1, t2, (*others)[apex], (*others)[before])};
}

}  // namespace

std::optional<std::array<double, 3>> find_midpoint_distances(const GeneratorTable& table, FaceId f, GeneratorId g) {
  const std::int32_t entry = table.find(f, g);
  if (entry < 0) return std::nullopt;
  const auto d = table.corner_distances(table.entry(entry));
  return std::array{0.5 * (d[0] + d[1]), 0.5 * (d[1] + d[2]), 0.5 * (d[2] + d[0])};
}

Crossings find_rough_segments(const Mesh& mesh, const NearestLabels& labels) {
  std::vector<Crossing> crossings;
  for (const EdgeId e : mesh.edges()) append_midpoint(mesh, e, labels, crossings);
  return {mesh.edge_count(), std::move(crossings)};
}

std::vector<CrossingEstimate> refine_segments(const Mesh& mesh, const GeneratorTable& table,
                                              const Crossings& crossings) {
  std::vector<CrossingEstimate> estimates;
  std::vector<BoundaryCrossing> boundary;
  for (const FaceId f : crossed_faces(mesh, crossings)) {
    boundary_crossings(mesh, crossings, f, boundary);
    if (boundary.size() != 2) continue;
    const int apex = corner_between(boundary[0].corner, boundary[1].corner);
    const BoundaryCrossing& leaving = boundary[boundary[0].corner == apex ? 0 : 1];
    const auto images = unfold_apart(mesh, table, f, apex, leaving);
    if (images) estimate_crossings(mesh, crossings, boundary, *images, estimates);
  }
  return estimates;
}

PaperTracer::PaperTracer(const WorkingMesh& working, const GeneratorTable& table, Front front, const Progress& progress)
    : GapTracer(working, table, front, progress, {kPaperRules}) {}

Crossings PaperTracer::cross_edges(const NearestLabels& labels) const { return find_rough_segments(mesh(), labels); }

void PaperTracer::cross_at_most_once(const std::vector<EdgeId>& edges, const NearestLabels& labels,
                                     Crossings& crossings) const {
  std::vector<Crossing> midpoints;
  for (const EdgeId e : edges) append_midpoint(mesh(), e, labels, midpoints);
  crossings.replace(edges, midpoints);
}

void PaperTracer::close_faces(TracedDiagram& traced) {
  weld_crossings(refine_segments(mesh(), table(), traced.crossings), traced.crossings);
  IdVector<FaceId, char> is_branching(mesh().face_count());
  for (const FaceId f : mesh().faces()) {
    is_branching[f] = classify(mesh(), traced.labels.label, f) == FaceClass::branching;
  }
  close(connect_gaps(mesh(), is_branching), traced);
}

}  // namespace gvd
