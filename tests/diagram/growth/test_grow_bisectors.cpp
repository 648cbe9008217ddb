// Growth through gaps; test_growing_end.cpp has its events, test_check_growth.cpp the check of the result.
#include <algorithm>
#include <cmath>
#include <set>

#include "diagram/growth/grow_bisectors.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/grown_gaps.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_grow_bisectors {

const std::vector<int> kSpread{1 * 25 + 3, 14 * 25 + 5, 7 * 25 + 20, 2 * 25 + 13, 16 * 25 + 17, 8 * 25 + 11};

TEST_CASE("on a flat grid growth closes gaps, and its branch points are the circumcentres") {
  const Mesh mesh = test::make_grid(24, 17);
  const test::GrownGaps g(mesh, test::at_vertices(mesh, kSpread));
  CHECK(g.closed >= 2);
  CHECK(2 * g.closed >= static_cast<int>(g.gaps.size()));
  int branches = 0;
  for (const auto& grown : g.grown) {
    if (!grown) continue;
    for (std::size_t n = 0; n < grown->nodes.size(); ++n) {
      const GapNode& node = grown->nodes[n];
      if (node.kind != GapNode::Kind::branch) continue;
      std::set<GeneratorId> cells;
      for (const GapArc& arc : grown->arcs) {
        if (arc.begin == static_cast<int>(n) || arc.end == static_cast<int>(n)) cells.insert({arc.left, arc.right});
      }
      REQUIRE(cells.size() == 3);
      const Vec3 p = position(mesh, {node.face, node.bary});
      for (const GeneratorId c : cells) {
        // Only the circumcentre is equally far from the three.
        const double distance = (p - mesh.position(g.stages.working.vertex(c))).norm();
        CHECK(std::abs(distance - node.distance) < 1e-6);
      }
      ++branches;
    }
  }
  CHECK(branches >= 2);
}

/// The number of arcs of the bisector that starts with arc `first`, if it goes from rim to rim without a branch point;
/// else 0.
std::size_t chain_length(const GrownGap& grown, std::size_t first) {
  int node = grown.arcs[first].end;
  std::size_t length = 1, last = first;
  while (grown.nodes[node].kind == GapNode::Kind::crossing) {
    std::size_t next = 0;
    while (next < grown.arcs.size() &&
           (next == last || (grown.arcs[next].begin != node && grown.arcs[next].end != node))) {
      ++next;
    }
    if (next == grown.arcs.size()) return 0;  // a crossing of the mesh's boundary
    node = grown.arcs[next].begin == node ? grown.arcs[next].end : grown.arcs[next].begin;
    last = next;
    ++length;
  }
  return grown.nodes[node].kind == GapNode::Kind::rim ? length : 0;
}

TEST_CASE("ends of one bisector that face each other are joined: a chain of arcs from rim to rim") {
  int chains = 0;
  std::size_t longest = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    for (const auto& [name, mesh] : test::small_family()) {
      const test::GrownGaps g(mesh, test::random_generators(mesh, 14, seed));
      for (const auto& grown : g.grown) {
        if (!grown) continue;
        for (std::size_t i = 0; i < grown->arcs.size(); ++i) {
          if (grown->nodes[grown->arcs[i].begin].kind != GapNode::Kind::rim) continue;
          const std::size_t length = chain_length(*grown, i);
          chains += length > 0 ? 1 : 0;
          longest = std::max(longest, length);
        }
      }
    }
  }
  CHECK(chains > 20);
  CHECK(longest >= 3);
}

TEST_CASE("growth closes most gaps of the families, and its results pass the check a second time") {
  for (const auto& [name, mesh] : test::small_family()) {
    std::size_t gaps = 0, closed = 0;
    for (const Front front : {Front::circle, Front::planar}) {
      for (unsigned seed = 0; seed < 4; ++seed) {
        INFO(name << ", " << test::name(front) << ", seed " << seed);
        const test::GrownGaps g(mesh, test::random_generators(mesh, 30, seed), front);
        for (std::size_t i = 0; i < g.gaps.size(); ++i) {
          if (g.grown[i]) REQUIRE(g.check(i, *g.grown[i]));
        }
        gaps += g.gaps.size();
        closed += static_cast<std::size_t>(g.closed);
      }
    }
    INFO(name << ": " << closed << " of " << gaps << " gaps");
    CHECK(gaps > 20);
    // Growth closes fewer gaps if distances unfold inaccurately: measured 41 % with thin faces, 65 to 95 % elsewhere.
    CHECK(10 * closed >= (name == "thin-faced sphere" ? 3 : 5) * gaps);
  }
}

TEST_CASE("a gap that growth does not close is assembled, and the diagram is complete") {
  std::int64_t assembled = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 30, 3);
    const test::GrownGaps g(mesh, generators);
    DiagramOptions options;
    options.method = Method::gbgvd;
    const Diagram diagram = compute_diagram(mesh, generators, options);
    REQUIRE(check_diagram(mesh, diagram).ok());
    const DiagramReport& report = diagram.report;
    REQUIRE(report.gaps == static_cast<std::int64_t>(g.gaps.size()));
    REQUIRE(report.gaps_grown + report.gaps_assembled == report.gaps);
    REQUIRE(report.unresolved_ends == 0);
    assembled += report.gaps_assembled;
  }
  CHECK(assembled > 20);
}

TEST_CASE("growth takes gaps of up to 200 faces and leaves larger ones to assembly") {
  constexpr int kWide = 30;
  const Mesh mesh = test::make_grid(kWide, kWide);
  const auto at = [](int i, int j) { return j * (kWide + 1) + i; };
  const test::Stages stages(mesh, test::at_vertices(mesh, {at(2, 3), at(27, 4), at(14, 28)}), Front::circle);
  Gap gap;  // 10 x 10 squares around the circumcentre
  for (int j = 9; j < 19; ++j) {
    for (int f = 2 * (j * kWide + 10); f < 2 * (j * kWide + 20); ++f) gap.faces.emplace_back(f);
  }
  REQUIRE(gap.faces.size() == 200);
  const auto grown = grow_bisectors(stages.input(), stages.rough, gap).grown;
  REQUIRE(grown);
  CHECK(test::count_nodes(*grown, GapNode::Kind::rim) == 3);
  CHECK(test::count_nodes(*grown, GapNode::Kind::branch) == 1);
  CHECK(test::count_nodes(*grown, GapNode::Kind::crossing) > 10);
  gap.faces.emplace_back(2 * (19 * kWide + 10));  // one more, which no bisector crosses
  CHECK_FALSE(grow_bisectors(stages.input(), stages.rough, gap).grown);
}

}  // namespace gvd::test_grow_bisectors
