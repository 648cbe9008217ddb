#include "cell_loops.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

#include "gvd/closest_point.hpp"

namespace gvd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Where the way from the generator to the loop is longer than this part of the loop, the generator's own cell can't be
/// counted on to be one of the three round it.
constexpr double kLongStick = 1.0 / 6;

}  // namespace

CellLoops::CellLoops(const Mesh& mesh, const Diagram& diagram)
    : mesh_(mesh), diagram_(diagram), cut_(cut_faces(mesh, diagram)) {
  const auto faces = static_cast<std::size_t>(cut_.mesh.face_count());
  const auto vertices = static_cast<std::size_t>(cut_.mesh.vertex_count());
  for (std::size_t i = 0; i < faces; ++i) by_label_.emplace_back(static_cast<std::int64_t>(i));
  std::stable_sort(by_label_.begin(), by_label_.end(),
                   [&](FaceId a, FaceId b) { return cut_.label[a] < cut_.label[b]; });
  distance_.assign(vertices, kInfinity);
  parent_.assign(vertices, VertexId());
  face_node_.assign(faces, -1);
}

std::vector<SurfacePoint> CellLoops::find(GeneratorId cell) {
  const std::vector<FaceId> faces = faces_of(cell);
  if (faces.empty()) return {};
  grow_tree(root(faces, cell), cell);
  HalfedgeId best;
  double least = kInfinity;
  for (const HalfedgeId h : left_over_edges(faces, cell)) {
    const double length = distance_[cut_.mesh.from(h)] + cut_.mesh.length(h) + distance_[cut_.mesh.to(h)];
    if (length < least) std::tie(least, best) = std::tuple(length, h);
  }
  if (!best.valid()) return {};
  return part_in_thirds(close_loop(best), cell);
}

std::vector<FaceId> CellLoops::faces_of(GeneratorId cell) const {
  const auto begin = std::lower_bound(by_label_.begin(), by_label_.end(), cell,
                                      [&](FaceId f, GeneratorId g) { return cut_.label[f] < g; });
  const auto end =
      std::upper_bound(begin, by_label_.end(), cell, [&](GeneratorId g, FaceId f) { return g < cut_.label[f]; });
  return {begin, end};
}

/// The corner of the cell's faces that is nearest to the generator.
VertexId CellLoops::root(const std::vector<FaceId>& faces, GeneratorId cell) const {
  const Vec3 at = position(mesh_, diagram_.generators[cell.index()]);
  VertexId best;
  double least = kInfinity;
  for (const FaceId f : faces) {
    for (const VertexId v : cut_.mesh.vertices(f)) {
      const double d = (cut_.mesh.position(v) - at).squaredNorm();
      if (d < least) std::tie(least, best) = std::tuple(d, v);
    }
  }
  return best;
}

/// Dijkstra's tree along the edges of the cell's faces.
void CellLoops::grow_tree(VertexId root, GeneratorId cell) {
  for (const VertexId v : touched_) {
    distance_[v] = kInfinity;
    parent_[v] = VertexId();
  }
  touched_.clear();
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto reach = [&](VertexId v, double distance, VertexId parent) {
    if (distance >= distance_[v]) return;
    distance_[v] = distance;
    parent_[v] = parent;
    touched_.push_back(v);
    queue.emplace(distance, v);
  };
  reach(root, 0, VertexId());
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distance_[v]) continue;
    const HalfedgeId start = cut_.mesh.halfedge(v);
    HalfedgeId h = start;
    do {
      if (is_inside(h, cell)) {
        const HalfedgeId in = Mesh::previous(h);
        reach(cut_.mesh.to(h), distance + cut_.mesh.length(h), v);
        reach(cut_.mesh.from(in), distance + cut_.mesh.length(in), v);
      }
      h = cut_.mesh.twin(Mesh::previous(h));
    } while (h.valid() && h != start);
  }
}

