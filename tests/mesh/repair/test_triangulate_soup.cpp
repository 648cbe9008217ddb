#include <cmath>
#include <random>
#include <vector>

#include "base/plane.hpp"
#include "mesh/reading/soup_files.hpp"
#include "mesh/repair/triangulate_soup.hpp"

namespace gvd::test_triangulate_soup {

PolygonSoup one_polygon(std::vector<Vec3> positions) {
  PolygonSoup soup;
  soup.positions = std::move(positions);
  for (std::size_t v = 0; v < soup.positions.size(); ++v) soup.corners.push_back(static_cast<std::int32_t>(v));
  soup.first_corner.push_back(soup.corners.size());
  return soup;
}

// The vector area of a polygon of any shape.
Vec3 vector_area(const PolygonSoup& soup) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < soup.corners.size(); ++i) {
    const auto a = static_cast<std::size_t>(soup.corners[i]);
    const auto b = static_cast<std::size_t>(soup.corners[(i + 1) % soup.corners.size()]);
    sum += 0.5 * soup.positions[a].cross(soup.positions[b]);
  }
  return sum;
}

// Triangles without new vertices, none flipped, and for a flat polygon of its area.
CheckedMesh require_triangulated(const PolygonSoup& soup) {
  CheckedMesh checked = build_mesh(soup, DefectPolicy::error);
  const Vec3 whole = vector_area(soup);
  REQUIRE(checked.mesh.face_count() == static_cast<std::int32_t>(soup.corners.size()) - 2);
  double area = 0;
  for (std::int32_t f = 0; f < checked.mesh.face_count(); ++f) {
    const auto& [a, b, c] = checked.mesh.vertices(FaceId(f));
    const Vec3& p = checked.mesh.position(a);
    const Vec3 normal = (checked.mesh.position(b) - p).cross(checked.mesh.position(c) - p);
    REQUIRE(normal.dot(whole) >= -1e-12 * whole.squaredNorm());
    area += 0.5 * normal.norm();
  }
  CHECK(area == Approx(whole.norm()));
  return checked;
}

void require_refused(const PolygonSoup& soup, const std::string& part) {
  CHECK_THROWS_WITH(build_mesh(soup), Catch::Matchers::Contains(part));
}

TEST_CASE("quads: the better diagonal, the first of equals, the only one of a concave quad") {
  const auto diagonal = [](std::vector<Vec3> positions) {
    const auto checked = require_triangulated(one_polygon(std::move(positions)));
    const auto& face = checked.mesh.vertices(FaceId(0));
    const auto has = [&](int v) { return std::find(face.begin(), face.end(), VertexId(v)) != face.end(); };
    return has(0) && has(2) ? 0 : 1;
  };
  CHECK(diagonal({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}) == 0);
  CHECK(diagonal({{0.1, 0.1, 0.1}, {0.3, 0.1, 0.1}, {0.3, 0.3, 0.1}, {0.1, 0.3, 0.1}}) == 0);
  CHECK(diagonal({{0, 0, 0}, {2, 1, 0}, {4, 0, 0}, {2, -1, 0}}) == 1);
  CHECK(diagonal({{2, -1, 0}, {4, 0, 0}, {2, 1, 0}, {0, 0, 0}}) == 0);
  CHECK(diagonal({{0, 0, 0}, {4, 4, 0}, {1, 1.5, 0}, {0, 4, 0}}) == 0);
  CHECK(diagonal({{0, 4, 0}, {0, 0, 0}, {4, 4, 0}, {1, 1.5, 0}}) == 1);
}

TEST_CASE("a quad with a corner in the middle of a side") {
  CHECK(require_triangulated(one_polygon({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}})).defects.zero_area_faces == 0);
}

TEST_CASE("concave polygons: an L, a comb, a spiral, a star, in any plane and from any corner") {
  std::vector<std::vector<Vec2>> shapes = {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
  std::vector<Vec2> comb{{0, 0}, {21, 0}};
  for (int i = 10; i >= 0; --i) {
    comb.emplace_back(2 * i + 1, 5);
    comb.emplace_back(2 * i + 0.5, 1);
  }
  comb.pop_back();
  comb.emplace_back(0, 5);
  shapes.push_back(comb);
  std::vector<Vec2> spiral, star;
  for (int i = 0; i <= 40; ++i)
    spiral.emplace_back((1 + 0.2 * i) * std::cos(0.4 * i), (1 + 0.2 * i) * std::sin(0.4 * i));
  for (int i = 40; i >= 0; --i)
    spiral.emplace_back((0.5 + 0.2 * i) * std::cos(0.4 * i), (0.5 + 0.2 * i) * std::sin(0.4 * i));
  for (int i = 0; i < 24; ++i)
    star.emplace_back((i % 2 ? 1 : 5) * std::cos(i * 0.2617993878), (i % 2 ? 1 : 5) * std::sin(i * 0.2617993878));
  shapes.push_back(spiral);
  shapes.push_back(star);
  for (const auto& shape : shapes) {
    for (std::size_t turn = 0; turn < shape.size(); turn += 5) {
      std::vector<Vec3> positions;
      for (std::size_t i = 0; i < shape.size(); ++i) {
        const Vec2& p = shape[(i + turn) % shape.size()];
        positions.emplace_back(0.6 * p.x() + 1e3, 0.8 * p.x() - 7, p.y());
      }
      require_triangulated(one_polygon(positions));
    }
  }
}

TEST_CASE("large polygons: convex and concave ones of some thousand corners") {
  std::vector<Vec3> circle, gear;
  for (int i = 0; i < 6000; ++i) {
    const double angle = 6.283185307179586 * i / 6000;
    circle.emplace_back(std::cos(angle), std::sin(angle), 0);
    gear.push_back((i % 4 < 2 ? 1.0 : 0.9) * circle.back());
  }
  require_triangulated(one_polygon(circle));
  gear.resize(2000);
  gear.emplace_back(0, 0, 0);
  require_triangulated(one_polygon(gear));
}

TEST_CASE("a polygon with a bridge to its hole") {
  PolygonSoup soup =
      one_polygon({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}});
  soup.corners = {0, 1, 2, 3, 0, 4, 5, 6, 7, 4};
  soup.first_corner = {0, 10};
  const CheckedMesh checked = build_mesh(soup);
  CHECK(compute_mesh_summary(checked.mesh).area == Approx(12));
  CHECK(compute_mesh_summary(checked.mesh).boundary_loops == 2);
  CHECK(checked.mesh.vertex_count() == 8);
}

