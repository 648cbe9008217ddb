// The check of growth refuses every violation of its properties, in gaps made by hand and in real ones.
#include <algorithm>
#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "diagram/growth/check_growth.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/grown_gaps.hpp"
#include "support/hand_made_gaps.hpp"
#include "support/meshes.hpp"

namespace gvd::test_check_growth {

using test::CornerAndBranch;
using test::Fan;
using test::HandMade;
using test::TwoAcross;
using test::TwoBranches;

TEST_CASE("gaps made by hand pass as they are") {
  CHECK(CornerAndBranch().check());
  CHECK(TwoBranches().check());
  CHECK(TwoAcross().check());
}

TEST_CASE("an arc that crosses another one is refused, even if cells and degrees are right") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(0.94, 0.03, 0.03);
  CHECK_FALSE(x.check());
}

TEST_CASE("a branch point outside its face, or in another face, is refused") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(-0.01, 0.51, 0.5);
  CHECK_FALSE(x.check());
  CornerAndBranch y;
  y.grown.nodes[5].face = Mesh::face(y.mesh.twin(Mesh::halfedge(y.f, 0)));
  CHECK_FALSE(y.check());
}

TEST_CASE("cells that are not in the order of the arcs around a branch point are refused") {
  TwoBranches swapped;
  std::swap(swapped.grown.arcs[2].left, swapped.grown.arcs[2].right);
  CHECK_FALSE(swapped.check());
  TwoBranches other;
  other.grown.arcs[2].left = GeneratorId(3);
  CHECK_FALSE(other.check());
  TwoBranches exchanged;
  std::swap(exchanged.grown.nodes[4].bary, exchanged.grown.nodes[5].bary);
  CHECK_FALSE(exchanged.check());
}

TEST_CASE("crossings too close to each other, or to the ends of their edge, are refused") {
  // The parameters of the new crossings count from a to c, or from c to a, as their edge does.
  const auto move_crossing = [](TwoAcross& x, std::size_t n, double t) {
    const bool along = x.mesh.from(x.mesh.halfedge(x.grown.nodes[n].crossing.edge)) == VertexId(x.a);
    x.grown.nodes[n].crossing.t = along ? t : 1 - t;
  };
  for (const auto& [first, second, sound] :
       {std::tuple(0.4, 0.4 + 2 * kCrossingGap, true), std::tuple(0.4, 0.4 + 0.5 * kCrossingGap, false),
        std::tuple(2 * kCrossingGap, 0.6, true), std::tuple(0.5 * kCrossingGap, 0.6, false),
        std::tuple(0.4, 1 - 2 * kCrossingGap, true), std::tuple(0.4, 1 - 0.5 * kCrossingGap, false)}) {
    TwoAcross x;
    move_crossing(x, 4, first), move_crossing(x, 5, second);
    INFO(first << ", " << second);
    CHECK(x.check() == sound);
  }
}

TEST_CASE("crossings of one edge whose cells do not follow each other are refused") {
  TwoAcross swapped;
  std::swap(swapped.grown.nodes[4].crossing.t, swapped.grown.nodes[5].crossing.t);
  CHECK_FALSE(swapped.check());
  // The same on all three edges, rim included: 0 | 1, and 3 | 2.
  TwoAcross broken;
  const auto rename = [](GeneratorId& g) { g = g == GeneratorId(1) ? GeneratorId(3) : g; };
  for (const std::size_t i : {1u, 3u}) rename(broken.items[i].before), rename(broken.items[i].after);
  rename(broken.grown.nodes[5].crossing.before), rename(broken.grown.nodes[5].crossing.after);
  for (const std::size_t i : {1u, 3u}) rename(broken.grown.arcs[i].left), rename(broken.grown.arcs[i].right);
  CHECK_FALSE(broken.check());
}

