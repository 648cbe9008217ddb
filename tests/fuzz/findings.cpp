#include "fuzz/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "base/union_find.hpp"
#include "gvd/check.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/segment.hpp"

namespace gvd::test {
namespace {

/// Error of a distance. Different windows give distances of one point that differ by 1e-13 relative without thin faces
/// (exact_field.hpp), and positions far from the origin are rounded. Crossings are equidistant to 1e-12 of the bounding
/// box diagonal; the exact fields add their own error.
constexpr double kDistanceError = 1e-11, kPositionError = 1e-14;

double allowed_error(const Mesh& mesh) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return kDistanceError * mesh.bbox_diagonal() + kPositionError * largest;
}

void examine_point(const SurfacePoint& point, const std::string& name, Findings& findings) {
  double sum = 0;
  for (const double b : point.bary) {
    if (!(b >= 0 && b <= 1)) findings.push_back(fmt::format("{}: the coordinate {} is not in [0, 1]", name, b));
    sum += b;
  }
  if (!(std::abs(sum - 1) <= 1e-9)) findings.push_back(fmt::format("{}: coordinates add up to {}", name, sum));
}

/// Cutting costs O(k^2) to O(k^3) for k corners in a face. Only tiny chord tolerances give pieces with more corners.
constexpr std::size_t kMaxCorners = 300;

bool is_cheap_to_cut(const Diagram& diagram) {
  return std::all_of(diagram.pieces.begin(), diagram.pieces.end(),
                     [](const FacePiece& piece) { return piece.corners.size() <= kMaxCorners; });
}

/// The number of connected components of the faces of all labels.
std::size_t count_components(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label) {
  UnionFind components(label.size());
  for (std::int32_t e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e)), twin = mesh.twin(h);
    if (!twin.valid() || label[Mesh::face(h)] != label[Mesh::face(twin)]) continue;
    components.unite(Mesh::face(h).value(), Mesh::face(twin).value());
  }
  std::set<std::int32_t> roots;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    if (label[FaceId(f)].valid()) roots.insert(components.find(f));
  }
  return roots.size();
}

std::size_t count_labels(const IdVector<FaceId, GeneratorId>& label) {
  std::set<GeneratorId> labels;
  for (const GeneratorId g : label) {
    if (g.valid()) labels.insert(g);
  }
  return labels.size();
}

/// An exact field for each generator.
class Fields {
 public:
  Fields(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
    for (const SurfacePoint& generator : generators) fields_.emplace_back(mesh, std::vector{generator});
  }

  double distance(GeneratorId g, VertexId v) const { return fields_[g.index()].distance(v); }
  double distance(GeneratorId g, const SurfacePoint& p) const { return fields_[g.index()].nearest(p).distance; }
  /// The distance to the nearest generator.
  template <class Point>
  double least(const Point& point) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t g = 0; g < fields_.size(); ++g) {
      best = std::min(best, distance(GeneratorId(g), point));
    }
    return best;
  }

 private:
  std::vector<ExactField> fields_;
};

void examine_vertices(const Fields& fields, const Diagram& diagram, double error, Compare compare, Findings& findings) {
  for (std::size_t i = 0; i < diagram.vertex_distance.size(); ++i) {
    const VertexId v(i);
    const double best = fields.least(v), given = diagram.vertex_distance[v];
    if (std::isinf(best) && std::isinf(given)) continue;
    if (!(std::abs(best - given) <= error)) {
      findings.push_back(fmt::format("vertex {}: the distance is {} instead of {}", i, given, best));
    } else if (const GeneratorId g = diagram.vertex_label[v];
               compare == Compare::all && fields.distance(g, v) - best > error) {
      findings.push_back(fmt::format("vertex {}: generator {} is farther than the nearest by {}", i, g.value(),
                                     fields.distance(g, v) - best));
    }
  }
}

