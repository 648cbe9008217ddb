#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "diagram/growth/check_growth.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test {

/// A grid of 4 x 4 squares with labels, crossings and a grown gap that a test sets.
struct HandMade {
  static constexpr int kSquares = 4;

  Mesh mesh = make_grid(kSquares, kSquares);
  WorkingMesh working;
  NearestLabels labels;
  std::vector<Crossing> items;
  Gap gap;
  GrownGap grown;

  explicit HandMade(int generator = 0) : working(mesh, {vertex_point(mesh, VertexId(generator))}) {
    labels.label.assign(static_cast<std::size_t>(mesh.vertex_count()), GeneratorId(0));
    labels.distance.assign(static_cast<std::size_t>(mesh.vertex_count()), 1.0);
  }
  HandMade(const HandMade&) = delete;  // `working` refers to `mesh`
  HandMade& operator=(const HandMade&) = delete;

  static int at(int i, int j) { return j * (kSquares + 1) + i; }
  void label(int v, int g) { labels.label[VertexId(v)] = GeneratorId(g); }

  HalfedgeId halfedge(int u, int v) const {
    for (std::int32_t h = 0; h < 3 * mesh.face_count(); ++h) {
      if (mesh.from(HalfedgeId(h)) == VertexId(u) && mesh.to(HalfedgeId(h)) == VertexId(v)) return HalfedgeId(h);
    }
    return HalfedgeId();
  }

  /// A crossing at t on the way from vertex u to vertex v.
  Crossing crossing(int u, int v, double t, int before, int after) const {
    const HalfedgeId h = halfedge(u, v);
    const EdgeId e = mesh.edge(h);
    if (mesh.halfedge(e) == h) return {e, t, GeneratorId(before), GeneratorId(after)};
    return {e, 1 - t, GeneratorId(after), GeneratorId(before)};
  }

  void add_rim(int u, int v, double t, int before, int after) { items.push_back(crossing(u, v, t, before, after)); }
  void add_inside(int u, int v, double t, int before, int after) {
    grown.nodes.push_back({GapNode::Kind::crossing, CrossingId(), crossing(u, v, t, before, after), FaceId(), {}, 0});
  }
  void add_branch(FaceId f, const std::array<double, 3>& bary) {
    grown.nodes.push_back({GapNode::Kind::branch, CrossingId(), {}, f, bary, 1});
  }
  void add_arc(FaceId f, int begin, int end, int left, int right) {
    grown.arcs.push_back({f, begin, end, GeneratorId(left), GeneratorId(right)});
  }

  Crossings crossings() const { return Crossings(mesh.edge_count(), sorted()); }
  bool check() { return grown.labels.clear(), check_growth(working, labels, crossings(), gap, grown); }

  /// Rim nodes for all crossings that were added; call it before any other node.
  void add_rim_nodes() {
    for (const Crossing& c : items) {
      const auto all = sorted();
      const auto found = std::find_if(all.begin(), all.end(), [&](const Crossing& x) { return same(x, c); });
      const CrossingId id(found - all.begin());
      grown.nodes.push_back({GapNode::Kind::rim, id, {}, FaceId(), {}, 0});
    }
  }

 private:
  static bool same(const Crossing& a, const Crossing& b) { return a.edge == b.edge && a.t == b.t; }
  std::vector<Crossing> sorted() const {
    std::vector<Crossing> all = items;
    std::sort(all.begin(), all.end(),
              [](const Crossing& a, const Crossing& b) { return std::pair(a.edge, a.t) < std::pair(b.edge, b.t); });
    return all;
  }
};

/// One face a, b, c. An arc cuts off its corner a, which belongs to cell 3; the cells 0, 1 and 2 have a branch point.
struct CornerAndBranch : HandMade {
  const int a = at(1, 1), b = at(2, 1), c = at(2, 2);
  const FaceId f = Mesh::face(halfedge(a, b));
  const int first = Mesh::corner(halfedge(a, b));  // the corner at a

  CornerAndBranch() {
    label(a, 3), label(b, 1), label(c, 2);
    gap.faces = {f};
    add_rim(a, b, 0.2, 3, 0);
    add_rim(a, b, 0.6, 0, 1);
    add_rim(b, c, 0.5, 1, 2);
    add_rim(c, a, 0.5, 2, 0);
    add_rim(c, a, 0.8, 0, 3);
    add_rim_nodes();
    add_branch(f, at_corners(0.3, 0.4, 0.3));
    add_arc(f, 0, 4, 3, 0);
    add_arc(f, 1, 5, 0, 1);
    add_arc(f, 2, 5, 1, 2);
    add_arc(f, 3, 5, 2, 0);
  }

