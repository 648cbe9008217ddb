// The paper's steps: distances of midpoints (section 4.1), rough segments and their refinement (section 4.2, inset
// figure and figure 6), and complete diagrams.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "base/plane.hpp"
#include "diagram/growth/trace_paper.hpp"
#include "geodesic/marching/unfold.hpp"
#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_trace_paper {

TEST_CASE("the paper's steps give complete diagrams on all families, with both fronts") {
  std::int64_t gaps = 0, grown = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::planar, Front::circle}) {
      for (unsigned seed = 0; seed < 3; ++seed) {
        INFO(name << ", seed " << seed);
        DiagramOptions options;
        options.method = Method::paper;
        options.front = front;
        const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 20, seed), options);
        REQUIRE(check_diagram(mesh, diagram).ok());
        gaps += diagram.report.gaps;
        grown += diagram.report.gaps_grown;
      }
    }
  }
  CHECK(gaps > 500);
  CHECK(2 * grown > gaps);
  CHECK(grown < gaps);
}

constexpr int kSquares = 12;
int at(int i, int j) { return j * (kSquares + 1) + i; }

TEST_CASE("rough segments cross every edge between two labels at its midpoint, and no other") {
  const Mesh mesh = test::make_bumpy_sphere(2, 1);
  const test::Stages stages(mesh, test::random_generators(mesh, 8, 4), Front::planar);
  const Crossings crossings = find_rough_segments(stages.mesh(), stages.labels);
  CHECK(crossings.size() > 30);
  for (std::int32_t i = 0; i < stages.mesh().edge_count(); ++i) {
    const EdgeId e(i);
    const HalfedgeId h = stages.mesh().halfedge(e);
    const GeneratorId from = stages.labels.label[stages.mesh().from(h)], to = stages.labels.label[stages.mesh().to(h)];
    REQUIRE(crossings.count(e) == (from == to ? 0 : 1));
    if (from == to) continue;
    const Crossing& c = crossings[crossings.first(e)];
    REQUIRE(c.t == 0.5);
    REQUIRE(c.before == from);
    REQUIRE(c.after == to);
  }
}

TEST_CASE("edges are put back to their midpoints, or to no crossing") {
  const Mesh mesh = test::make_grid(kSquares, kSquares);
  test::Stages stages(mesh, test::at_vertices(mesh, {at(2, 6), at(9, 6)}), Front::planar);
  Crossings crossings = find_rough_segments(mesh, stages.labels);
  const std::vector<EdgeId> edges{crossings.items().front().edge, crossings.items().back().edge};
  crossings[CrossingId(0)].t = 0.125;
  const HalfedgeId h = mesh.halfedge(edges[1]);
  stages.labels.label[mesh.to(h)] = stages.labels.label[mesh.from(h)];
  const Progress silent;
  const PaperTracer tracer(stages.working, stages.table(), Front::planar, silent);
  tracer.cross_at_most_once(edges, stages.labels, crossings);
  CHECK(crossings[crossings.first(edges[0])].t == 0.5);
  CHECK(crossings.count(edges[1]) == 0);
}

TEST_CASE("refined segments come near to the bisector of two generators in the plane") {
  const Mesh mesh = test::make_grid(kSquares, kSquares);
  // The bisector is x = 5.7; all rough segments lie between x = 5 and x = 6.
  const test::Stages stages(
      mesh, {vertex_point(mesh, VertexId(at(2, 6))), make_surface_point(FaceId(2 * (6 * kSquares + 9)), {0.6, 0.4, 0})},
      Front::circle);
  const Mesh& working = stages.mesh();
  Crossings crossings = find_rough_segments(working, stages.labels);
  const auto mean_error = [&] {
    double sum = 0;
    for (const Crossing& c : crossings.items()) {
      sum += std::abs(position(working, edge_point(working.halfedge(c.edge), c.t)).x() - 5.7);
    }
    return sum / static_cast<double>(crossings.size());
  };
  const double rough = mean_error();
  const auto estimates = refine_segments(working, stages.table(), crossings);
  CHECK(estimates.size() > 20);
  weld_crossings(estimates, crossings);
  CHECK(rough > 0.15);
  CHECK(mean_error() < 0.25 * rough);
}