TEST_CASE("an arc whose cells are not those of the crossing where it begins is refused") {
  CornerAndBranch x;  // their order around the branch point is still right: all three are rotated by one
  const std::array<std::pair<int, int>, 3> turned{std::pair(1, 2), {2, 0}, {0, 1}};
  for (std::size_t i = 0; i < 3; ++i) {
    x.grown.arcs[i + 1].left = GeneratorId(turned[i].first);
    x.grown.arcs[i + 1].right = GeneratorId(turned[i].second);
  }
  CHECK_FALSE(x.check());
}

TEST_CASE("a rim crossing that is left out, or whose arc lies outside the gap, is refused") {
  HandMade sound, outside, left_out;
  const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
  for (HandMade* x : {&sound, &outside, &left_out}) {
    const HalfedgeId h = x->halfedge(a, b);
    x->gap.faces = {Mesh::face(h)};
    x->add_rim(a, b, 0.3, 0, 1);  // cell 1 reaches into the gap
    x->add_rim(a, b, 0.6, 1, 0);
    if (x != &left_out) x->add_rim_nodes();
    if (x == &sound) x->add_arc(Mesh::face(h), 0, 1, 0, 1);
    if (x == &outside) x->add_arc(Mesh::face(x->mesh.twin(h)), 0, 1, 1, 0);
  }
  CHECK(sound.check());
  CHECK_FALSE(outside.check());
  CHECK_FALSE(left_out.check());
}

TEST_CASE("a new crossing with both arcs in one face, and a rim crossing used twice, are refused") {
  for (const bool both_below : {false, true}) {
    HandMade x;
    const int a = HandMade::at(1, 1), b = HandMade::at(2, 1), c = HandMade::at(2, 2), d = HandMade::at(1, 2);
    const FaceId below = Mesh::face(x.halfedge(a, b)), above = Mesh::face(x.halfedge(c, d));
    x.gap.faces = {std::min(below, above), std::max(below, above)};
    x.add_inside(a, c, 0.4, 0, 1);  // cell 1 contains the middle of the edge
    x.add_inside(a, c, 0.6, 1, 0);
    x.add_arc(below, 0, 1, 1, 0);
    if (both_below) {
      x.add_arc(below, 0, 1, 1, 0);
    } else {
      x.add_arc(above, 0, 1, 0, 1);
    }
    CHECK(x.check() != both_below);
  }
  TwoAcross twice;
  twice.grown.nodes[1].rim = twice.grown.nodes[0].rim;
  twice.grown.arcs[1].left = GeneratorId(0), twice.grown.arcs[1].right = GeneratorId(1);
  CHECK_FALSE(twice.check());
}

TEST_CASE("an edge that contradicts the labels of its ends is refused") {
  TwoAcross crossed;
  crossed.label(crossed.c, 1);
  CHECK_FALSE(crossed.check());
  CornerAndBranch plain;
  plain.items.erase(plain.items.begin() + 3, plain.items.end());  // nothing on c - a: 2 at c, and 3 at a
  plain.grown.nodes.clear();
  plain.grown.arcs.clear();
  plain.items.erase(plain.items.begin(), plain.items.begin() + 3);
  CHECK_FALSE(plain.check());
}

TEST_CASE("growth may pass a vertex on its other side, and reports that the vertex moved") {
  Fan as_labelled;
  as_labelled.cross({{as_labelled.low, as_labelled.middle}, {as_labelled.left, as_labelled.middle}});
  CHECK(as_labelled.check());
  CHECK(as_labelled.grown.labels.empty());
  const auto on_its_right = [](Fan& x) {
    x.cross({{x.middle, x.right}, {x.middle, x.at(3, 2)}, {x.middle, x.at(3, 3)}, {x.middle, x.up}});
  };
  Fan moved;
  on_its_right(moved);
  CHECK(moved.check());
  CHECK(moved.grown.labels == std::vector{std::pair(VertexId(moved.middle), GeneratorId(0))});
  Fan generator(HandMade::at(2, 2));  // the vertex of a generator can't move
  on_its_right(generator);
  CHECK_FALSE(generator.check());
}

