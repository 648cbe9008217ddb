#include <cmath>
#include <random>

#include "gvd/diagram.hpp"
#include "io/view/view_triangulate.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_view_triangulate {

using namespace test;

double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

double area(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += area(Vec2(0, 0), polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

/// Checks that the triangles are positive and add up to the polygon's area; returns them.
std::vector<std::array<std::uint32_t, 3>> check_triangles(const std::vector<Vec2>& polygon) {
  const auto triangles = io::triangulate_polygon(polygon);
  double sum = 0;
  for (const auto& [i, j, k] : triangles) {
    const double a = area(polygon[i], polygon[j], polygon[k]);
    CHECK(a > 0);
    sum += a;
  }
  CHECK(sum == Approx(area(polygon)).margin(1e-13));
  return triangles;
}

TEST_CASE("polygons without area have no triangles") {
  CHECK(io::triangulate_polygon({}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {1, 0}}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {1, 0}, {0.5, 0}}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {0, 0}, {0, 0}, {0, 0}}).empty());
}

TEST_CASE("simple polygons are covered by their triangles") {
  CHECK(check_triangles({{0, 0}, {1, 0}, {0, 1}}).size() == 1);
  CHECK(check_triangles({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}).size() == 2);
  CHECK(check_triangles({{0, 0}, {0.8, 0}, {0.8, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {0, 0.8}}).size() == 4);  // an L
  CHECK(check_triangles({{0, 0}, {1, 0}, {0.3, 0.3}, {0, 1}}).size() == 2);  // an arrow head
}

TEST_CASE("corners on a straight side and repeated corners keep their triangles") {
  CHECK(check_triangles({{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {1, 0}, {0, 1}}).size() == 4);
  CHECK(check_triangles({{0, 0}, {0.5, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}).size() == 2);
}

TEST_CASE("a polygon that is bridged to its hole is covered") {
  check_triangles({{0, 0}, {0.9, 0}, {0, 0.9}, {0, 0}, {0.1, 0.1}, {0.1, 0.3}, {0.3, 0.1}, {0.1, 0.1}});
}

TEST_CASE("random star-shaped polygons are covered by their triangles") {
  std::mt19937 random(3);
  const auto uniform = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + round % 40;
    std::vector<Vec2> polygon;
    for (int i = 0; i < n; ++i) {
      const double r = 0.05 + 0.25 * uniform(), angle = 2 * 3.14159265358979 * (i + 0.8 * uniform()) / n;
      polygon.emplace_back(0.3 + r * std::cos(angle), 0.3 + r * std::sin(angle));
    }
    check_triangles(polygon);
  }
}

TEST_CASE("the pieces of diagrams are covered by their triangles") {
  for (const auto& [name, mesh] : small_family()) {
    for (const Method method : {Method::exact, Method::gbgvd}) {
      for (const int count : {3, 50, 800}) {
        INFO(name << ", " << count << " generators, exact: " << (method == Method::exact));
        DiagramOptions options;
        options.method = method;
        double worst = 0;
        for (const FacePiece& piece : compute_diagram(mesh, random_generators(mesh, count, 6), options).pieces) {
          std::vector<Vec2> polygon;
          for (const auto& corner : piece.corners) polygon.emplace_back(corner[1], corner[2]);
          double sum = 0;
          for (const auto& [i, j, k] : io::triangulate_polygon(polygon))
            sum += area(polygon[i], polygon[j], polygon[k]);
          worst = std::max(worst, std::abs(sum - area(polygon)));
        }
        CHECK(worst < 1e-12);
      }
    }
  }
}

}  // namespace gvd::test_view_triangulate