/// The paper's steps on a flat grid, up to the grown gaps.
struct FlatGrowth {
  Mesh mesh;
  test::Stages stages;
  Crossings crossings;
  std::vector<ClosedGap> closed;

  explicit FlatGrowth(unsigned seed)
      : mesh(test::make_jittered_grid(kSquares, kSquares, 0.2, seed)),
        stages(mesh, test::random_generators(mesh, 8, seed), Front::planar),
        crossings(find_rough_segments(stages.mesh(), stages.labels)) {
    weld_crossings(refine_segments(stages.mesh(), stages.table(), crossings), crossings);
    IdVector<FaceId, char> is_branching(stages.mesh().face_count());
    for (const FaceId f : stages.mesh().faces()) is_branching[f] = corners_of(f).size() == 3;
    closed =
        close_gaps(stages.input(), crossings, connect_gaps(stages.mesh(), is_branching), {{kPaperRules}, 10, {}}, {});
  }

  std::vector<BoundaryCrossing> corners_of(FaceId f) const { return boundary_crossings(stages.mesh(), crossings, f); }

  Vec2 position_of(const Crossing& c) const {
    return position(stages.mesh(), edge_point(stages.mesh().halfedge(c.edge), c.t)).head<2>();
  }
  Vec2 position_of(const GapNode& node) const {
    if (node.kind == GapNode::Kind::branch) return position(stages.mesh(), {node.face, node.bary}).head<2>();
    return position_of(node.kind == GapNode::Kind::rim ? crossings[node.rim] : node.crossing);
  }
  /// The face outside a gap at a crossing of its rim.
  FaceId outside(const Gap& gap, const GapNode& rim) const {
    const HalfedgeId h = stages.mesh().halfedge(crossings[rim.rim].edge);
    return Mesh::face(gap.contains(Mesh::face(h)) ? stages.mesh().twin(h) : h);
  }
  /// The start of the segment that ends at a crossing of the rim.
  Vec2 start_of_segment(const Gap& gap, const GapNode& rim) const {
    const auto ends = corners_of(outside(gap, rim));
    REQUIRE(ends.size() == 2);
    return position_of(crossings[ends[0].id == rim.rim ? ends[1].id : ends[0].id]);
  }
  /// The image of a generator, as unfolded into the plane of a face.
  Vec2 image(FaceId f, GeneratorId g) const {
    std::array<Vec2, 3> corner;
    for (std::size_t i = 0; i < 3; ++i) corner[i] = stages.mesh().position(stages.mesh().vertices(f)[i]).head<2>();
    return unfold_generator(corner, corner_distances(stages.input(), f, g));
  }
};

/// The arc of a grown gap that ends at a node, or null.
const GapArc* arc_to(const GrownGap& grown, int node) {
  const auto found = std::ranges::find(grown.arcs, node, &GapArc::end);
  return found == grown.arcs.end() ? nullptr : &*found;
}

/// The first arc of the end that grew to this one, from the rim or from a branch point.
const GapArc& first_arc(const GrownGap& grown, const GapArc& arc) {
  const GapArc* before = grown.nodes[arc.begin].kind == GapNode::Kind::crossing ? arc_to(grown, arc.begin) : nullptr;
  return before == nullptr ? arc : first_arc(grown, *before);
}

/// The arcs of the ends that start at the rim and that no joining turned aside: to a new crossing or a branch point.
std::vector<GapArc> stretched_arcs(const GrownGap& grown) {
  std::vector<GapArc> arcs;
  std::map<int, int> ended;  // arcs up to now that end at a node
  for (const GapArc& arc : grown.arcs) {
    const GapNode::Kind kind = grown.nodes[arc.end].kind;
    const int own = kind == GapNode::Kind::branch ? 2 : kind == GapNode::Kind::crossing ? 1 : 0;
    const bool joined = ended[arc.end]++ >= own;
    if (!joined && grown.nodes[first_arc(grown, arc).begin].kind == GapNode::Kind::rim) arcs.push_back(arc);
  }
  return arcs;
}

