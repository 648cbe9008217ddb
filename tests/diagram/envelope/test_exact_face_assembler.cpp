#include <algorithm>
#include <cmath>

#include "diagram/envelope/exact_face_assembler.hpp"
#include "support/catch.hpp"
#include "support/hand_made_field.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_exact_face_assembler {

using test::from_corner;
using test::HandMadeField;
using test::through_side;

const GeneratorId kA(0), kB(1), kC(2);
const Vec2 k0(0, 0), k1(2, 0), k2(0.5, 1.5);  // corners of test::make_triangle, in its layout

/// The crossings of the triangle's edges, in the order of its sides, at parameters along the sides.
struct SideCrossing {
  int side;
  double t;
  GeneratorId before, after;
};

Crossings crossings_on(const Mesh& mesh, const std::vector<SideCrossing>& sides) {
  std::vector<Crossing> items;
  for (const SideCrossing& c : sides) {
    const HalfedgeId h = Mesh::halfedge(FaceId(0), c.side);
    const bool along = mesh.halfedge(mesh.edge(h)) == h;
    items.push_back({mesh.edge(h), along ? c.t : 1 - c.t, along ? c.before : c.after, along ? c.after : c.before});
  }
  std::sort(items.begin(), items.end(),
            [](const Crossing& a, const Crossing& b) { return std::pair(a.edge, a.t) < std::pair(b.edge, b.t); });
  return Crossings(mesh.edge_count(), std::move(items));
}

/// The triangle, assembled from hand-made sources.
struct Assembled {
  Mesh mesh = test::make_triangle();
  HandMadeField field;
  Crossings crossings;
  AssembledFaces result;

  Assembled(std::vector<FaceSource> sources, const std::vector<SideCrossing>& sides, double tolerance)
      : field(std::move(sources)), crossings(crossings_on(mesh, sides)) {
    ExactFaceAssembler assembler(mesh, crossings, field, {}, tolerance);
    assembler.assemble(FaceId(0));
    result = assembler.take_result();
  }
};

/// The parameter on a side at which the images a and b, with their offsets, are equally far.
double equal_on(int side, const FaceSource& a, const FaceSource& b) {
  const std::array<Vec2, 3> corner{k0, k1, k2};
  const Vec2 from = corner[std::size_t(side)], to = corner[std::size_t((side + 1) % 3)];
  const auto error = [&](double t) { return a.distance(from + t * (to - from)) - b.distance(from + t * (to - from)); };
  double low = 0, high = 1;
  const bool rising = error(0) < 0;
  for (int i = 0; i < 100; ++i) ((error(0.5 * (low + high)) < 0) == rising ? low : high) = 0.5 * (low + high);
  return low;
}

/// A generator at each corner.
std::vector<FaceSource> at_corners() {
  return {from_corner(0, 0, k0, 0), from_corner(1, 1, k1, 0), from_corner(2, 2, k2, 0)};
}

TEST_CASE("a face without crossings adds nothing") {
  const Assembled face(at_corners(), {}, 1e-3);
  CHECK(face.result.diagram.arcs.empty());
  CHECK(face.result.diagram.branches.empty());
  CHECK(face.result.straightened == 0);
}

TEST_CASE("two crossings of generators with equal offsets make one straight arc") {
  const auto sources = at_corners();
  const Assembled face({sources[0], sources[1]}, {{0, 0.5, kA, kB}, {1, equal_on(1, sources[1], sources[0]), kB, kA}},
                       1e-6);
  REQUIRE(face.result.diagram.arcs.size() == 1);
  CHECK(face.result.diagram.arcs[0].point_count == 0);
  CHECK(face.result.diagram.branches.empty());
}

TEST_CASE("an arc between different offsets is refined until it is within the tolerance") {
  const FaceSource a = from_corner(0, 0, k0, 0), b = from_corner(1, 1, k1, 0.5);
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    const Assembled face({a, b}, {{0, equal_on(0, a, b), kA, kB}, {1, equal_on(1, b, a), kB, kA}}, tolerance);
    REQUIRE(face.result.diagram.arcs.size() == 1);
    const FaceLayout layout(face.mesh, FaceId(0));
    for (const Bary& p : face.result.diagram.points) {
      const Vec2 at = layout.at(p);
      REQUIRE(std::abs(a.distance(at) - b.distance(at)) <= 2e-2 * tolerance + 1e-14);
    }
    if (tolerance < 1e-3) CHECK(face.result.diagram.points.size() > 1);
  }
}

TEST_CASE("three crossings make a branch point that is equally far from the three, with its distance") {
  const auto s = at_corners();
  const Assembled face(s,
                       {{0, equal_on(0, s[0], s[1]), kA, kB},
                        {1, equal_on(1, s[1], s[2]), kB, kC},
                        {2, equal_on(2, s[2], s[0]), kC, kA}},
                       1e-4);
  const FaceDiagram& diagram = face.result.diagram;
  REQUIRE(diagram.branches.size() == 1);
  CHECK(diagram.arcs.size() == 3);
  const FaceBranch& branch = diagram.branches[BranchPointId(0)];
  const Vec2 p = FaceLayout(face.mesh, FaceId(0)).at(branch.bary);
  for (const FaceSource& source : s) CHECK(source.distance(p) == Approx(branch.distance).epsilon(1e-13));
  CHECK(face.result.straightened == 0);
}

TEST_CASE("a branch point that no source reaches gets the distance of the nearest generator") {
  // Only A has a source in the face: the others' crossings contradict it.
  const Assembled face({from_corner(0, 0, k0, 0)}, {{0, 0.5, kA, kB}, {1, 0.5, kB, kC}, {2, 0.5, kC, kA}}, 1e-3);
  REQUIRE(face.result.diagram.branches.size() == 1);
  const FaceBranch& branch = face.result.diagram.branches[BranchPointId(0)];
  CHECK(branch.distance == Approx(FaceLayout(face.mesh, FaceId(0)).at(branch.bary).norm()));
}

TEST_CASE("faces follow each other in one result") {
  const Mesh mesh = test::make_pillow();
  const auto s = at_corners();
  const HandMadeField field({s[0], s[1]});
  const Crossings crossings = crossings_on(mesh, {{0, 0.5, kA, kB}, {1, equal_on(1, s[1], s[0]), kB, kA}});
  ExactFaceAssembler assembler(mesh, crossings, field, {}, 1e-3);
  assembler.assemble(FaceId(0));
  assembler.assemble(FaceId(1));
  const AssembledFaces result = assembler.take_result();
  REQUIRE(result.diagram.arcs.size() == 2);
  CHECK(result.diagram.arcs[0].face == FaceId(0));
  CHECK(result.diagram.arcs[1].face == FaceId(1));
}

}  // namespace gvd::test_exact_face_assembler
