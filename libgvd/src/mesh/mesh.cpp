// Builds the connectivity of a triangle mesh (twins, edges and a halfedge for each vertex), changes it by splits and
// flips, and measures the whole mesh.
//
// Halfedge 3 f + i runs from corner i of face f to the next corner, so only twins and edges need tables. `visit_edges`
// lists the halfedges of each edge by a counting sort. Edges are numbered in the order of their first halfedges. A
// boundary vertex stores its boundary halfedge, so that walking in one direction visits all faces around any vertex.
// The lengths and the area of a face are stored together, because distances read them together. Cost: O(n) time, about
// 100 bytes a face.
// A split or flip first reads the twins and edges around the faces that it rewrites, then writes the faces, then links
// their halfedges again. Splitting an edge means splitting the face on each of its sides, so that edges on the boundary
// need no special case.
// The quality figures of triangles and valences are the figures that section 5 of the paper tabulates for remeshes. Q
// relates the area to the half perimeter and the longest edge, and is 1 only for equilateral triangles. Angles are
// computed as atan2 of cross and dot product, which is accurate for very small and very flat angles, too.
// Invariant: a mesh that breaks one of the properties in mesh.hpp is refused here, so no later step checks them again.
// The stored halfedge of a boundary vertex is its boundary halfedge, which the walk in vertex_ring.hpp needs; a split
// or flip restores it by `set_halfedge` for every vertex of the rewritten faces. Faces that a split or flip does not
// touch keep their ids. Sums run over the faces in the order of their ids, so that a figure has the same last digit in
// every run.
#include "gvd/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <tuple>

#include "base/angles.hpp"
#include "base/union_find.hpp"
#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {
namespace {

Error broken(const std::string& message, std::int64_t element) { return {ErrorCode::precondition, message, element}; }

std::optional<Error> check_indices(const IdVector<FaceId, std::array<VertexId, 3>>& faces, std::int32_t vertex_count) {
  for (const FaceId f : faces.ids()) {
    for (const VertexId v : faces[f]) {
      if (v.valid() && v.value() < vertex_count) continue;
      return broken(fmt::format("face {} refers to vertex {}, and there are {}", f.value(), v.value(), vertex_count),
                    f.value());
    }
    const auto& [a, b, c] = faces[f];
    if (a == b || b == c || c == a)
      return broken(fmt::format("face {} has the same vertex twice", f.value()), f.value());
  }
  return std::nullopt;
}

std::optional<Error> check_positions(const IdVector<VertexId, Vec3>& positions) {
  for (const VertexId v : positions.ids()) {
    if (positions[v].allFinite()) continue;
    return broken(fmt::format("vertex {} has a coordinate that is not finite", v.value()), v.value());
  }
  return std::nullopt;
}

std::string edge_name(const Mesh& mesh, HalfedgeId h) {
  return fmt::format("{}-{}", mesh.from(h).value(), mesh.to(h).value());
}

/// An angle counts as below 30 degrees if it is smaller by more than this, in degrees. With coordinates of 12 digits an
/// angle of 30 degrees is off by about 1e-10, and the triangles of a regular mesh must not count.
constexpr double kAngleSlack = 1e-9;

/// The least angle is opposite the shortest side. Sides whose squared length is at most this multiple of the shortest
/// one's are measured as well, so that rounding does not decide. The slack is a million times the rounding.
constexpr double kShortest = 1 + 1e-9;

double angle_at(const Vec3& a, const Vec3& b, const Vec3& c) {
  return angle_between(b - a, c - a) * 180 / std::numbers::pi;
}

}  // namespace

Mesh::Mesh(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces)
    : positions_(std::move(positions)), faces_(std::move(faces)) {
  if (const auto error = build()) throw *error;
}

OrError<Mesh> Mesh::try_to_build(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces) {
  Mesh mesh;
  mesh.positions_ = IdVector<VertexId, Vec3>(std::move(positions));
  mesh.faces_ = IdVector<FaceId, std::array<VertexId, 3>>(std::move(faces));
  if (auto error = mesh.build()) return *std::move(error);
  return mesh;
}

std::optional<Error> Mesh::build() {
  if (auto error = check_positions(positions_)) return error;
  if (auto error = check_indices(faces_, vertex_count())) return error;
  if (auto error = link_twins()) return error;
  number_edges();
  if (auto error = find_vertex_halfedges()) return error;
  return measure();
}

