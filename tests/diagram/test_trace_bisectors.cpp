// From arcs in faces to bisectors: properties of the traced diagram and of its bisectors.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "diagram/trace_bisectors.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/stages.hpp"

namespace gvd::test_trace_bisectors {

struct Traced {
  WorkingMesh working;
  TracedDiagram traced;
  Diagram diagram;

  Traced(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Front front) : working(mesh, generators) {
    const FastMarchingResult marched = march(working, front, {});
    traced = test::trace_growth(working, marched.table, front);
    trace_bisectors(working, traced, ParallelChunks(1, Progress()), diagram);
  }
};

Vec3 position_of(const Traced& t, const ArcEnd& end) {
  if (end.branch.valid()) {
    const FaceBranch& b = t.traced.faces.branches[end.branch];
    return position(t.working.mesh(), {b.face, b.bary});
  }
  const Crossing& c = t.traced.crossings[end.crossing];
  return position(t.working.mesh(), edge_point(t.working.mesh().halfedge(c.edge), c.t));
}

/// Requires properties (1) to (3) of FaceDiagram; test_face_assembly.cpp and test_check_growth.cpp test (4).
void require_sound(const Traced& t) {
  const Mesh& mesh = t.working.mesh();
  const auto& arcs = t.traced.faces.arcs;
  std::map<std::pair<FaceId, CrossingId>, int> ends;
  IdVector<BranchPointId, int> spokes(t.traced.faces.branches.size(), 0);
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    if (i > 0) REQUIRE(arcs[i - 1].face <= arcs[i].face);  // (1)
    REQUIRE(arcs[i].left != arcs[i].right);
    for (const ArcEnd& end : {arcs[i].begin, arcs[i].end}) {
      if (end.crossing.valid()) {
        ++ends[{arcs[i].face, end.crossing}];
      } else {
        REQUIRE(t.traced.faces.branches[end.branch].face == arcs[i].face);
        ++spokes[end.branch];
      }
    }
  }
  std::size_t expected = 0;
  for (std::size_t i = 0; i < t.traced.crossings.size(); ++i) {
    const CrossingId id(static_cast<std::int64_t>(i));
    const HalfedgeId h = mesh.halfedge(t.traced.crossings[id].edge);
    for (const HalfedgeId side : {h, mesh.twin(h)}) {
      if (!side.valid()) continue;
      REQUIRE(ends[{Mesh::face(side), id}] == 1);  // (2)
      ++expected;
    }
  }
  REQUIRE(ends.size() == expected);
  for (const int count : spokes) REQUIRE(count >= 3);  // (3)
}

void require_bisectors(const Traced& t, const Mesh& mesh) {
  double arcs = 0, bisectors = 0;
  std::size_t segments = 0;
  for (const FaceArc& arc : t.traced.faces.arcs) arcs += (position_of(t, arc.begin) - position_of(t, arc.end)).norm();
  IdVector<BranchPointId, std::vector<std::pair<GeneratorId, GeneratorId>>> spokes(t.diagram.branch_points.size());
  for (const Bisector& b : t.diagram.bisectors) {
    const std::size_t n = b.points.size(), last = b.closed ? n : n - 1;
    segments += last;
    for (std::size_t k = 0; k < last; ++k) {
      bisectors += (position(mesh, b.points[k]) - position(mesh, b.points[(k + 1) % n])).norm();
    }
    if (b.closed) REQUIRE((!b.ends[0].valid() && !b.ends[1].valid()));
    if (b.ends[0].valid()) spokes[b.ends[0]].emplace_back(b.right, b.left);
    if (b.ends[1].valid()) spokes[b.ends[1]].emplace_back(b.left, b.right);
    for (const std::size_t e : {std::size_t{0}, std::size_t{1}}) {
      if (!b.ends[e].valid()) continue;
      REQUIRE((e == 0 ? b.points.front() : b.points.back()) == t.diagram.branch_points[b.ends[e]].point);
    }
  }
  REQUIRE(t.diagram.report.unresolved_ends == 0);
  REQUIRE(segments == t.traced.faces.arcs.size());  // every arc in one bisector, once
  REQUIRE(bisectors == Approx(arcs).epsilon(1e-9));
  REQUIRE(t.diagram.length == Approx(bisectors).epsilon(1e-12));
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    // Counter-clockwise: a spoke with cell g on its left precedes the one with g on its right.
    const BranchPointId id(i);
    const auto& named = t.diagram.branch_points[id].generators;
    for (std::size_t k = 0; k < named.size(); ++k) {
      const std::pair<GeneratorId, GeneratorId> spoke(named[k], named[(k + 1) % named.size()]);
      REQUIRE(std::count(spokes[id].begin(), spokes[id].end(), spoke) == 1);
    }
  }
}