TEST_CASE("polygons that are not flat") {
  const auto checked = build_mesh(one_polygon({{0, 0, 0}, {1, 0, 0.3}, {1, 1, 0}, {0, 1, 0.3}}), DefectPolicy::error);
  CHECK(checked.mesh.face_count() == 2);
  const auto hexagon =
      build_mesh(one_polygon({{2, 0, 0.2}, {1, 2, -0.2}, {-1, 2, 0.2}, {-2, 0, -0.2}, {-1, -2, 0.2}, {1, -2, -0.2}}),
                 DefectPolicy::error);
  CHECK(hexagon.mesh.face_count() == 4);
}

TEST_CASE("polygons on a line have no area and are kept") {
  const auto checked = build_mesh(one_polygon({{0, 0, 0}, {1, 1, 0}, {3, 3, 0}, {2, 2, 0}}));
  CHECK(checked.mesh.face_count() == 2);
  CHECK(checked.defects.zero_area_faces == 2);
}

TEST_CASE("quads that cross themselves are cut into their two triangles, and counted as a defect") {
  for (const Vec3& second : {Vec3(1, 1, 0), Vec3(2, 2, 0), Vec3(1, 1, 0.1)}) {
    const PolygonSoup quad = one_polygon({{0, 0, 0}, second, {second.x(), 0, 0}, {0, 1, 0}});
    const auto checked = build_mesh(quad);
    CHECK(checked.mesh.face_count() == 2);
    CHECK(checked.defects.zero_area_faces == 0);
    CHECK(checked.defects.count(DefectKind::crossing_quads) == 1);
    CHECK(checked.defects.messages.front() ==
          "1 quadrilateral is folded or crosses itself, first face 0: cut along a diagonal");
    CHECK_THROWS_WITH(build_mesh(quad, DefectPolicy::error), Catch::Matchers::Contains("crosses itself"));
  }
}

TEST_CASE("a quad whose corners form a tetrahedron is cut, even where both diagonals are edges already") {
  PolygonSoup soup = one_polygon({{0, 1, 0}, {1, 2, 1}, {0, 1, 1}, {0, 2, 1}, {3, 0, 0}, {0, 0, 3}});
  soup.corners = {0, 1, 2, 3, 0, 2, 4, 1, 3, 5};
  soup.first_corner = {0, 4, 7, 10};
  const auto checked = build_mesh(soup);
  CHECK(checked.mesh.face_count() == 4);
  CHECK(checked.defects.zero_area_faces == 0);
  CHECK_THAT(checked.defects.messages.front(), Catch::Matchers::Contains("is folded or crosses itself"));
}

TEST_CASE("other polygons that cross themselves are refused") {
  std::vector<Vec3> pentagram;
  for (int i = 0; i < 5; ++i)
    pentagram.emplace_back(std::cos(i * 2.5132741228718345), std::sin(i * 2.5132741228718345), 0);
  require_refused(one_polygon(pentagram), "crosses itself");
}

TEST_CASE("no diagonal duplicates an edge: three quads in a ring") {
  PolygonSoup soup;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair(0., 0.), std::pair(1., 0.), std::pair(0., 1.)})
      soup.positions.emplace_back(x, y, z);
  }
  soup.corners = {0, 1, 4, 3, 1, 2, 5, 4, 2, 0, 3, 5};
  soup.first_corner = {0, 4, 8, 12};
  const CheckedMesh checked = build_mesh(soup, DefectPolicy::error);
  CHECK(compute_mesh_summary(checked.mesh).boundary_loops == 2);
}

TEST_CASE("random simple polygons round a point are cut without a flipped triangle") {
  std::mt19937 random(23);
  for (int round = 0; round < 300; ++round) {
    const int corners = 4 + static_cast<int>(random() % 20);
    std::vector<Vec3> positions;
    for (int i = 0; i < corners; ++i) {
      const double angle = 6.283185307179586 * i / corners;
      const double radius = 0.1 + static_cast<double>(random() % 1000) / 500;
      positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    INFO("round " << round);
    require_triangulated(one_polygon(positions));
  }
}

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

}  // namespace gvd::test_triangulate_soup
