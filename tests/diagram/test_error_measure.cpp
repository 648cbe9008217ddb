#include <cmath>
#include <limits>

#include "diagram/absolute_integral.hpp"
#include "gvd/error.hpp"
#include "gvd/error_measure.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/section.hpp"

namespace gvd::test_error_measure {

const GeneratorId kLeft(0), kRight(1);

/// Exact on a flat convex mesh.
ExactDistances straight_lines(const Mesh& mesh) {
  return [&mesh](const std::vector<DistanceQuery>& queries) {
    std::vector<std::vector<double>> distances;
    for (const DistanceQuery& query : queries) {
      std::vector<double>& row = distances.emplace_back();
      for (const SurfacePoint& p : query.points) {
        row.push_back((position(mesh, p) - position(mesh, query.generator)).norm());
      }
    }
    return distances;
  };
}

/// An 8 x 6 grid with generators at (1, 3) and (7, 3): their bisector is x = 4.
struct Plane {
  Mesh mesh = test::make_grid(8, 6);
  Diagram diagram;

  Plane() { diagram.generators = {vertex_point(mesh, VertexId(3 * 9 + 1)), vertex_point(mesh, VertexId(3 * 9 + 7))}; }

  void add_section(const Vec3& normal, double offset) {
    diagram.bisectors.push_back(*test::make_section(mesh, normal, offset, kLeft, kRight));
  }
  ErrorMeasure measure(int panels = 1) const {
    return compute_error_measure(mesh, diagram, straight_lines(mesh), {panels});
  }
};

/// The integral of sqrt(a^2 + t^2) over t in [-3, 3].
double integral_of_distance(double a) { return 3 * std::hypot(a, 3) + a * a * std::asinh(3 / a); }

std::array<double, 4> samples_of(double (*f)(double)) {
  return {f(kLobattoNodes[0]), f(kLobattoNodes[1]), f(kLobattoNodes[2]), f(kLobattoNodes[3])};
}

TEST_CASE("the absolute integral is exact for polynomials as documented") {
  CHECK(integrate_absolute({0, 0, 0, 0}) == 0);
  CHECK(integrate_absolute(samples_of([](double x) { return x * x * x * x * x; })) == Approx(1.0 / 6).epsilon(1e-14));
  CHECK(integrate_absolute(samples_of([](double x) { return x - 0.5; })) == Approx(0.25).epsilon(1e-14));
  CHECK(integrate_absolute(samples_of([](double x) { return kLobattoNodes[1] - x; })) ==
        Approx((std::pow(kLobattoNodes[1], 2) + std::pow(1 - kLobattoNodes[1], 2)) / 2).epsilon(1e-14));
  CHECK(integrate_absolute(samples_of([](double x) { return (x - 0.1) * (x - 0.5) * (x - 0.9); })) ==
        Approx(2 * (0.0064 + 0.002025)).epsilon(1e-13));
}

TEST_CASE("E is 0 on the true bisector, through vertices and through faces") {
  Plane plane;
  Bisector straight{kLeft, kRight, false, {}, {}};
  for (int j = 0; j <= 6; ++j) straight.points.push_back(vertex_point(plane.mesh, VertexId(9 * j + 4)));
  plane.diagram.bisectors.push_back(straight);
  CHECK(plane.measure().error_integral <= 1e-14);
  CHECK(plane.measure().length == Approx(6));

  Plane slanted;
  slanted.diagram.generators[1] = vertex_point(slanted.mesh, VertexId(5 * 9 + 6));
  slanted.add_section(Vec3(5, 2, 0), 0.5 * (36 + 25 - 1 - 9));
  CHECK(slanted.measure().error_integral <= 1e-13);
  CHECK(slanted.measure().error_max <= 1e-14);
  CHECK(slanted.measure().length > 5);
}

TEST_CASE("E of a shifted bisector is the integral known in closed form") {
  Plane plane;
  const double shift = 0.3;
  plane.add_section(Vec3(1, 0, 0), 4 + shift);
  const double expected = integral_of_distance(3 + shift) - integral_of_distance(3 - shift);
  const ErrorMeasure measure = plane.measure();
  CHECK(measure.error_integral == Approx(expected).epsilon(1e-8));
  CHECK(measure.error_max == Approx(2 * shift).epsilon(1e-2));
  CHECK(measure.length == Approx(6));
  CHECK(measure.error_mean == Approx(expected / 6).epsilon(1e-8));
  CHECK(plane.measure(8).error_integral == Approx(expected).epsilon(1e-13));
}

TEST_CASE("the quadrature does not suffer from a change of sign") {
  Plane plane;  // turned about (4, 3.05), so that the difference changes sign inside a segment
  const Vec3 normal(1, 0.2, 0);
  plane.add_section(normal, 4 + 0.2 * 3.05);
  double expected = 0;
  const int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double y = 6 * (i + 0.5) / steps, x = 4 - 0.2 * (y - 3.05);
    expected += std::abs(std::hypot(x - 1, y - 3) - std::hypot(x - 7, y - 3)) * 6 * std::hypot(1, 0.2) / steps;
  }
  CHECK(plane.measure(1).error_integral == Approx(expected).epsilon(1e-7));
  CHECK(plane.measure(16).error_integral == Approx(expected).epsilon(1e-9));
}