/// Calls tamper(result, k) for k = 0, 1, .. on copies of a sound result until it returns false: there is no k-th
/// element.
void require_refused(const test::GrownGaps& g, std::size_t i,
                     const std::function<bool(GrownGap&, std::size_t)>& tamper) {
  for (std::size_t k = 0;; ++k) {
    GrownGap tampered = *g.grown[i];
    if (!tamper(tampered, k)) {
      REQUIRE(k > 0);
      return;
    }
    INFO("element " << k);
    REQUIRE_FALSE(g.check(i, tampered));
  }
}

/// The first gap that closed with at least two branch points and four crossings, or the number of gaps.
std::size_t find_rich_gap(const test::GrownGaps& g) {
  std::size_t i = 0;
  while (i < g.gaps.size() && !(g.grown[i] && test::count_nodes(*g.grown[i], GapNode::Kind::branch) >= 2 &&
                                test::count_nodes(*g.grown[i], GapNode::Kind::crossing) >= 4)) {
    ++i;
  }
  return i;
}

/// Growth on a mesh with generators for which there is such a gap.
test::GrownGaps grow_with_rich_gap(const Mesh& mesh) {
  unsigned seed = 0;
  while (true) {
    test::GrownGaps g(mesh, test::random_generators(mesh, 14, seed));
    if (find_rich_gap(g) < g.gaps.size() || ++seed == 20) return g;
  }
}

/// The k-th node of a kind, or nothing.
GapNode* node_of(GrownGap& grown, GapNode::Kind kind, std::size_t k) {
  for (GapNode& n : grown.nodes) {
    if (n.kind == kind && k-- == 0) return &n;
  }
  return nullptr;
}

TEST_CASE("real gaps: the check refuses every changed arc or node") {
  const Mesh mesh = test::make_torus(24, 12);
  const test::GrownGaps g = grow_with_rich_gap(mesh);
  const std::size_t i = find_rich_gap(g);
  REQUIRE(i < g.gaps.size());
  REQUIRE(g.check(i, *g.grown[i]));
  const auto arc_at = [](GrownGap& grown, std::size_t k) { return k < grown.arcs.size() ? &grown.arcs[k] : nullptr; };
  SECTION("an arc dropped") {
    require_refused(g, i, [](GrownGap& grown, std::size_t k) {
      if (k >= grown.arcs.size()) return false;
      grown.arcs.erase(grown.arcs.begin() + static_cast<std::ptrdiff_t>(k));
      return true;
    });
  }
  SECTION("an arc twice") {
    require_refused(g, i, [](GrownGap& grown, std::size_t k) {
      if (k >= grown.arcs.size()) return false;
      grown.arcs.push_back(GapArc(grown.arcs[k]));
      return true;
    });
  }
  SECTION("the cells of an arc swapped") {
    require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
      if (GapArc* arc = arc_at(grown, k)) return std::swap(arc->left, arc->right), true;
      return false;
    });
  }
  SECTION("an arc of another cell") {
    require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
      if (GapArc* arc = arc_at(grown, k)) return arc->left = GeneratorId(99), true;
      return false;
    });
  }
  SECTION("an arc in another face") {
    require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
      GapArc* arc = arc_at(grown, k);
      if (!arc) return false;
      arc->face = arc->face == g.gaps[i].faces.front() ? g.gaps[i].faces.back() : g.gaps[i].faces.front();
      return true;
    });
  }
  SECTION("an arc turned round, with its cells left as they were") {
    require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
      if (GapArc* arc = arc_at(grown, k)) return std::swap(arc->begin, arc->end), true;
      return false;
    });
  }
  SECTION("a branch point out of its face") {
    for (const Bary& far : {Bary{3, -1, -1}, Bary{-1, 3, -1}, Bary{-1, -1, 3}, Bary{0.6, 0.6, -0.2}}) {
      require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
        if (GapNode* node = node_of(grown, GapNode::Kind::branch, k)) return node->bary = far, true;
        return false;
      });
    }
  }
  SECTION("the cells of a crossing swapped") {
    require_refused(g, i, [](GrownGap& grown, std::size_t k) {
      if (GapNode* node = node_of(grown, GapNode::Kind::crossing, k)) {
        return std::swap(node->crossing.before, node->crossing.after), true;
      }
      return false;
    });
  }
  SECTION("a crossing off its edge") {
    for (const double t : {-0.1, 0.0, 1.0, 1.1}) {
      require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
        if (GapNode* node = node_of(grown, GapNode::Kind::crossing, k)) return node->crossing.t = t, true;
        return false;
      });
    }
  }
  SECTION("a rim crossing for another one") {
    require_refused(g, i, [&](GrownGap& grown, std::size_t k) {
      GapNode* node = node_of(grown, GapNode::Kind::rim, k);
      GapNode* next = node_of(grown, GapNode::Kind::rim, k + 1);
      if (!node || !next) return false;
      node->rim = next->rim;
      return true;
    });
  }
}

