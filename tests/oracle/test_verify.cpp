#include <array>
#include <cmath>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/section.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_verify {

const GeneratorId kLeft(0), kRight(1);

/// The diagram of two generators whose bisector is the plane section normal . p = offset.
Diagram section_diagram(const Mesh& mesh, VertexId left, VertexId right, const Vec3& normal, double offset) {
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, left), vertex_point(mesh, right)};
  diagram.bisectors.push_back(*test::make_section(mesh, normal, offset, kLeft, kRight));
  return diagram;
}

TEST_CASE("E on a flat grid: 0 on the perpendicular bisector, the known integral beside it") {
  const Mesh mesh = test::make_grid(8, 6);
  const VertexId left(3 * 9 + 1), right(3 * 9 + 7);
  CHECK(verify_diagram(mesh, section_diagram(mesh, left, right, Vec3(1, 0, 0), 4)).error_integral <= 1e-12);
  const auto integral = [](double a) { return 3 * std::hypot(a, 3) + a * a * std::asinh(3 / a); };
  const ErrorMeasure shifted = verify_diagram(mesh, section_diagram(mesh, left, right, Vec3(1, 0, 0), 4.3));
  CHECK(shifted.error_integral == Approx(integral(3.3) - integral(2.7)).epsilon(1e-8));
  CHECK(shifted.length == Approx(6));
}

TEST_CASE("E on a sphere tends to the analytic one") {
  // Generators at the two ends of a diameter. On the parallel of latitude b the distances to them differ by 2 b along a
  // length of 2 pi cos(b).
  const double latitude = 0.25;
  double previous = 1;
  for (const int subdivisions : {2, 3, 4}) {
    const Mesh mesh = test::make_sphere(subdivisions);
    const Vec3 axis = mesh.position(VertexId(0));
    REQUIRE((axis + mesh.position(VertexId(3))).norm() < 1e-12);
    const auto at = [&](double offset) {
      return verify_diagram(mesh, section_diagram(mesh, VertexId(3), VertexId(0), axis, offset));
    };
    const double expected = 2 * latitude * 2 * M_PI * std::cos(latitude);
    const double off = std::abs(at(std::sin(latitude)).error_integral / expected - 1);
    CHECK(off < previous / 3);  // second order in the edge length: a factor of 4 each time
    previous = off;
    CHECK(at(1e-9).error_mean < 0.02 / (1 << subdivisions));
  }
  CHECK(previous < 3e-3);
}

TEST_CASE("more panels change E of a curved surface's bisector little, and less each time") {
  const Mesh mesh = test::make_bumpy_sphere(3, 5);
  const Diagram diagram = section_diagram(mesh, VertexId(3), VertexId(0), mesh.position(VertexId(0)).normalized(), 0.1);
  const auto at = [&](int panels) {
    VerifyOptions options;
    options.panels = panels;
    return verify_diagram(mesh, diagram, options).error_integral;
  };
  const double best = at(32);
  CHECK(std::abs(at(1) - best) < 3e-3 * best);
  CHECK(std::abs(at(8) - best) < 1e-4 * best);
}

/// A closed prism of height 10 on a star with `corners` corners: needles on all sides, and fans of them at both ends.
Mesh make_corrugated_prism(int corners) {
  std::vector<Vec3> positions;
  for (const double z : {0.0, 10.0}) {
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * i / corners, radius = i % 3 == 0 ? 1.3 : 1;
      positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
  }
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < corners; ++i) {
    const int next = (i + 1) % corners;
    faces.push_back({i, next, corners + next});
    faces.push_back({i, corners + next, corners + i});
  }
  for (int i = 2; i < corners; ++i) {
    faces.push_back({0, i, i - 1});
    faces.push_back({corners, corners + i - 1, corners + i});
  }
  return test::make_mesh(positions, faces);
}

TEST_CASE(
    "where CGAL misses the shortest path on needles, a path that is there counts, and a right diagram has no error") {
  const Mesh mesh = make_corrugated_prism(192);
  const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 3, 2));
  const ErrorMeasure measure = verify_diagram(mesh, diagram);
  CHECK(measure.corrected > 0);
  CHECK(measure.corrected < measure.distances / 10);
  CHECK(measure.error_max <= 1e-4 * mesh.mean_edge_length());  // the chord tolerance
  // A wrong diagram is still found: this is the bisector of other generators.
  Diagram wrong = diagram;
  wrong.generators[0] = test::random_generators(mesh, 1, 9)[0];
  CHECK(verify_diagram(mesh, wrong).error_max > 0.1);
}

TEST_CASE("a bisector across components that one generator can't reach has an infinite E") {
  const Mesh mesh = test::make_two_components();
  const Diagram diagram = section_diagram(mesh, VertexId(0), VertexId(mesh.vertex_count() - 1), Vec3(0, 0, 1), 0.01);
  CHECK(std::isinf(verify_diagram(mesh, diagram).error_integral));
}

}  // namespace gvd::test_verify