TEST_CASE("a closed bisector is integrated around its whole loop") {
  const Mesh mesh = test::make_sphere(2);
  Diagram diagram;
  diagram.generators = {vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(3))};
  diagram.bisectors.push_back(*test::make_section(mesh, Vec3(0.1, 0.2, 1), 0.05, kLeft, kRight));
  REQUIRE(diagram.bisectors[BisectorId(0)].closed);
  double length = 0;
  const auto& points = diagram.bisectors[BisectorId(0)].points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    length += (position(mesh, points[i]) - position(mesh, points[(i + 1) % points.size()])).norm();
  }
  const ErrorMeasure measure = compute_error_measure(mesh, diagram, straight_lines(mesh));
  CHECK(measure.length == Approx(length).epsilon(1e-13));
  CHECK(measure.length > 6);
}

TEST_CASE("a bisector between a cell and itself is left out, and no bisector gives zeros") {
  Plane plane;
  CHECK(plane.measure().error_mean == 0);
  plane.add_section(Vec3(1, 0, 0), 2.5);
  plane.diagram.bisectors[BisectorId(0)].right = kLeft;
  CHECK(plane.measure().length == 0);
  CHECK(plane.measure().error_integral == 0);
  CHECK(plane.measure().error_max == 0);
}

TEST_CASE("a sample that can't be reached makes E infinite, never NaN") {
  Plane plane;
  plane.add_section(Vec3(1, 0, 0), 4.2);
  const ExactDistances nothing = [](const std::vector<DistanceQuery>& queries) {
    std::vector<std::vector<double>> distances;
    for (const DistanceQuery& query : queries) {
      distances.emplace_back(query.points.size(), std::numeric_limits<double>::infinity());
    }
    return distances;
  };
  const ErrorMeasure measure = compute_error_measure(plane.mesh, plane.diagram, nothing);
  CHECK(std::isinf(measure.error_integral));
  CHECK(std::isinf(measure.error_mean));
  CHECK(std::isinf(measure.error_max));
  CHECK(measure.length == Approx(6));
}

TEST_CASE("the solver is called once, with one query for each generator of a bisector, in order") {
  Plane plane;
  plane.diagram.generators.insert(plane.diagram.generators.begin() + 1, vertex_point(plane.mesh, VertexId(0)));
  plane.diagram.bisectors.push_back(
      *test::make_section(plane.mesh, Vec3(1, 0, 0), 4.2, GeneratorId(2), GeneratorId(0)));
  int calls = 0;
  const auto exact = straight_lines(plane.mesh);
  const ExactDistances counting = [&](const std::vector<DistanceQuery>& queries) {
    ++calls;
    CHECK(queries.size() == 2);
    CHECK(queries[0].generator == plane.diagram.generators[0]);
    CHECK(queries[1].generator == plane.diagram.generators[2]);
    return exact(queries);
  };
  compute_error_measure(plane.mesh, plane.diagram, counting);
  CHECK(calls == 1);
}

TEST_CASE("a diagram that does not match the mesh is refused, and the bisector is named") {
  const auto refused = [](const Plane& plane, const ExactDistances& exact, int panels) {
    try {
      compute_error_measure(plane.mesh, plane.diagram, exact, {panels});
    } catch (const Error& error) {
      return error.code();
    }
    FAIL("not refused");
    return ErrorCode::interrupted;
  };
  Plane plane;
  plane.add_section(Vec3(1, 0, 0), 4.2);
  const auto exact = straight_lines(plane.mesh);
  CHECK(refused(plane, exact, 0) == ErrorCode::invalid_option);
  CHECK(refused(
            plane, [](const auto&) { return std::vector<std::vector<double>>(2); }, 1) == ErrorCode::precondition);
  Plane jump = plane;
  jump.diagram.bisectors[BisectorId(0)].points[1] = vertex_point(jump.mesh, VertexId(0));
  CHECK(refused(jump, exact, 1) == ErrorCode::precondition);
  Plane outside = plane;
  outside.diagram.bisectors[BisectorId(0)].points[1].face = FaceId(9999);
  CHECK(refused(outside, exact, 1) == ErrorCode::precondition);
  Plane stranger = plane;
  stranger.diagram.bisectors[BisectorId(0)].right = GeneratorId(7);
  CHECK(refused(stranger, exact, 1) == ErrorCode::precondition);
}

}  // namespace gvd::test_error_measure