const GapEdge& find_edge(const GapEdges& edges, EdgeId e) {
  const auto& all = edges.edges();
  return *std::find_if(all.begin(), all.end(), [&](const GapEdge& x) { return x.edge == e; });
}

TEST_CASE("a gap without crossings has its faces' edges, each once, and all of one face are rim inside the mesh") {
  HandMade x;
  const FaceId f = Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)));
  x.gap.faces = {f};
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  REQUIRE(edges.edges().size() == 3);
  for (const GapEdge& e : edges.edges()) {
    CHECK(e.rim);
    CHECK(e.crossings.empty());
  }
  CHECK(edges.rim_crossing_count() == 0);
  CHECK(edges.are_consistent());
}

TEST_CASE("an edge on the mesh's boundary is not part of the rim") {
  HandMade x;
  const HalfedgeId h = x.halfedge(HandMade::at(0, 0), HandMade::at(1, 0));
  REQUIRE(x.mesh.is_boundary(x.mesh.edge(h)));
  x.gap.faces = {Mesh::face(h)};
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  CHECK_FALSE(find_edge(edges, x.mesh.edge(h)).rim);
  CHECK(std::count_if(edges.edges().begin(), edges.edges().end(), [](const GapEdge& e) { return e.rim; }) == 2);
}

TEST_CASE("rim edges keep their crossings, inner edges have those that grew, both ascending") {
  TwoAcross x;
  x.add_rim(x.a, x.c, 0.9, 0, 2);  // from before the growth, on the inner edge: replaced
  const GapEdges edges(x.mesh, x.crossings(), x.gap, x.grown);
  REQUIRE(edges.edges().size() == 5);
  CHECK(std::is_sorted(edges.edges().begin(), edges.edges().end(),
                       [](const GapEdge& a, const GapEdge& b) { return a.edge < b.edge; }));
  CHECK(edges.rim_crossing_count() == 4);
  const GapEdge& inner = find_edge(edges, x.mesh.edge(x.halfedge(x.a, x.c)));
  CHECK_FALSE(inner.rim);
  REQUIRE(inner.crossings.size() == 2);
  CHECK(inner.crossings[0].t < inner.crossings[1].t);
  CHECK(std::max(inner.crossings[0].t, inner.crossings[1].t) < 0.7);
  CHECK(edges.are_consistent());
}

TEST_CASE("crossings too close to each other or to an end, or between cells that do not follow, are inconsistent") {
  const auto consistent = [](double first, double second, int after, int before) {
    HandMade x;
    const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
    x.gap.faces = {Mesh::face(x.halfedge(a, b))};
    x.add_rim(a, b, first, 0, after);
    x.add_rim(a, b, second, before, 0);
    return GapEdges(x.mesh, x.crossings(), x.gap, x.grown).are_consistent();
  };
  CHECK(consistent(0.3, 0.6, 1, 1));
  CHECK_FALSE(consistent(0.3, 0.6, 1, 2));
  CHECK_FALSE(consistent(0.3, 0.3 + 0.5 * kCrossingGap, 1, 1));
  CHECK_FALSE(consistent(0.5 * kCrossingGap, 0.6, 1, 1));
  CHECK_FALSE(consistent(0.3, 1 - 0.5 * kCrossingGap, 1, 1));
}