/// The edges outside of the tree that are dual to cycles, or to paths from one border loop to another: faces and border
/// loops are the nodes of the dual graph, and faces with one link only are taken away until there are none.
std::vector<HalfedgeId> CellLoops::left_over_edges(const std::vector<FaceId>& faces, GeneratorId cell) {
  const auto count = static_cast<std::int32_t>(faces.size());
  for (std::int32_t i = 0; i < count; ++i) face_node_[faces[static_cast<std::size_t>(i)]] = i;
  std::vector<std::pair<HalfedgeId, std::array<std::int32_t, 2>>> links;  // node -1: a border
  std::vector<std::vector<std::int32_t>> links_of(faces.size());
  for (const FaceId f : faces) {
    for (int corner = 0; corner < 3; ++corner) {
      const HalfedgeId h = Mesh::halfedge(f, corner), twin = cut_.mesh.twin(h);
      const bool at_border = is_border(h, cell);
      if (is_tree_edge(h) || (!at_border && twin < h)) continue;
      const auto link = static_cast<std::int32_t>(links.size());
      links.push_back({h, {face_node_[f], at_border ? -1 : face_node_[Mesh::face(twin)]}});
      for (const std::int32_t node : links.back().second) {
        if (node >= 0) links_of[static_cast<std::size_t>(node)].push_back(link);
      }
    }
  }
  std::vector<std::size_t> degree;
  std::vector<std::int32_t> leaves;
  for (std::int32_t i = 0; i < count; ++i) {
    degree.push_back(links_of[static_cast<std::size_t>(i)].size());
    if (degree.back() == 1) leaves.push_back(i);
  }
  std::vector<char> removed(links.size(), 0);
  while (!leaves.empty()) {
    const std::int32_t leaf = leaves.back();
    leaves.pop_back();
    for (const std::int32_t link : links_of[static_cast<std::size_t>(leaf)]) {
      if (removed[static_cast<std::size_t>(link)]) continue;
      removed[static_cast<std::size_t>(link)] = 1;
      for (const std::int32_t node : links[static_cast<std::size_t>(link)].second) {
        if (node >= 0 && --degree[static_cast<std::size_t>(node)] == 1) leaves.push_back(node);
      }
    }
  }
  std::vector<HalfedgeId> left_over;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!removed[i]) left_over.push_back(links[i].first);
  }
  return left_over;
}

/// The tree's paths to both ends of an edge, without what they have in common.
CellLoops::Loop CellLoops::close_loop(HalfedgeId last) const {
  const auto path = [&](VertexId v) {
    std::vector<VertexId> vertices;
    for (; v.valid(); v = parent_[v]) vertices.push_back(v);
    return vertices;
  };
  std::vector<VertexId> first = path(cut_.mesh.from(last)), second = path(cut_.mesh.to(last));
  VertexId fork = first.back();
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    fork = first.back();
    first.pop_back();
    second.pop_back();
  }
  Loop loop;
  loop.stick = distance_[fork];
  loop.vertices.push_back(fork);
  loop.vertices.insert(loop.vertices.end(), first.rbegin(), first.rend());
  loop.vertices.insert(loop.vertices.end(), second.begin(), second.end());
  return loop;
}

std::vector<SurfacePoint> CellLoops::part_in_thirds(const Loop& loop, GeneratorId) const {
  const std::size_t n = loop.vertices.size();
  std::vector<double> start{0};
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 step = cut_.mesh.position(loop.vertices[(i + 1) % n]) - cut_.mesh.position(loop.vertices[i]);
    start.push_back(start.back() + step.norm());
  }
  const double length = start.back();
  std::vector<SurfacePoint> points;
  for (int third = loop.stick > kLongStick * length ? 0 : 1; third < 3; ++third) {
    const double at = length * third / 3;
    const auto next = std::upper_bound(start.begin() + 1, start.end() - 1, at);
    const auto i = static_cast<std::size_t>(next - start.begin()) - 1;
    const double t = std::clamp((at - start[i]) / (start[i + 1] - start[i]), 0.0, 1.0);
    points.push_back(input_point(loop.vertices[i], loop.vertices[(i + 1) % n], t));
  }
  return points;
}

/// A point of an edge of the cut mesh, in the input's faces.
SurfacePoint CellLoops::input_point(VertexId from, VertexId to, double t) const {
  const HalfedgeId start = cut_.mesh.halfedge(from);
  HalfedgeId h = start;
  FaceId face = Mesh::face(start);
  do {
    if (cut_.mesh.to(h) == to || cut_.mesh.from(Mesh::previous(h)) == to) face = Mesh::face(h);
    h = cut_.mesh.twin(Mesh::previous(h));
  } while (h.valid() && h != start);
  const Vec3 at = (1 - t) * cut_.mesh.position(from) + t * cut_.mesh.position(to);
  return closest_point_on_face(mesh_, cut_.parent[face], at).point;
}

}  // namespace gvd