void examine_crossings(const Fields& fields, const Diagram& diagram, double error, Findings& findings) {
  for (std::size_t i = 0; i < diagram.bisectors.size(); ++i) {
    const Bisector& bisector = diagram.bisectors[BisectorId(i)];
    for (std::size_t k = 0; k < bisector.points.size(); ++k) {
      const SurfacePoint& p = bisector.points[k];
      const bool is_branch_point =
          (k == 0 && bisector.ends[0].valid()) || (k + 1 == bisector.points.size() && bisector.ends[1].valid());
      if (is_branch_point || p.kind() == SurfacePoint::Kind::face) continue;  // within the chord tolerance only
      const double left = fields.distance(bisector.left, p), right = fields.distance(bisector.right, p);
      const double best = fields.least(p);
      if (std::abs(left - right) <= error && std::min(left, right) - best <= error) continue;
      findings.push_back(fmt::format("bisector {} at face {}: distances {} and {}, the least is {}", i, p.face.value(),
                                     left, right, best));
    }
  }
}

}  // namespace

Findings examine(const Error& error) {
  Findings findings;
  const std::string line = error.what();
  if (line.find_first_of("\n\r") != std::string::npos) findings.push_back("the message has several lines: " + line);
  if (line.size() < 15 || line.back() == '.')
    findings.push_back("the message is too short, or ends with a full stop: " + line);
  return findings;
}

Findings examine(const Mesh& mesh, const Diagram& diagram) {
  Findings findings = check_diagram(mesh, diagram).violations;
  if (diagram.report.unresolved_ends != 0) findings.push_back("an end of a bisector is unresolved");
  for (std::size_t i = 0; i < diagram.vertex_distance.size(); ++i) {
    const VertexId v(i);
    const double d = diagram.vertex_distance[v];
    if (!(d >= 0) || std::isinf(d) == diagram.vertex_label[v].valid()) {
      findings.push_back(
          fmt::format("vertex {}: the distance {} with the label {}", i, d, diagram.vertex_label[v].value()));
    }
  }
  for (const Bisector& bisector : diagram.bisectors) {
    for (const SurfacePoint& p : bisector.points) examine_point(p, "a point of a bisector", findings);
  }
  for (const BranchPoint& branch : diagram.branch_points) {
    examine_point(branch.point, "a branch point", findings);
    if (!std::isfinite(branch.distance)) findings.push_back("the distance of a branch point is not finite");
  }
  if (!std::isfinite(diagram.length)) findings.push_back("the length is not finite");
  return findings;
}

Findings examine_distances(const Mesh& mesh, const Diagram& diagram, Compare compare) {
  Findings findings;
  const Fields fields(mesh, diagram.generators);
  const double error = allowed_error(mesh);
  examine_vertices(fields, diagram, error, compare, findings);
  if (compare == Compare::all) examine_crossings(fields, diagram, error, findings);
  return findings;
}

Findings examine_segmentation(const Mesh& mesh, const Diagram& diagram) {
  Findings findings;
  const Segmentation segmentation = segment_faces(mesh, diagram);
  const std::size_t components = count_components(mesh, segmentation.face_label);
  const std::size_t labels = count_labels(segmentation.face_label);
  if (components != labels) {
    findings.push_back(fmt::format("segmentation: {} labels in {} components", labels, components));
  }
  if (labels + segmentation.without_face.size() != diagram.generators.size()) {
    findings.push_back("segmentation: a generator without a face is not listed");
  }
  return findings;
}

Findings examine_cut(const Mesh& mesh, const Diagram& diagram) {
  Findings findings;
  if (!is_cheap_to_cut(diagram)) return findings;
  const CutMesh cut = cut_faces(mesh, diagram);
  const MeshSummary before = compute_mesh_summary(mesh), after = compute_mesh_summary(cut.mesh);
  if (before.components != after.components || before.boundary_loops != after.boundary_loops ||
      before.euler_characteristic != after.euler_characteristic) {
    findings.push_back("cut: another topology");
  }
  const double extent = before.bbox_diagonal * before.bbox_diagonal;
  if (!(std::abs(before.area - after.area) <= 1e-9 * (before.area + extent))) {
    findings.push_back(fmt::format("cut: the area is {} instead of {}", after.area, before.area));
  }
  return findings;
}

}  // namespace gvd::test