std::optional<Error> Mesh::link_twins() {
  std::optional<Error> error;
  twin_.assign(halfedge_count(), HalfedgeId());
  visit_edges(faces_, positions_.size(), [&](const EdgeHalfedges& edge) {
    const HalfedgeId h(edge[0]);
    if (edge.size() == 1 || error) return;
    const HalfedgeId twin(edge[1]);
    if (edge.size() > 2) {
      error =
          broken(fmt::format("edge {} has {} faces, first face {}", edge_name(*this, h), edge.size(), face(h).value()),
                 face(h).value());
    } else if (from(h) == from(twin)) {
      error = broken(fmt::format("faces {} and {} run through edge {} in the same direction", face(h).value(),
                                 face(twin).value(), edge_name(*this, h)),
                     face(h).value());
    }
    twin_[h] = twin;
    twin_[twin] = h;
  });
  return error;
}

void Mesh::number_edges() {
  halfedge_edge_.assign(halfedge_count(), EdgeId());
  edge_halfedge_.reserve(halfedge_count() / 2);
  for (const HalfedgeId h : halfedges()) {
    if (halfedge_edge_[h].valid()) continue;
    const EdgeId e = edge_halfedge_.push_back(h);
    halfedge_edge_[h] = e;
    if (twin_[h].valid()) halfedge_edge_[twin_[h]] = e;
  }
}

std::optional<Error> Mesh::find_vertex_halfedges() {
  vertex_halfedge_.assign(positions_.size(), HalfedgeId());
  IdVector<VertexId, std::int32_t> degree(positions_.size(), 0);
  for (const HalfedgeId h : halfedges()) {
    ++degree[from(h)];
    HalfedgeId& chosen = vertex_halfedge_[from(h)];
    if (!chosen.valid() || (!twin_[h].valid() && twin_[chosen].valid())) chosen = h;
  }
  for (const VertexId v : vertices()) {
    if (!vertex_halfedge_[v].valid()) return broken(fmt::format("vertex {} belongs to no face", v.value()), v.value());
    std::int32_t visited = 0;
    for_each_outgoing(*this, v, [&](HalfedgeId) { ++visited; });
    if (visited != degree[v]) return broken(fmt::format("vertex {} joins several fans of faces", v.value()), v.value());
  }
  return std::nullopt;
}

std::optional<Error> Mesh::measure() {
  shape_.resize(faces_.size());
  for (const FaceId f : faces()) measure_face(f);
  double sum = 0;
  for (const HalfedgeId h : edge_halfedge_) {
    const double length = this->length(h);
    if (!(length > 0) || !std::isfinite(length)) {
      return broken(fmt::format("edge {} of face {} has length {}", edge_name(*this, h), face(h).value(),
                                length > 0 ? "infinity" : "0"),
                    face(h).value());
    }
    sum += length;
  }
  mean_edge_length_ = edge_count() > 0 ? sum / edge_count() : 0;
  if (vertex_count() == 0) return std::nullopt;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions_) box.extend(p);
  bbox_diagonal_ = box.sizes().stableNorm();
  largest_coordinate_ = std::max(box.max().maxCoeff(), -box.min().minCoeff());
  return std::nullopt;
}

// stableNorm scales first, so that the squares of very large or very small coordinates neither overflow nor underflow.
void Mesh::measure_face(FaceId f) {
  const auto& [a, b, c] = vertices(f);
  const Vec3 ab = position(b) - position(a), bc = position(c) - position(b), ca = position(a) - position(c);
  shape_[f] = {{ab.stableNorm(), bc.stableNorm(), ca.stableNorm()}, ab.cross(ca).stableNorm()};
}

double compute_area(const Mesh& mesh) {
  double area = 0;
  for (const FaceId f : mesh.faces()) area += mesh.area(f);
  return area;
}

double longest_edge(const Mesh& mesh) {
  double longest = 0;
  for (const EdgeId e : mesh.edges()) longest = std::max(longest, mesh.length(e));
  return longest;
}

IdVector<FaceId, std::int32_t> compute_face_components(const Mesh& mesh) {
  UnionFind sets(mesh.face_count());
  for (const HalfedgeId h : mesh.halfedges()) {
    if (mesh.twin(h).valid()) sets.unite(Mesh::face(h).value(), Mesh::face(mesh.twin(h)).value());
  }
  IdVector<FaceId, std::int32_t> component(mesh.face_count());
  std::int32_t count = 0;
  for (const FaceId f : mesh.faces()) {
    const FaceId first(sets.find(f.value()));  // the component's smallest face
    component[f] = first == f ? count++ : component[first];
  }
  return component;
}

MeshSummary compute_mesh_summary(const Mesh& mesh) {
  MeshSummary summary;
  summary.vertices = mesh.vertex_count();
  summary.edges = mesh.edge_count();
  summary.faces = mesh.face_count();
  for (const std::int32_t c : compute_face_components(mesh)) summary.components = std::max(summary.components, c + 1);
  for_each_boundary_loop(mesh, [&](HalfedgeId) { ++summary.boundary_loops; });
  summary.euler_characteristic = summary.vertices - summary.edges + summary.faces;
  summary.area = compute_area(mesh);
  summary.bbox_diagonal = mesh.bbox_diagonal();
  return summary;
}

