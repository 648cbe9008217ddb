#include <cmath>

#include "bench/comparisons.hpp"
#include "judging/judge.hpp"
#include "judging/other_errors.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_other_errors {

using namespace paper;

Diagram compute(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Method method) {
  DiagramOptions options;
  options.method = method;
  options.front = Front::planar;
  return compute_diagram(mesh, generators, options);
}

TEST_CASE("on a flat grid the distance integral is that of the line between two generators") {
  const Mesh mesh = test::make_grid(8, 4);
  // At (0, 0) and (8, 0): the bisector is x = 4, with the distance sqrt(16 + y^2).
  const auto generators = test::vertex_points(mesh, 2, 0, 8);
  REQUIRE((position(mesh, generators[1]) - Vec3(8, 0, 0)).norm() < 1e-12);
  const OtherErrors found = OtherJudge(mesh, generators).judge(compute(mesh, generators, Method::exact));
  const double expected = 0.5 * 4 * std::sqrt(32.0) + 8 * std::asinh(1.0);
  CHECK(found.distance == Approx(expected).epsilon(1e-3));
  CHECK(found.of_face < 1e-9);
}

TEST_CASE("by the distances of planar marching, its own diagram has a smaller error than the exact one") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const OtherJudge judge(mesh, generators);
  const Diagram exact = compute(mesh, generators, Method::exact), planar = compute(mesh, generators, Method::gbgvd);
  CHECK(judge.judge(planar).by_marching < 0.5 * judge.judge(exact).by_marching);
}

TEST_CASE("with all generators of a face the error is not less than with two, and more at branch points") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  const auto generators = test::vertex_points(mesh, 10, 1, 60);
  const Diagram exact = compute(mesh, generators, Method::exact), planar = compute(mesh, generators, Method::gbgvd);
  const OtherJudge other(mesh, generators);
  const Judge judge(mesh, generators);
  CHECK(other.judge(exact).of_face > 100 * test::error_of(judge, exact));
  CHECK(other.judge(planar).of_face > test::error_of(judge, planar));
}

TEST_CASE("bisectors without a segment add nothing to other errors") {
  const Mesh mesh = test::make_grid(4, 4);
  const auto generators = test::vertex_points(mesh, 2, 0, 4);
  Diagram diagram = compute(mesh, generators, Method::exact);
  const OtherJudge judge(mesh, generators);
  const double before = judge.judge(diagram).distance;
  Bisector empty;
  empty.left = GeneratorId(0);
  empty.right = GeneratorId(1);
  diagram.bisectors.push_back(empty);
  CHECK(judge.judge(diagram).distance == before);
}

}  // namespace gvd::test_other_errors