bool check_nodes(const HandMade& x) {
  const Crossings crossings = x.crossings();
  return check_gap_nodes(x.mesh, crossings, x.gap, GapEdges(x.mesh, crossings, x.gap, x.grown), x.grown);
}

TEST_CASE("a gap that nothing crosses passes without nodes, and not with a branch point without arcs") {
  HandMade x;
  x.gap.faces = {FaceId(0)};
  CHECK(check_nodes(x));
  x.add_branch(FaceId(0), {0.3, 0.3, 0.4});
  CHECK_FALSE(check_nodes(x));
}

TEST_CASE("sound nodes pass") {
  CHECK(check_nodes(CornerAndBranch()));
  CHECK(check_nodes(TwoBranches()));
  CHECK(check_nodes(TwoAcross()));
}

TEST_CASE("a rim crossing needs exactly one node, with one arc") {
  TwoAcross no_arc;
  no_arc.grown.arcs.erase(no_arc.grown.arcs.begin());
  CHECK_FALSE(check_nodes(no_arc));
  TwoAcross twice;
  twice.grown.nodes[1].rim = twice.grown.nodes[0].rim;
  CHECK_FALSE(check_nodes(twice));
  HandMade left_out;
  const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
  left_out.gap.faces = {Mesh::face(left_out.halfedge(a, b))};
  left_out.add_rim(a, b, 0.3, 0, 1);
  left_out.add_rim(a, b, 0.6, 1, 0);
  CHECK_FALSE(check_nodes(left_out));
}

TEST_CASE("a new crossing needs an arc in each of its two faces") {
  TwoAcross one_face;
  one_face.grown.arcs[2].face = one_face.below;  // the arc above
  CHECK_FALSE(check_nodes(one_face));
  TwoAcross third_arc;
  third_arc.grown.arcs.push_back(GapArc(third_arc.grown.arcs[0]));
  CHECK_FALSE(check_nodes(third_arc));
}

TEST_CASE("a new crossing on the mesh's boundary needs one arc") {
  HandMade x;
  const HalfedgeId h = x.halfedge(HandMade::at(0, 0), HandMade::at(1, 0));
  x.gap.faces = {Mesh::face(h)};
  x.add_inside(HandMade::at(0, 0), HandMade::at(1, 0), 0.3, 0, 1);
  x.add_inside(HandMade::at(0, 0), HandMade::at(1, 0), 0.6, 1, 0);
  CHECK_FALSE(check_nodes(x));
  x.add_arc(Mesh::face(h), 0, 1, 0, 1);
  CHECK(check_nodes(x));
}

TEST_CASE("an arc has the cells of its ends, lies in a face of the gap, and a branch point in its own face") {
  TwoAcross cells;
  std::swap(cells.grown.arcs[0].left, cells.grown.arcs[0].right);
  CHECK_FALSE(check_nodes(cells));
  TwoAcross outside;
  outside.grown.arcs[0].face = FaceId(0);
  REQUIRE_FALSE(outside.gap.contains(FaceId(0)));
  CHECK_FALSE(check_nodes(outside));
  CornerAndBranch far;
  far.grown.nodes[5].bary = far.at_corners(-0.01, 0.51, 0.5);
  CHECK_FALSE(check_nodes(far));
}

using Moved = std::vector<std::pair<VertexId, GeneratorId>>;

std::optional<Moved> find_moved(const HandMade& x) {
  const Crossings crossings = x.crossings();
  return find_moved_labels(x.working, x.labels, GapEdges(x.mesh, crossings, x.gap, x.grown));
}

TEST_CASE("a gap of one face without crossings moves no label") {
  HandMade x;
  x.gap.faces = {Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)))};
  CHECK(find_moved(x) == Moved{});
}

