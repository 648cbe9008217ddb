#include <cmath>
#include <numbers>

#include "bench/comparisons.hpp"
#include "comparators.hpp"
#include "judge.hpp"
#include "rvd.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_judge {

using namespace paper;

TEST_CASE("the judge counts each wrong label, and forgives ties") {
  const Mesh mesh = test::make_grid(4, 2);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(5)), vertex_point(mesh, VertexId(9))};
  Diagram diagram = compute_diagram(mesh, generators);
  const Judge judge(mesh, generators);
  CHECK(judge.judge(diagram).wrong_labels == 0);
  CHECK(judge.judge(diagram).labelled == 15);
  CHECK(judge.judge(diagram).error.error_integral < 1e-9);
  const VertexId on_bisector(7), at_first(5), at_second(9);
  diagram.vertex_label[on_bisector] = GeneratorId(1);
  CHECK(judge.judge(diagram).wrong_labels == 0);
  diagram.vertex_label[at_first] = GeneratorId(1);
  diagram.vertex_label[at_second] = GeneratorId();
  CHECK(judge.judge(diagram).wrong_labels == 2);
}

TEST_CASE("the distances of fields are those of the plane on a flat mesh") {
  const Mesh mesh = test::make_grid(3, 3);
  const DistanceQuery query{vertex_point(mesh, VertexId(0)), {vertex_point(mesh, VertexId(15))}};
  CHECK(compute_field_distances(mesh, {query})[0][0] == Approx(std::sqrt(18.0)));
}

TEST_CASE("vertices that nothing reaches are not judged") {
  const Mesh mesh = test::make_two_components();
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0))};
  const Judgement found = Judge(mesh, generators).judge(compute_diagram(mesh, generators));
  CHECK(found.labelled < mesh.vertex_count());
  CHECK(found.wrong_labels == 0);
}

TEST_CASE("distances on the part that paths can visit are those of the whole mesh") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const ExactField field(mesh, {vertex_point(mesh, VertexId(0))});
    DistanceQuery query{vertex_point(mesh, VertexId(0)), {}};
    for (int f = 0; f < mesh.face_count(); f += 7)
      query.points.push_back(make_surface_point(FaceId(f), {0.2, 0.5, 0.3}));
    const std::vector<double> found = compute_field_distances(mesh, {query})[0];
    for (std::size_t i = 0; i < found.size(); ++i) {
      const double expected = field.nearest(query.points[i]).distance;
      if (std::isfinite(expected)) CHECK(found[i] == Approx(expected).epsilon(1e-12));
      if (!std::isfinite(expected)) CHECK(std::isinf(found[i]));
    }
  }
}

constexpr double kPi = std::numbers::pi;

Diagram with_bisector(std::vector<SurfacePoint> points, bool closed = false) {
  Diagram diagram;
  Bisector bisector;
  bisector.points = std::move(points);
  bisector.closed = closed;
  diagram.bisectors.push_back(bisector);
  return diagram;
}

SurfacePoint in_face(double v, double w) { return make_surface_point(FaceId(0), {1 - v - w, v, w}); }

TEST_CASE("a bisector turns by the angles at its inner points, to either side") {
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
  CHECK(sum_turning_angles(mesh, with_bisector({in_face(0.1, 0.1), in_face(0.4, 0.1)})) == 0);
  CHECK(sum_turning_angles(mesh, with_bisector({in_face(0.1, 0.1), in_face(0.2, 0.1), in_face(0.2, 0.2),
                                                in_face(0.3, 0.2)})) == Approx(kPi));
  const Diagram closed =
      with_bisector({in_face(0.1, 0.1), in_face(0.2, 0.1), in_face(0.2, 0.2), in_face(0.1, 0.2)}, true);
  CHECK(sum_turning_angles(mesh, closed) == Approx(2 * kPi));
}

TEST_CASE("points in one place do not turn, and one point or none neither") {
  const Mesh mesh = test::make_triangle();
  const SurfacePoint a = in_face(0.1, 0.1), b = in_face(0.2, 0.2), c = in_face(0.3, 0.3);
  CHECK(sum_turning_angles(mesh, with_bisector({a, b, b, c})) == Approx(0).margin(1e-6));
  CHECK(sum_turning_angles(mesh, with_bisector({a})) == 0);
  CHECK(sum_turning_angles(mesh, with_bisector({})) == 0);
}

TEST_CASE("a straight line over a folded edge turns by nothing") {
  // Two faces at a right angle along the y axis; the line runs in both at 45 degrees to it.
  const Mesh mesh = test::make_mesh({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 1, 1}}, {{0, 1, 2}, {1, 0, 3}});
  const SurfacePoint before = make_surface_point(FaceId(0), {0.5, 0.25, 0.25});
  const SurfacePoint middle = edge_point(Mesh::halfedge(FaceId(0), 0), 0.5);
  const SurfacePoint after = make_surface_point(FaceId(1), {0.5, 0.25, 0.25});
  CHECK(sum_turning_angles(mesh, with_bisector({before, middle, after})) == Approx(0).margin(1e-12));
}

TEST_CASE("diffusion diagrams zig-zag more than exact ones") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2);
  std::vector<SurfacePoint> generators;
  for (int i = 0; i < 10; ++i) generators.push_back(vertex_point(mesh, VertexId(1 + 60 * i)));
  const Diagram exact = compute_diagram(mesh, generators);
  const Diagram diffusion = compute_diffusion(mesh, generators).diagram;
  CHECK(sum_turning_angles(mesh, diffusion) / diffusion.length > 2 * sum_turning_angles(mesh, exact) / exact.length);
}

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

TEST_CASE("by straight distances RVD has no error, and the exact diagram has one off the plane only") {
  const Mesh mesh = test::make_bumpy_sphere(3, 2), grid = test::make_grid(8, 4);
  const auto generators = test::vertex_points(mesh, 10, 1, 60), corners = test::vertex_points(grid, 2, 0, 8);
  const OtherJudge judge(mesh, generators);
  CHECK(judge.judge(compute_rvd(mesh, generators).diagram).by_straight < 1e-12);
  CHECK(judge.judge(compute(mesh, generators, Method::exact)).by_straight > 1e-2);
  CHECK(OtherJudge(grid, corners).judge(compute(grid, corners, Method::exact)).by_straight < 1e-9);
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

}  // namespace gvd::test_judge
