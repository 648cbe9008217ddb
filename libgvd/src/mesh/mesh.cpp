// The connectivity of a triangle mesh: twins, edges and a halfedge for each vertex, and the figures of the whole mesh.
//
// Halfedge 3 f + i runs from corner i of face f to the next corner, so only twins and edges need tables. `visit_edges`
// lists the halfedges of each edge by a counting sort. Edges get their numbers in the order of their first halfedge.
// A vertex keeps its boundary halfedge where it has one: so one direction suffices to walk round every vertex. Lengths
// and areas of a face lie together, as distances read them. Cost: O(n) time, about 100 bytes a face.
// Invariant: a mesh that breaks one of the properties in mesh.hpp is refused here, so no later step checks them again.
#include "gvd/mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/union_find.hpp"
#include "gvd/error.hpp"
#include "mesh/vertex_ring.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(const std::string& message, std::int64_t element) {
  throw Error(ErrorCode::precondition, message, element);
}

void check_indices(const IdVector<FaceId, std::array<VertexId, 3>>& faces, std::int32_t vertex_count) {
  for (const FaceId f : faces.ids()) {
    for (const VertexId v : faces[f]) {
      if (v.valid() && v.value() < vertex_count) continue;
      refuse(fmt::format("face {} refers to vertex {}, and there are {}", f.value(), v.value(), vertex_count),
             f.value());
    }
    const auto& [a, b, c] = faces[f];
    if (a == b || b == c || c == a) refuse(fmt::format("face {} has the same vertex twice", f.value()), f.value());
  }
}

void check_positions(const IdVector<VertexId, Vec3>& positions) {
  for (const VertexId v : positions.ids()) {
    if (positions[v].allFinite()) continue;
    refuse(fmt::format("vertex {} has a coordinate that is not finite", v.value()), v.value());
  }
}

std::string edge_name(const Mesh& mesh, HalfedgeId h) {
  return fmt::format("{}-{}", mesh.from(h).value(), mesh.to(h).value());
}

/// Number of closed chains of boundary halfedges.
std::int32_t count_boundary_loops(const Mesh& mesh) {
  IdVector<HalfedgeId, char> visited(mesh.halfedge_count(), 0);
  std::int32_t loops = 0;
  for (HalfedgeId h : mesh.halfedges()) {
    if (mesh.twin(h).valid() || visited[h]) continue;
    ++loops;
    for (; !visited[h]; h = next_on_boundary(mesh, h)) visited[h] = 1;
  }
  return loops;
}

}  // namespace

Mesh::Mesh(std::vector<Vec3> positions, std::vector<std::array<VertexId, 3>> faces)
    : positions_(std::move(positions)), faces_(std::move(faces)) {
  check_positions(positions_);
  check_indices(faces_, vertex_count());
  link_twins();
  number_edges();
  find_vertex_halfedges();
  measure();
}

void Mesh::link_twins() {
  twin_.assign(halfedge_count(), HalfedgeId());
  visit_edges(faces_, positions_.size(), [this](const EdgeHalfedges& edge) {
    const HalfedgeId h(edge[0]);
    if (edge.size() > 2) {
      refuse(fmt::format("edge {} has {} faces, first face {}", edge_name(*this, h), edge.size(), face(h).value()),
             face(h).value());
    }
    if (edge.size() == 1) return;
    const HalfedgeId twin(edge[1]);
    if (from(h) == from(twin)) {
      refuse(fmt::format("faces {} and {} run through edge {} in the same direction", face(h).value(),
                         face(twin).value(), edge_name(*this, h)),
             face(h).value());
    }
    twin_[h] = twin;
    twin_[twin] = h;
  });
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

void Mesh::find_vertex_halfedges() {
  vertex_halfedge_.assign(positions_.size(), HalfedgeId());
  IdVector<VertexId, std::int32_t> degree(positions_.size(), 0);
  for (const HalfedgeId h : halfedges()) {
    ++degree[from(h)];
    HalfedgeId& chosen = vertex_halfedge_[from(h)];
    if (!chosen.valid() || (!twin_[h].valid() && twin_[chosen].valid())) chosen = h;
  }
  for (const VertexId v : vertices()) {
    if (!vertex_halfedge_[v].valid()) refuse(fmt::format("vertex {} belongs to no face", v.value()), v.value());
    std::int32_t visited = 0;
    for_each_outgoing(*this, v, [&](HalfedgeId) { ++visited; });
    if (visited != degree[v]) refuse(fmt::format("vertex {} joins several fans of faces", v.value()), v.value());
  }
}

void Mesh::measure() {
  shape_.resize(faces_.size());
  for (const FaceId f : faces()) measure_face(f);
  double sum = 0;
  for (const HalfedgeId h : edge_halfedge_) {
    const double length = this->length(h);
    if (!(length > 0) || !std::isfinite(length)) {
      refuse(fmt::format("edge {} of face {} has length {}", edge_name(*this, h), face(h).value(),
                         length > 0 ? "infinity" : "0"),
             face(h).value());
    }
    sum += length;
  }
  mean_edge_length_ = edge_count() > 0 ? sum / edge_count() : 0;
  if (vertex_count() == 0) return;
  Eigen::AlignedBox3d box;
  for (const Vec3& p : positions_) box.extend(p);
  bbox_diagonal_ = box.sizes().stableNorm();
  largest_coordinate_ = std::max(box.max().maxCoeff(), -box.min().minCoeff());
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
    const FaceId first(sets.find(f.value()));  // the smallest of its component
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
  summary.boundary_loops = count_boundary_loops(mesh);
  summary.euler_characteristic = summary.vertices - summary.edges + summary.faces;
  summary.area = compute_area(mesh);
  summary.bbox_diagonal = mesh.bbox_diagonal();
  return summary;
}

}  // namespace gvd
