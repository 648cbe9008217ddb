#include <cmath>
#include <vector>

#include "base/plane.hpp"
#include "mesh/repair/triangulate_soup_polygon.hpp"
#include "support/catch.hpp"

namespace gvd::test_triangulate_soup_polygon {

ProjectedPolygon project(const std::vector<Vec3>& corners) {
  std::vector<std::int32_t> polygon;
  for (std::size_t i = 0; i < corners.size(); ++i) polygon.push_back(static_cast<std::int32_t>(i));
  return project_polygon(polygon, corners);
}

double twice_area(const ProjectedPolygon& polygon) {
  return twice_signed_area(polygon.plane.size(), [&](std::size_t i) { return polygon.plane[i]; });
}

TEST_CASE("project_polygon: a square in any plane becomes counter-clockwise, with its area") {
  const std::vector<Vec3> square{{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}};
  const ProjectedPolygon projected = project(square);
  CHECK(projected.turns_once);
  CHECK_FALSE(projected.is_on_line);
  CHECK(twice_area(projected) == Approx(2));  // scaled to 1
  CHECK(twice_area(project({square.rbegin(), square.rend()})) == Approx(2));
}

TEST_CASE("project_polygon: neither very large nor very small coordinates overflow") {
  for (const double size : {1e-70, 1.0, 1e70}) {
    const ProjectedPolygon projected = project({{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}});
    CHECK(projected.turns_once);
    CHECK(twice_area(projected) == Approx(2));
    CHECK(projected.space[2] == Vec3(1, 1, 0));
  }
}

TEST_CASE("project_polygon: corners on a line have all y equal to 0") {
  const ProjectedPolygon projected = project({{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {2, 2, 2}});
  CHECK(projected.is_on_line);
  CHECK(projected.turns_once);
  for (const Vec2& p : projected.plane) CHECK(p.y() == 0);
  CHECK(projected.plane[2].x() == Approx(std::sqrt(3)));
}

TEST_CASE("project_polygon: a bow tie has no normal, a pentagram turns twice") {
  CHECK_FALSE(project({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).turns_once);
  std::vector<Vec3> star;
  for (int i = 0; i < 5; ++i) star.emplace_back(std::cos(0.8 * i * 3.14159265), std::sin(0.8 * i * 3.14159265), 0);
  CHECK_FALSE(project(star).turns_once);
}

}  // namespace gvd::test_triangulate_soup_polygon