double compute_q(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = (b - a).norm(), bc = (c - b).norm(), ca = (a - c).norm();
  const double longest = std::max({ab, bc, ca});
  if (longest == 0) return 0;
  const double area = (b - a).cross(c - a).norm() / 2;
  const double half_perimeter = (ab + bc + ca) / 2;
  return std::min(1.0, 6 / std::numbers::sqrt3 * area / (half_perimeter * longest));
}

double compute_min_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double opposite_a = (c - b).squaredNorm(), opposite_b = (a - c).squaredNorm(),
               opposite_c = (b - a).squaredNorm();
  const double shortest = kShortest * std::min({opposite_a, opposite_b, opposite_c});
  double least = 180;
  if (!(opposite_a > shortest)) least = std::min(least, angle_at(a, b, c));
  if (!(opposite_b > shortest)) least = std::min(least, angle_at(b, c, a));
  if (!(opposite_c > shortest)) least = std::min(least, angle_at(c, a, b));
  return least;
}

TriangleQuality compute_triangle_quality(const Mesh& mesh) {
  TriangleQuality quality;
  if (mesh.face_count() == 0) return quality;
  quality.q_min = 1;
  quality.angle_min = 60;
  std::int32_t below = 0;
  for (const FaceId f : mesh.faces()) {
    const auto& [i, j, k] = mesh.vertices(f);
    const Vec3 &a = mesh.position(i), &b = mesh.position(j), &c = mesh.position(k);
    const double q = compute_q(a, b, c), angle = compute_min_angle(a, b, c);
    quality.q_min = std::min(quality.q_min, q);
    quality.q_average += q;
    quality.angle_min = std::min(quality.angle_min, angle);
    quality.angle_min_average += angle;
    if (angle < 30 - kAngleSlack) ++below;
  }
  quality.q_average /= mesh.face_count();
  quality.angle_min_average /= mesh.face_count();
  quality.percent_below_30 = 100.0 * below / mesh.face_count();
  return quality;
}

Valences compute_valences(const Mesh& mesh) {
  if (mesh.vertex_count() == 0) return {};
  IdVector<VertexId, std::int32_t> edges(mesh.vertex_count(), 0);
  for (const EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    ++edges[mesh.from(h)];
    ++edges[mesh.to(h)];
  }
  const auto [least, largest] = std::minmax_element(edges.begin(), edges.end());
  std::int32_t regular = 0;
  for (const VertexId v : mesh.vertices()) regular += edges[v] == (mesh.is_boundary(v) ? 4 : 6);
  return {*least, *largest, 100.0 * regular / mesh.vertex_count()};
}

void MeshEditor::copy(const Mesh& other, std::size_t vertices) {
  const std::size_t faces = other.faces_.size() + 2 * vertices;
  mesh_.positions_.reserve(other.positions_.size() + vertices);
  mesh_.vertex_halfedge_.reserve(other.positions_.size() + vertices);
  mesh_.faces_.reserve(faces);
  mesh_.shape_.reserve(faces);
  mesh_.twin_.reserve(3 * faces);
  mesh_.halfedge_edge_.reserve(3 * faces);
  mesh_.edge_halfedge_.reserve(other.edge_halfedge_.size() + 3 * vertices);
  mesh_ = other;  // keeps the capacity
}

FaceId MeshEditor::add_face() {
  for (int i = 0; i < 3; ++i) {
    mesh_.twin_.push_back(HalfedgeId());
    mesh_.halfedge_edge_.push_back(EdgeId());
  }
  mesh_.shape_.push_back({});
  return mesh_.faces_.push_back({});
}

void MeshEditor::link(HalfedgeId h, HalfedgeId t, EdgeId e) {
  mesh_.twin_[h] = t;
  mesh_.halfedge_edge_[h] = e;
  mesh_.edge_halfedge_[e] = h;
  if (t.valid()) {
    mesh_.twin_[t] = h;
    mesh_.halfedge_edge_[t] = e;
  }
}

void MeshEditor::set_halfedge(VertexId v, HalfedgeId h) {
  const auto begins_fan = [&](HalfedgeId x) { return x.valid() && mesh_.from(x) == v && !mesh_.twin(x).valid(); };
  if (begins_fan(mesh_.vertex_halfedge_[v])) return;
  const HalfedgeId before = previous_outgoing(mesh_, h);
  mesh_.vertex_halfedge_[v] = begins_fan(before) ? before : h;
}