  /// Barycentric coordinates at the corners a, b and c.
  std::array<double, 3> at_corners(double at_a, double at_b, double at_c) const {
    std::array<double, 3> bary{};
    bary[first] = at_a;
    bary[(first + 1) % 3] = at_b;
    bary[(first + 2) % 3] = at_c;
    return bary;
  }
};

/// One face a, b, c with four cells and two branch points: of 0, 1, 2 and of 0, 2, 3.
struct TwoBranches : HandMade {
  const int a = at(1, 1), b = at(2, 1), c = at(2, 2);
  const FaceId f = Mesh::face(halfedge(a, b));

  TwoBranches() {
    label(a, 0), label(b, 1), label(c, 3);
    gap.faces = {f};
    add_rim(a, b, 0.5, 0, 1);
    add_rim(b, c, 0.3, 1, 2);
    add_rim(b, c, 0.7, 2, 3);
    add_rim(c, a, 0.5, 3, 0);
    add_rim_nodes();
    REQUIRE(mesh.vertices(f)[0] == VertexId(a));
    add_branch(f, {0.35, 0.4, 0.25});
    add_branch(f, {0.35, 0.25, 0.4});
    add_arc(f, 0, 4, 0, 1);
    add_arc(f, 1, 4, 1, 2);
    add_arc(f, 4, 5, 0, 2);
    add_arc(f, 2, 5, 2, 3);
    add_arc(f, 3, 5, 3, 0);
  }
};

/// Two faces with the diagonal a - c between them, and two bisectors across it: 0 | 1 | 2.
struct TwoAcross : HandMade {
  const int a = at(1, 1), b = at(2, 1), c = at(2, 2), d = at(1, 2);
  const FaceId below = Mesh::face(halfedge(a, b)), above = Mesh::face(halfedge(c, d));

  TwoAcross() {
    label(a, 0), label(b, 2), label(c, 2), label(d, 2);
    gap.faces = {std::min(below, above), std::max(below, above)};
    add_rim(a, b, 0.4, 0, 1);
    add_rim(a, b, 0.7, 1, 2);
    add_rim(a, d, 0.4, 0, 1);
    add_rim(a, d, 0.7, 1, 2);
    add_rim_nodes();
    add_inside(a, c, 0.4, 0, 1);
    add_inside(a, c, 0.6, 1, 2);
    add_arc(below, 0, 4, 0, 1);
    add_arc(below, 1, 5, 1, 2);
    add_arc(above, 4, 2, 0, 1);
    add_arc(above, 5, 3, 1, 2);
  }
};

/// The six faces around a vertex, with one bisector 0 | 1 from the rim below to the rim above, left of the vertex.
struct Fan : HandMade {
  const int middle = at(2, 2), low = at(1, 1), right = at(2, 1), left = at(1, 2), up = at(2, 3);

  explicit Fan(int generator = 0) : HandMade(generator) {
    for (int j = 0; j <= kSquares; ++j) {
      for (int i = 2; i <= kSquares; ++i) label(at(i, j), 1);
    }
    for (int f = 0; f < mesh.face_count(); ++f) {
      const auto& corners = mesh.vertices(FaceId(f));
      if (std::count(corners.begin(), corners.end(), VertexId(middle)) > 0) gap.faces.push_back(FaceId(f));
    }
    add_rim(low, right, 0.5, 0, 1);
    add_rim(left, up, 0.5, 0, 1);
    add_rim_nodes();
  }

  /// Adds the arcs of the bisector across these edges in order; each edge leads from cell 0 to cell 1.
  void cross(const std::vector<std::pair<int, int>>& spokes) {
    HalfedgeId entry = halfedge(low, right);
    if (!gap.contains(Mesh::face(entry))) entry = mesh.twin(entry);
    int node = 0;
    for (const auto& [u, v] : spokes) {
      const FaceId f = Mesh::face(entry);
      add_inside(u, v, 0.5, 0, 1);
      add_arc(f, node, static_cast<int>(grown.nodes.size()) - 1, 0, 1);
      node = static_cast<int>(grown.nodes.size()) - 1;
      entry = Mesh::face(halfedge(u, v)) == f ? halfedge(v, u) : halfedge(u, v);
    }
    add_arc(Mesh::face(entry), node, 1, 0, 1);
  }
};

}  // namespace gvd::test
