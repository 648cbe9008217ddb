// Figures of a diagram by exact distances, the same for all comparators and all methods of the library.
//
// E integrates the difference of the exact distances from the two generators along each bisector (section 5.2 of the
// paper): 0 where a bisector lies right, and as large as the distances where a cell goes astray. Fields are computed on
// the part of the mesh that shortest paths can visit, which changes no distance. The turning angle tells what E does
// not: bisectors that zig-zag within a triangle (figure 10). Wrong labels count vertices, with or without a bisector
// nearby. The other errors are integrals that could be taken for E; they tell which one the paper's numbers are.
// Invariant: no figure reads what a method computed for itself, such as its own distances.
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "path_submesh.hpp"

namespace gvd::paper {

namespace {

/// Shorter steps have no direction: a fraction of the mean edge length.
constexpr double kLeastStep = 1e-9;

/// A straight piece of a bisector, in one face.
struct Step {
  SurfacePoint begin, end;
  Vec3 vector;
};

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// The pieces of a bisector that are long enough to have a direction, each seen in the face that contains it.
std::vector<Step> take_steps(const Mesh& mesh, const Bisector& bisector) {
  std::vector<Step> steps;
  const std::size_t n = bisector.points.size();
  for (std::size_t i = 0; i + (bisector.closed ? 0 : 1) < n; ++i) {
    const auto view = find_common_view(mesh, bisector.points[i], bisector.points[(i + 1) % n]);
    if (!view) throw Error(ErrorCode::precondition, "consecutive points of a bisector share no face");
    const Vec3 vector = position(mesh, view->second) - position(mesh, view->first);
    if (vector.norm() > kLeastStep * mesh.mean_edge_length()) steps.push_back({view->first, view->second, vector});
  }
  return steps;
}

/// In one face the angle in space; from face to face the difference of the angles with the edge between them.
double turning_angle(const Mesh& mesh, const Step& from, const Step& to) {
  const bool on_edge = from.end.kind() == SurfacePoint::Kind::edge;
  if (from.begin.face == to.begin.face || !on_edge) return angle_between(from.vector, to.vector);
  const HalfedgeId h = halfedge(from.end);
  const Vec3 edge = mesh.position(mesh.to(h)) - mesh.position(mesh.from(h));
  return std::abs(angle_between(from.vector, edge) - angle_between(to.vector, edge));
}

}  // namespace

double sum_turning_angles(const Mesh& mesh, const Diagram& diagram) {
  double sum = 0;
  for (const Bisector& bisector : diagram.bisectors) {
    const std::vector<Step> steps = take_steps(mesh, bisector);
    const std::size_t turns = bisector.closed ? steps.size() : std::max<std::size_t>(steps.size(), 1) - 1;
    for (std::size_t i = 0; i < turns; ++i) sum += turning_angle(mesh, steps[i], steps[(i + 1) % steps.size()]);
  }
  return sum;
}

namespace {

/// The distances of one query, by a field of its generator alone.
std::vector<double> solve(const Mesh& mesh, const DistanceQuery& query) {
  PathSubmesh part = extract_path_submesh(mesh, query);
  if (part.targets.empty()) return std::move(part.distances);
  const Mesh submesh(std::move(part.positions), std::move(part.faces));
  const ExactField field(submesh, {vertex_point(submesh, part.source)});
  for (const PathSubmesh::Target& target : part.targets) {
    const SurfacePoint point = make_surface_point(target.face, target.bary);
    part.distances[target.point] = field.nearest(point).distance;
  }
  return std::move(part.distances);
}

}  // namespace

std::vector<std::vector<double>> compute_field_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries) {
  std::vector<std::vector<double>> answers;
  for (const DistanceQuery& query : queries) answers.push_back(solve(mesh, query));
  return answers;
}

/// Only the vertices with another label than the exact one need a distance of their own.
std::int64_t Judge::count_wrong_labels(const Diagram& diagram) const {
  std::vector<DistanceQuery> queries(diagram.generators.size());
  std::vector<std::vector<double>> allowed(queries.size());
  std::int64_t wrong = 0;
  for (std::size_t g = 0; g < queries.size(); ++g) queries[g].generator = diagram.generators[g];
  for (const VertexId v : mesh_.vertices()) {
    const GeneratorId label = diagram.vertex_label[v];
    if (label == nearest_.label(v) || !nearest_.label(v).valid()) continue;
    wrong += label.valid() ? 0 : 1;
    if (!label.valid()) continue;
    queries[label.index()].points.push_back(vertex_point(mesh_, v));
    allowed[label.index()].push_back(nearest_.distance(v) * (1 + kEquallyNear));
  }
  const auto distances = compute_field_distances(mesh_, queries);
  for (std::size_t g = 0; g < queries.size(); ++g) {
    for (std::size_t i = 0; i < allowed[g].size(); ++i) wrong += distances[g][i] <= allowed[g][i] ? 0 : 1;
  }
  return wrong;
}