VertexId MeshEditor::split_face(FaceId f, const Vec3& position) {
  const auto [a, b, c] = mesh_.vertices(f);
  const HalfedgeId ab = Mesh::halfedge(f, 0), bc = Mesh::halfedge(f, 1), ca = Mesh::halfedge(f, 2);
  const HalfedgeId twin_bc = mesh_.twin(bc), twin_ca = mesh_.twin(ca);
  const EdgeId edge_bc = mesh_.edge(bc), edge_ca = mesh_.edge(ca);
  const VertexId v = add_vertex(position);
  const FaceId g = add_face(), k = add_face();
  set_face(f, a, b, v);
  set_face(g, b, c, v);
  set_face(k, c, a, v);
  link(Mesh::halfedge(g, 0), twin_bc, edge_bc);
  link(Mesh::halfedge(k, 0), twin_ca, edge_ca);
  const std::array<EdgeId, 3> spokes{add_edge(), add_edge(), add_edge()};
  link(Mesh::halfedge(f, 1), Mesh::halfedge(g, 2), spokes[0]);
  link(Mesh::halfedge(g, 1), Mesh::halfedge(k, 2), spokes[1]);
  link(Mesh::halfedge(k, 1), Mesh::halfedge(f, 2), spokes[2]);
  set_halfedge(v, Mesh::halfedge(f, 2));
  set_halfedge(a, ab);
  set_halfedge(b, Mesh::halfedge(g, 0));
  set_halfedge(c, Mesh::halfedge(k, 0));
  return v;
}

std::pair<HalfedgeId, HalfedgeId> MeshEditor::split_side(HalfedgeId side, VertexId v) {
  const FaceId f = Mesh::face(side);
  const VertexId p = mesh_.from(side), q = mesh_.to(side), r = mesh_.opposite(side);
  const HalfedgeId qr = Mesh::next(side), rp = Mesh::previous(side);
  const HalfedgeId twin_qr = mesh_.twin(qr), twin_rp = mesh_.twin(rp);
  const EdgeId edge_qr = mesh_.edge(qr), edge_rp = mesh_.edge(rp);
  const FaceId g = add_face();
  set_face(f, p, v, r);
  set_face(g, v, q, r);
  link(Mesh::halfedge(f, 2), twin_rp, edge_rp);
  link(Mesh::halfedge(g, 1), twin_qr, edge_qr);
  const EdgeId edge_vr = add_edge();
  link(Mesh::halfedge(f, 1), Mesh::halfedge(g, 2), edge_vr);
  return {Mesh::halfedge(f, 0), Mesh::halfedge(g, 0)};
}

VertexId MeshEditor::split_edge(HalfedgeId h, const Vec3& position) {
  const HalfedgeId t = mesh_.twin(h);
  const EdgeId edge_av = mesh_.edge(h);
  const EdgeId edge_vb = add_edge();
  const VertexId a = mesh_.from(h), b = mesh_.to(h), v = add_vertex(position);
  const VertexId c = mesh_.opposite(h);
  const VertexId d = t.valid() ? mesh_.opposite(t) : VertexId();
  const auto [av, vb] = split_side(h, v);
  HalfedgeId va, bv;
  if (t.valid()) std::tie(bv, va) = split_side(t, v);
  link(av, va, edge_av);
  link(vb, bv, edge_vb);
  set_halfedge(v, vb);
  set_halfedge(a, av);
  set_halfedge(b, Mesh::next(vb));
  set_halfedge(c, Mesh::previous(av));
  if (d.valid()) set_halfedge(d, Mesh::previous(bv));
  return v;
}

void MeshEditor::flip_edge(HalfedgeId h) {
  const HalfedgeId t = mesh_.twin(h);
  const FaceId f = Mesh::face(h), g = Mesh::face(t);
  const VertexId a = mesh_.from(h), b = mesh_.to(h), c = mesh_.opposite(h), d = mesh_.opposite(t);
  const HalfedgeId bc = Mesh::next(h), ca = Mesh::previous(h), ad = Mesh::next(t), db = Mesh::previous(t);
  struct Side {
    HalfedgeId twin;
    EdgeId edge;
  };
  const auto side = [&](HalfedgeId x) { return Side{mesh_.twin(x), mesh_.edge(x)}; };
  const Side side_bc = side(bc), side_ca = side(ca), side_ad = side(ad), side_db = side(db);
  const EdgeId diagonal = mesh_.edge(h);
  set_face(f, d, b, c);
  set_face(g, c, a, d);
  link(Mesh::halfedge(f, 0), side_db.twin, side_db.edge);
  link(Mesh::halfedge(f, 1), side_bc.twin, side_bc.edge);
  link(Mesh::halfedge(g, 0), side_ca.twin, side_ca.edge);
  link(Mesh::halfedge(g, 1), side_ad.twin, side_ad.edge);
  link(Mesh::halfedge(f, 2), Mesh::halfedge(g, 2), diagonal);
  set_halfedge(a, Mesh::halfedge(g, 1));
  set_halfedge(b, Mesh::halfedge(f, 1));
  set_halfedge(c, Mesh::halfedge(g, 0));
  set_halfedge(d, Mesh::halfedge(f, 0));
}

}  // namespace gvd