TEST_CASE("traced diagrams have properties (1) to (3), and every arc belongs to one bisector, on every family") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : {Front::circle, Front::planar}) {
      for (const int count : {2, 5, 30, 150}) {
        INFO(name << ", " << test::name(front) << ", " << count << " generators");
        const Traced t(mesh, test::random_generators(mesh, count, 13), front);
        require_sound(t);
        require_bisectors(t, mesh);
        REQUIRE(t.traced.counts.gaps >= t.traced.counts.gaps_grown);
        for (const std::int32_t components : t.traced.cell_components) REQUIRE(components == 1);
      }
    }
  }
}

TEST_CASE("on a flat grid the left generator is nearer on the left, and the right one on the right") {
  const Mesh mesh = test::make_grid(24, 17);
  const Traced t(mesh, test::at_vertices(mesh, {28, 355, 195, 63, 417, 211}), Front::circle);
  CHECK(t.diagram.bisectors.size() >= 6);
  for (const Bisector& b : t.diagram.bisectors) {
    const Vec3 &left = mesh.position(t.working.vertex(b.left)), &right = mesh.position(t.working.vertex(b.right));
    for (std::size_t k = 0; k + 1 < b.points.size(); ++k) {
      const Vec3 p = position(mesh, b.points[k]), way = position(mesh, b.points[k + 1]) - p;
      if (way.norm() < 1e-3) continue;
      REQUIRE(Vec3::UnitZ().dot(way.cross(left - p)) > 0);
      REQUIRE(Vec3::UnitZ().dot(way.cross(right - p)) < 0);
    }
  }
}

TEST_CASE("two generators at the poles of a sphere: one closed bisector") {
  const Mesh mesh = test::make_sphere(3);
  const Traced t(mesh, test::at_vertices(mesh, {0, 3}), Front::circle);  // opposite corners of the icosahedron
  REQUIRE(t.diagram.bisectors.size() == 1);
  const Bisector& b = t.diagram.bisectors[BisectorId(0)];
  CHECK(b.closed);
  CHECK(b.points.front() != b.points.back());
  CHECK(t.diagram.branch_points.empty());
  CHECK(t.diagram.length == Approx(2 * 3.14159265358979).epsilon(0.02));
}

TEST_CASE("two generators on a ring: two bisectors from boundary to boundary") {
  const Mesh mesh = test::make_ring(24, 6);
  const Traced t(mesh, test::at_vertices(mesh, {3, 12 * 7 + 3}), Front::circle);
  REQUIRE(t.diagram.bisectors.size() == 2);
  for (const Bisector& b : t.diagram.bisectors) {
    CHECK_FALSE(b.closed);
    CHECK((!b.ends[0].valid() && !b.ends[1].valid()));
    CHECK((b.points.front().kind() == SurfacePoint::Kind::edge && b.points.back().kind() == SurfacePoint::Kind::edge));
  }
  CHECK(t.diagram.length == Approx(1).epsilon(0.05));
}

TEST_CASE("ends where an arc is missing are counted as unresolved, those on the boundary are not") {
  const Mesh sphere = test::make_sphere(3), ring = test::make_ring(24, 6);
  for (const Mesh* mesh : {&sphere, &ring}) {
    const std::vector<int> vertices = mesh == &sphere ? std::vector{0, 3} : std::vector{3, 12 * 7 + 3};
    Traced t(*mesh, test::at_vertices(*mesh, vertices), Front::circle);
    REQUIRE(t.diagram.report.unresolved_ends == 0);
    const std::size_t bisectors = t.diagram.bisectors.size();
    t.traced.faces.arcs.erase(t.traced.faces.arcs.begin() + 7);
    Diagram torn;
    trace_bisectors(t.working, t.traced, ParallelChunks(1, Progress()), torn);
    CHECK(torn.report.unresolved_ends == 2);
    CHECK(torn.bisectors.size() == (mesh == &sphere ? bisectors : bisectors + 1));  // a closed one is opened
    for (const Bisector& b : torn.bisectors) CHECK_FALSE(b.closed);
  }
}

TEST_CASE("one generator has no bisector") {
  const Mesh mesh = test::make_torus(24, 12);
  const Traced t(mesh, test::at_vertices(mesh, {5}), Front::circle);
  CHECK(t.diagram.bisectors.empty());
  CHECK(t.diagram.length == 0);
}

}  // namespace gvd::test_trace_bisectors