Judgement Judge::judge(const Diagram& diagram) const {
  const auto exact = [&](const std::vector<DistanceQuery>& queries) { return compute_field_distances(mesh_, queries); };
  Judgement result;
  result.error = compute_error_measure(mesh_, diagram, exact);
  result.turning_angle = sum_turning_angles(mesh_, diagram);
  result.wrong_labels = count_wrong_labels(diagram);
  for (const VertexId v : mesh_.vertices()) result.labelled += nearest_.label(v).valid() ? 1 : 0;
  return result;
}

namespace {

/// Midpoints of this many equal parts of each segment are sampled: the figures are compared to two digits.
constexpr int kParts = 4;

/// Distances at the vertices by marching with planar fronts, as the paper computes them (section 4.1).
IdVector<VertexId, double> march_from(const Mesh& mesh, const SurfacePoint& generator) {
  DiagramOptions options;
  options.method = Method::gbgvd;
  options.front = Front::planar;
  options.threads = 1;
  return compute_diagram(mesh, {generator}, options).vertex_distance;
}

}  // namespace

OtherJudge::OtherJudge(const Mesh& mesh, const std::vector<SurfacePoint>& generators) : mesh_(mesh) {
  for (const SurfacePoint& g : generators) {
    exact_.emplace_back(mesh, std::vector<SurfacePoint>{g});
    marched_.push_back(march_from(mesh, g));
    positions_.push_back(position(mesh, g));
  }
}

/// The generators that own a part of each face, whole faces included.
OtherJudge::Owners OtherJudge::find_owners(const Diagram& diagram) const {
  Owners owners(mesh_.face_count());
  for (std::size_t f = 0; f < owners.size(); ++f) {
    const GeneratorId label = diagram.face_label.raw()[f];
    if (label.valid()) owners[f].push_back(label);
  }
  for (const FacePiece& piece : diagram.pieces) {
    if (piece.generator.valid()) owners[piece.face.index()].push_back(piece.generator);
  }
  return owners;
}

/// The largest difference of the distances from all owners of a face and from the bisector's generators.
double OtherJudge::find_spread(const std::vector<GeneratorId>& owners, const Bisector& bisector,
                               const SurfacePoint& p) const {
  double least = exact(bisector.left, p), most = least;
  const auto add = [&](GeneratorId g) {
    const double d = exact(g, p);
    least = std::min(least, d);
    most = std::max(most, d);
  };
  add(bisector.right);
  for (const GeneratorId g : owners) {
    if (g != bisector.left && g != bisector.right) add(g);
  }
  return most - least;
}

/// The midpoint rule on kParts parts of a segment; all integrals have the same points.
void OtherJudge::add_segment(const Bisector& bisector, std::size_t i, const Owners& owners, OtherErrors& sum) const {
  const auto view = find_common_view(mesh_, bisector.points[i], bisector.points[(i + 1) % bisector.points.size()]);
  if (!view) return;
  const auto& [from, to] = *view;
  const double length = (position(mesh_, to) - position(mesh_, from)).norm() / kParts;
  if (length == 0) return;
  for (int part = 0; part < kParts; ++part) {
    const SurfacePoint p = make_surface_point(from.face, mix(from.bary, to.bary, (part + 0.5) / kParts));
    sum.by_marching += length * std::abs(march(bisector.left, p) - march(bisector.right, p));
    sum.of_face += length * find_spread(owners[from.face.index()], bisector, p);
    sum.by_straight += length * std::abs(straight(bisector.left, p) - straight(bisector.right, p));
    sum.distance += length * exact(bisector.left, p);
  }
}

OtherErrors OtherJudge::judge(const Diagram& diagram) const {
  const Owners owners = find_owners(diagram);
  OtherErrors sum;
  for (const Bisector& bisector : diagram.bisectors) {
    if (bisector.points.size() < 2) continue;
    const std::size_t segments = bisector.points.size() - (bisector.closed ? 0 : 1);
    for (std::size_t i = 0; i < segments; ++i) add_segment(bisector, i, owners, sum);
  }
  return sum;
}

}  // namespace gvd::paper
