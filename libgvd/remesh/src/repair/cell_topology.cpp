// Finds what divides a cell that is not a disc: the arcs of the mesh's boundary in it, and its short non-contractible
// loops.
//
// Bisectors that end on the boundary cut its loops into arcs. The ends on each halfedge are sorted along it. A walk
// round each loop then begins a new arc at every end; what comes before the first end belongs to the last arc.
// A cell with several arcs breaks property (3) of gvd/dual.hpp. Arcs also tell quadrics which parts of the boundary lie
// in a cell. Each boundary halfedge is passed once.
//
// In the mesh cut along the bisectors, a cell consists of whole faces. A tree of shortest paths joins all their
// vertices. The dual graph of the faces may cross every edge outside of the tree; without its leaves, pruned again and
// again, it holds the edges that close a non-contractible loop with the tree. The shortest such loop is found exactly
// among those of one edge and two paths.
// Source: J. Erickson and S. Har-Peled, Optimally cutting a surface into a disk, 2004.
#include "repair/cell_topology.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <queue>
#include <set>

#include "base/least.hpp"
#include "gvd/closest_point.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// The end of a bisector on a boundary halfedge.
struct BoundaryEnd {
  double at = 0;      ///< parameter along the halfedge
  GeneratorId after;  ///< the cell that follows it along the halfedge
};

/// The ends of bisectors on each boundary halfedge, by their places.
using BoundaryEnds = std::map<HalfedgeId, std::vector<BoundaryEnd>>;

BoundaryEnds collect_ends(const Mesh& mesh, const Diagram& diagram) {
  BoundaryEnds ends;
  const auto add_end = [&](const SurfacePoint& point, GeneratorId after) {
    if (point.kind() == SurfacePoint::Kind::vertex) {
      ends[mesh.halfedge(vertex(mesh, point))].push_back({0, after});
    } else if (point.kind() == SurfacePoint::Kind::edge) {
      const HalfedgeId h = halfedge(point);
      ends[h].push_back({point.bary[Mesh::corner(Mesh::next(h))], after});
    }
  };
  for (const Bisector& b : diagram.bisectors) {
    if (b.closed) continue;
    // The surface lies to the left of a boundary halfedge. So the next cell is the right one of a bisector that starts
    // there, and the left one of a bisector that ends there.
    if (!b.ends[0].valid()) add_end(b.points.front(), b.right);
    if (!b.ends[1].valid()) add_end(b.points.back(), b.left);
  }
  for (auto& [h, on_halfedge] : ends) std::ranges::stable_sort(on_halfedge, {}, &BoundaryEnd::at);
  return ends;
}

/// Appends the arcs of a boundary loop. `whole` is the cell of a loop without an end. The segments before the first end
/// belong to the last arc.
void cut_loop(const Mesh& mesh, HalfedgeId first, const BoundaryEnds& ends, GeneratorId whole,
              std::vector<BoundaryArc>& arcs) {
  const std::size_t before = arcs.size();
  BoundaryArc head;
  BoundaryArc* arc = &head;
  HalfedgeId h = first;
  do {
    double begin = 0;
    const auto here = ends.find(h);
    for (std::size_t i = 0; here != ends.end() && i < here->second.size(); ++i) {
      const BoundaryEnd& end = here->second[i];
      arc->segments.push_back({h, begin, end.at});
      arcs.push_back({end.after, {}});
      arc = &arcs.back();
      begin = end.at;
    }
    arc->segments.push_back({h, begin, 1});
    h = next_on_boundary(mesh, h);
  } while (h != first);
  if (arcs.size() > before) {
    arc->segments.insert(arc->segments.end(), head.segments.begin(), head.segments.end());
  } else if (whole.valid()) {
    head.cell = whole;
    arcs.push_back(std::move(head));
  }
}

/// If the generator is at most this far from the loop, as a fraction of a part of the loop, it serves one of the parts
/// itself. Farther away, the generator's own cell may not cover its part of the loop.
constexpr double kFarFromLoop = 1.0 / 2;

/// The links of each face.
std::vector<std::vector<std::size_t>> list_links(std::size_t faces, const std::vector<DualLink>& links) {
  std::vector<std::vector<std::size_t>> links_of(faces);
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const std::int32_t node : links[i].nodes) {
      if (node != DualLink::kOutside) links_of[node].push_back(i);
    }
  }
  return links_of;
}

}  // namespace

std::vector<BoundaryArc> list_boundary_arcs(const Mesh& mesh, const Diagram& diagram) {
  const BoundaryEnds ends = collect_ends(mesh, diagram);
  std::vector<BoundaryArc> arcs;
  for_each_boundary_loop(
      mesh, [&](HalfedgeId first) { cut_loop(mesh, first, ends, diagram.vertex_label[mesh.from(first)], arcs); });
  return arcs;
}

