// A mesh whose long edges are split, so that samplings can choose points on edges and in faces.
//
// Idea: a queue returns the longest edge. A split halves this edge, adds a face on each side of it, and queues the new
// edges. The corners of each new face have coordinates in its parent that are exact binary fractions.
// Source: Rosenberg and Stenger, A lower bound on the angles of triangles constructed by bisecting the longest side,
// 1975.
// Invariant: the faces of the copy in a face of the input cover it.
#include "geodesic/sampling/sampling_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <utility>
#include <vector>

#include "gvd/sampling.hpp"
#include "mesh/mesh_editor.hpp"

namespace gvd {
namespace {

/// Splits between two reports of progress. A split takes time in proportion to the faces round its ends, which may be
/// all faces.
constexpr std::int64_t kSplitStride = 1 << 6;

}  // namespace

std::int64_t max_splits(const Mesh& mesh, std::int64_t count) {
  return std::min<std::int64_t>(4 * (mesh.vertex_count() + count), kMaxSamplingVertices);
}

SamplingMesh::SamplingMesh(const Mesh& input, const SplitOptions& options, const Progress& progress) : input_(&input) {
  if (longest_edge(input) <= options.max_edge_length && input.vertex_count() >= options.min_vertices) return;
  split_ = true;
  copy_ = input;
  subfaces_.reserve(copy_.face_count());
  for (const FaceId f : copy_.faces()) subfaces_.push_back({f, kWholeTriangle});
  // The longest edge is on top, and of equally long ones the one with the least id.
  using LongEdge = std::pair<double, EdgeId>;
  const auto precedes = [](const LongEdge& a, const LongEdge& b) {
    return a.first < b.first || (a.first == b.first && a.second > b.second);
  };
  std::vector<LongEdge> edges;
  edges.reserve(input.edge_count());
  for (const EdgeId e : input.edges()) edges.emplace_back(input.length(e), e);
  std::priority_queue<LongEdge, std::vector<LongEdge>, decltype(precedes)> queue(precedes, std::move(edges));
  for (;;) {
    const auto [length, edge] = queue.top();
    const std::int64_t vertices = copy_.vertex_count();
    const bool is_long = length > options.max_edge_length && vertices - input.vertex_count() < options.max_added;
    if (!is_long && vertices >= options.min_vertices) break;
    queue.pop();
    if (length != copy_.length(edge)) continue;  // one half of an edge that was split
    if (vertices % kSplitStride == 0) report_progress(progress, "splitting edges", share_done(options, length));
    const std::int32_t before = copy_.edge_count();
    split(edge);
    queue.emplace(copy_.length(edge), edge);
    for (std::int32_t e = before; e < copy_.edge_count(); ++e) queue.emplace(copy_.length(EdgeId(e)), EdgeId(e));
  }
}

/// The share of the work that is done, given that the number of vertices grows with the inverse square of the longest
/// edge.
double SamplingMesh::share_done(const SplitOptions& options, double longest) const {
  const double added = copy_.vertex_count() - input_->vertex_count();
  const double by_length = std::pow(std::min(1.0, options.max_edge_length / longest), 2);
  const double asked = double(options.min_vertices - input_->vertex_count());
  return std::min(by_length, asked > 0 ? std::min(1.0, added / asked) : 1.0);
}

void SamplingMesh::split(EdgeId e) {
  const HalfedgeId h = copy_.halfedge(e), twin = copy_.twin(h);
  const Vec3 middle = 0.5 * copy_.position(copy_.from(h)) + 0.5 * copy_.position(copy_.to(h));
  const FaceId appended(copy_.face_count());
  MeshEditor(copy_).split_edge(h, middle);
  subfaces_.resize(copy_.face_count());
  split_subface(h, appended);
  if (twin.valid()) split_subface(twin, FaceId(appended.value() + 1));
}

/// Records the split of h = (a, b): its face is now (a, middle, c), and `appended` is (middle, b, c).
void SamplingMesh::split_subface(HalfedgeId h, FaceId appended) {
  SubFace& subface = subfaces_[Mesh::face(h)];
  const int i = Mesh::corner(h);
  const Bary a = subface.corners[i], b = subface.corners[(i + 1) % 3], c = subface.corners[(i + 2) % 3];
  const Bary middle = mix(a, b, 0.5);
  subface.corners = {a, middle, c};
  subfaces_[appended] = {subface.parent, {middle, b, c}};
}

SurfacePoint SamplingMesh::to_input(const SurfacePoint& point) const {
  if (!split_) return point;
  const SubFace& subface = subfaces_[point.face];
  return make_surface_point(subface.parent, compose(subface.corners, point.bary));
}

SurfacePoint SamplingMesh::to_input(VertexId v) const {
  if (v.value() < input_->vertex_count()) return vertex_point(*input_, v);
  return to_input(vertex_point(copy_, v));
}

}  // namespace gvd