TEST_CASE("rim labels that no crossing separates contradict each other") {
  HandMade x;
  x.gap.faces = {Mesh::face(x.halfedge(HandMade::at(1, 1), HandMade::at(2, 1)))};
  x.label(HandMade::at(2, 1), 1);
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("labels that agree with the crossings stay") {
  CHECK(find_moved(TwoAcross()) == Moved{});
  TwoAcross x;
  x.label(x.c, 1);  // an edge leads there in cell 2
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("a vertex inside the gap takes the label of its edges, unless it is a generator's") {
  Fan moved;
  moved.cross({{moved.middle, moved.right},
               {moved.middle, moved.at(3, 2)},
               {moved.middle, moved.at(3, 3)},
               {moved.middle, moved.up}});
  CHECK(find_moved(moved) == Moved{{VertexId(moved.middle), GeneratorId(0)}});
  Fan generator(HandMade::at(2, 2));
  generator.cross({{generator.middle, generator.right},
                   {generator.middle, generator.at(3, 2)},
                   {generator.middle, generator.at(3, 3)},
                   {generator.middle, generator.up}});
  CHECK_FALSE(find_moved(generator));
}

TEST_CASE("an inner vertex whose edges say different labels contradicts itself") {
  Fan x;
  x.cross({{x.low, x.middle}});  // the bisector ends in the middle of the gap
  CHECK_FALSE(find_moved(x));
}

TEST_CASE("in a gap that is the whole mesh, the generator's label spreads to all vertices") {
  HandMade x(HandMade::at(4, 4));
  for (int f = 0; f < x.mesh.face_count(); ++f) x.gap.faces.emplace_back(f);
  CHECK(find_moved(x) == Moved{});
}

bool check_arcs(const HandMade& x) { return check_gap_arcs(x.mesh, x.crossings(), x.grown); }

TEST_CASE("no arc, and one arc, are sound") {
  HandMade x;
  CHECK(check_arcs(x));
  const int a = HandMade::at(1, 1), b = HandMade::at(2, 1);
  x.add_rim(a, b, 0.3, 0, 1);
  x.add_rim(a, b, 0.6, 1, 0);
  x.add_rim_nodes();
  x.add_arc(Mesh::face(x.halfedge(a, b)), 0, 1, 0, 1);
  CHECK(check_arcs(x));
}

TEST_CASE("arcs that keep apart or have an end in common are sound") {
  CHECK(check_arcs(CornerAndBranch()));
  CHECK(check_arcs(TwoBranches()));
  CHECK(check_arcs(TwoAcross()));
}

TEST_CASE("two arcs of a face that cross are refused, and arcs of different faces are not compared") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(0.94, 0.03, 0.03);  // beyond the arc that cuts the corner off
  CHECK_FALSE(check_arcs(x));
  TwoAcross crossed;
  std::swap(crossed.grown.arcs[0].end, crossed.grown.arcs[1].end);
  CHECK_FALSE(check_arcs(crossed));
}

TEST_CASE("a branch point whose cells are in another order than its arcs is refused") {
  TwoBranches swapped;
  std::swap(swapped.grown.arcs[2].left, swapped.grown.arcs[2].right);
  CHECK_FALSE(check_arcs(swapped));
  TwoBranches exchanged;  // the two branch points
  std::swap(exchanged.grown.nodes[4].bary, exchanged.grown.nodes[5].bary);
  CHECK_FALSE(check_arcs(exchanged));
  TwoBranches missing;
  missing.grown.arcs.pop_back();
  CHECK_FALSE(check_arcs(missing));
}

TEST_CASE("one angle at a branch point may exceed half a turn") {
  CornerAndBranch x;
  x.grown.nodes[5].bary = x.at_corners(0.1, 0.85, 0.05);  // close to b: one of the three angles is 248 degrees
  CHECK(check_arcs(x));
}

}  // namespace gvd::test_check_growth