SurfacePoint find_nearest_point(const Mesh& mesh, const BoundaryArc& arc, const Vec3& to) {
  Least<SurfacePoint> nearest;
  for (const BoundaryArc::Segment& segment : arc.segments) {
    const Vec3& from = mesh.position(mesh.from(segment.halfedge));
    const Vec3 along = mesh.position(mesh.to(segment.halfedge)) - from;
    const double t = std::clamp(foot_on_edge(mesh, segment.halfedge, to), segment.begin, segment.end);
    nearest.offer((from + t * along - to).squaredNorm(), edge_point(segment.halfedge, t));
  }
  return make_surface_point(nearest.value.face, nearest.value.bary);
}

void CellTree::grow(VertexId root, GeneratorId cell) {
  for (const VertexId v : touched_) {
    distance_[v] = kInfinity;
    parent_[v] = VertexId();
  }
  touched_.clear();
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto offer = [&](VertexId v, double distance, VertexId parent) {
    if (distance >= distance_[v]) return;
    distance_[v] = distance;
    parent_[v] = parent;
    touched_.push_back(v);
    queue.emplace(distance, v);
  };
  offer(root, 0, VertexId());
  while (!queue.empty()) {
    const auto [distance, v] = queue.top();
    queue.pop();
    if (distance > distance_[v]) continue;
    for_each_outgoing(cut_.mesh, v, [&, from = v, so_far = distance](HalfedgeId h) {
      if (!is_in_cell(cut_, h, cell)) return;
      const HalfedgeId incoming = Mesh::previous(h);
      offer(cut_.mesh.to(h), so_far + cut_.mesh.length(h), from);
      offer(cut_.mesh.from(incoming), so_far + cut_.mesh.length(incoming), from);
    });
  }
}

std::vector<HalfedgeId> prune_leaves(std::size_t faces, const std::vector<DualLink>& links) {
  const std::vector<std::vector<std::size_t>> links_of = list_links(faces, links);
  std::vector<std::size_t> degree, leaves;
  for (std::size_t i = 0; i < faces; ++i) {
    degree.push_back(links_of[i].size());
    if (degree.back() == 1) leaves.push_back(i);
  }
  std::vector<char> is_removed(links.size(), 0);
  while (!leaves.empty()) {
    const std::size_t leaf = leaves.back();
    leaves.pop_back();
    for (const std::size_t link : links_of[leaf]) {
      if (std::exchange(is_removed[link], 1)) continue;
      for (const std::int32_t node : links[link].nodes) {
        if (node != DualLink::kOutside && --degree[node] == 1) leaves.push_back(node);
      }
    }
  }
  std::vector<HalfedgeId> remaining;
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (!is_removed[i]) remaining.push_back(links[i].crossed);
  }
  return remaining;
}

CellLoops::CellLoops(const Mesh& mesh, const Diagram& diagram, CutMesh cut)
    : mesh_(mesh),
      diagram_(diagram),
      cut_(std::move(cut)),
      tree_(cut_),
      by_label_(cut_.mesh.faces().begin(), cut_.mesh.faces().end()),
      face_node_(by_label_.size(), -1) {
  std::ranges::stable_sort(by_label_, {}, [&](FaceId f) { return cut_.label[f]; });
}

std::vector<SurfacePoint> CellLoops::find(GeneratorId cell, int parts) {
  const std::vector<FaceId> faces = faces_of(cell);
  if (faces.empty()) return {};
  tree_.grow(find_root(faces, cell), cell);
  Least<HalfedgeId> shortest;
  for (const HalfedgeId h : find_loop_edges(faces, cell)) {
    shortest.offer(tree_.distance(cut_.mesh.from(h)) + cut_.mesh.length(h) + tree_.distance(cut_.mesh.to(h)), h);
  }
  if (!shortest.value.valid()) return {};
  return divide(close_loop(shortest.value), parts);
}

std::vector<std::vector<SurfacePoint>> CellLoops::borders(GeneratorId cell) const {
  const auto is_inside = [&](HalfedgeId h) { return h.valid() && is_in_cell(cut_, h, cell); };
  std::set<HalfedgeId> left;
  for (const FaceId f : faces_of(cell)) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      if (!is_inside(cut_.mesh.twin(h))) left.insert(h);
    }
  }
  std::vector<std::vector<SurfacePoint>> borders;
  while (!left.empty()) {
    std::vector<SurfacePoint>& border = borders.emplace_back();
    for (HalfedgeId h = *left.begin(); left.erase(h) > 0;) {
      const FaceId parent = cut_.parent[Mesh::face(h)];
      border.push_back(closest_point_on_face(mesh_, parent, cut_.mesh.position(cut_.mesh.from(h))).point);
      // The next halfedge begins where this one ends, beyond the faces of the cell round that corner.
      h = Mesh::next(h);
      while (is_inside(cut_.mesh.twin(h))) h = Mesh::next(cut_.mesh.twin(h));
    }
  }
  return borders;
}