TEST_CASE("the traced segments are stretched: on a flat mesh each goes on straight") {
  int stretched = 0, through_faces = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const FlatGrowth x(seed);
    for (const auto& [gap, grown, merged] : x.closed) {
      for (const GapArc& arc : stretched_arcs(grown)) {
        const GapNode& start = grown.nodes[first_arc(grown, arc).begin];
        const Vec2 before = x.start_of_segment(gap, start), from = x.position_of(start);
        const Vec2 to = x.position_of(grown.nodes[arc.end]);
        REQUIRE(std::abs(cross((from - before).normalized(), (to - from).normalized())) < 1e-5);
        ++stretched;
        through_faces += arc.begin != first_arc(grown, arc).begin ? 1 : 0;
      }
    }
  }
  CHECK(stretched > 100);
  CHECK(through_faces > 20);
}

TEST_CASE("images are kept over each edge: a branch point has the distances to the images of the starts") {
  int branches = 0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const FlatGrowth x(seed);
    for (const auto& [gap, grown, merged] : x.closed) {
      for (int n = 0; n < std::ssize(grown.nodes); ++n) {
        if (grown.nodes[n].kind != GapNode::Kind::branch) continue;
        std::vector<GapArc> arcs = stretched_arcs(grown);
        std::erase_if(arcs, [&](const GapArc& arc) { return arc.end != n; });
        if (arcs.size() != 2) continue;
        if (arcs[0].right != arcs[1].left) std::swap(arcs[0], arcs[1]);
        const auto distance = [&, &closed_gap = gap, &growth = grown](const GapArc& arc, GeneratorId g) {
          const GapNode& start = growth.nodes[first_arc(growth, arc).begin];
          return (x.image(x.outside(closed_gap, start), g) - x.position_of(growth.nodes[n])).norm();
        };
        const auto& [first, second] = std::pair(arcs[0], arcs[1]);
        const double between = 0.5 * (distance(first, first.right) + distance(second, second.left));
        const double mean = (distance(first, first.left) + between + distance(second, second.right)) / 3;
        REQUIRE(grown.nodes[n].distance == Approx(mean).epsilon(1e-6));
        ++branches;
      }
    }
  }
  CHECK(branches > 30);
}

TEST_CASE("a face of three labels outside the gap has no segment to stretch: the gap has to take it") {
  const FlatGrowth x(1);
  int branching = 0;
  for (const FaceId f : x.stages.mesh().faces()) {
    const HalfedgeId twin = x.stages.mesh().twin(Mesh::halfedge(f, 0));
    if (x.corners_of(f).size() != 3 || !twin.valid() || x.corners_of(Mesh::face(twin)).size() != 2) continue;
    const GrowthOutcome outcome = grow_bisectors(x.stages.input(), x.crossings, {{Mesh::face(twin)}}, kPaperRules);
    CHECK_FALSE(outcome.grown);
    CHECK(outcome.entered == f);
    ++branching;
  }
  CHECK(branching > 2);
}

TEST_CASE("the distance at an edge midpoint is the mean of those at the edge's ends, for every entry of the tables") {
  const Mesh mesh = test::make_sphere(2);
  const test::Stages stages(mesh, test::random_generators(mesh, 9, 1), Front::planar);
  std::size_t entries = 0;
  for (std::int32_t i = 0; i < stages.mesh().face_count(); ++i) {
    const FaceId f(i);
    stages.table().for_each(f, [&](const TableEntry& entry) {
      const auto middle = find_midpoint_distances(stages.table(), f, entry.generator);
      REQUIRE(middle);
      const auto corner = stages.table().corner_distances(entry);
      for (std::size_t k = 0; k < 3; ++k) REQUIRE((*middle)[k] == 0.5 * (corner[k] + corner[(k + 1) % 3]));
      ++entries;
    });
  }
  CHECK(entries > static_cast<std::size_t>(mesh.face_count()));
  CHECK_FALSE(find_midpoint_distances(stages.table(), FaceId(0), GeneratorId(9)));
}

}  // namespace gvd::test_trace_paper