std::vector<FaceId> CellLoops::faces_of(GeneratorId cell) const {
  const auto label = [&](FaceId f) { return cut_.label[f]; };
  return {std::ranges::lower_bound(by_label_, cell, {}, label), std::ranges::upper_bound(by_label_, cell, {}, label)};
}

/// The corner of the cell's faces that is nearest to the generator.
VertexId CellLoops::find_root(const std::vector<FaceId>& faces, GeneratorId cell) const {
  const Vec3 at = position(mesh_, diagram_.generators[cell.index()]);
  Least<VertexId> nearest;
  for (const FaceId f : faces) {
    for (const VertexId v : cut_.mesh.vertices(f)) nearest.offer((cut_.mesh.position(v) - at).squaredNorm(), v);
  }
  return nearest.value;
}

/// The edges that close a non-contractible loop with the tree. The dual graph may cross every edge outside of the tree.
/// The edges that remain after pruning its leaves are dual to cycles, or to paths from border to border.
std::vector<HalfedgeId> CellLoops::find_loop_edges(const std::vector<FaceId>& faces, GeneratorId cell) {
  for (int i = 0; i < std::ssize(faces); ++i) face_node_[faces[i]] = i;
  std::vector<DualLink> links;
  for (const FaceId f : faces) {
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const HalfedgeId twin = cut_.mesh.twin(h);
      const bool at_border = !twin.valid() || !is_in_cell(cut_, twin, cell);
      if (tree_.contains_edge(h) || (!at_border && twin < h)) continue;
      links.push_back({h, {face_node_[f], at_border ? DualLink::kOutside : face_node_[Mesh::face(twin)]}});
    }
  }
  return prune_leaves(faces.size(), links);
}

/// The edge and the tree's paths to both of its ends, without their common part.
CellLoops::Loop CellLoops::close_loop(HalfedgeId last) const {
  std::vector<VertexId> first = tree_.path_to_root(cut_.mesh.from(last));
  std::vector<VertexId> second = tree_.path_to_root(cut_.mesh.to(last));
  VertexId fork = first.back();
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    fork = first.back();
    first.pop_back();
    second.pop_back();
  }
  Loop loop;
  loop.distance = tree_.distance(fork);
  loop.vertices.push_back(fork);
  loop.vertices.insert(loop.vertices.end(), first.rbegin(), first.rend());
  loop.vertices.insert(loop.vertices.end(), second.begin(), second.end());
  return loop;
}

std::vector<SurfacePoint> CellLoops::divide(const Loop& loop, int parts) const {
  const std::size_t n = loop.vertices.size();
  std::vector<double> start{0};  // arc length of every vertex, and of the whole loop
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 step = cut_.mesh.position(loop.vertices[(i + 1) % n]) - cut_.mesh.position(loop.vertices[i]);
    start.push_back(start.back() + step.norm());
  }
  const double length = start.back();
  std::vector<SurfacePoint> points;
  for (int part = loop.distance > kFarFromLoop * length / parts ? 0 : 1; part < parts; ++part) {
    const double at = length * part / parts;
    const std::size_t i = std::upper_bound(start.begin() + 1, start.end() - 1, at) - start.begin() - 1;
    const double t = std::clamp((at - start[i]) / (start[i + 1] - start[i]), 0.0, 1.0);
    points.push_back(to_input(loop.vertices[i], loop.vertices[(i + 1) % n], t));
  }
  return points;
}

/// The point (1 - t) from + t to of an edge of the cut mesh, as a point of the input mesh.
SurfacePoint CellLoops::to_input(VertexId from, VertexId to, double t) const {
  FaceId face = Mesh::face(cut_.mesh.halfedge(from));
  for_each_outgoing(cut_.mesh, from, [&](HalfedgeId h) {
    if (cut_.mesh.to(h) == to || cut_.mesh.from(Mesh::previous(h)) == to) face = Mesh::face(h);
  });
  const Vec3 at = (1 - t) * cut_.mesh.position(from) + t * cut_.mesh.position(to);
  return closest_point_on_face(mesh_, cut_.parent[face], at).point;
}

}  // namespace gvd
