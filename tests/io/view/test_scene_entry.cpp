// Arrays of a page, the frame of its coordinates, and triangles of cut faces.
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "gvd/diagram.hpp"
#include "io/view/scene_entry.hpp"
#include "io/view/view_blobs.hpp"
#include "mesh/reading/array_bytes.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_scene_entry {

using namespace test;

/// The content of an array of `size` bytes.
std::string unpack(const io::ViewBlobs& blobs, int blob, std::uint64_t size) {
  const std::string html = blobs.html(), id = "id=\"blob-" + std::to_string(blob) + "\">";
  const std::size_t first = html.find(id) + id.size();
  ArrayBytes packed(std::string_view(html).substr(first, html.find('<', first) - first), true);
  ExpansionLimit limit(html.size(), "page");
  std::string content;
  CHECK(append_inflated(content, packed.take(packed.most()), size, limit));
  return content;
}

TEST_CASE("arrays are little-endian, narrow, and stored once") {
  io::ViewBlobs blobs;
  CHECK(blobs.add_integers({1, 255}) == nlohmann::json({{"blob", 0}, {"type", "u8"}, {"count", 2}}));
  CHECK(blobs.add_integers({1, 256}) == nlohmann::json({{"blob", 1}, {"type", "u16"}, {"count", 2}}));
  CHECK(blobs.add_integers({65536}) == nlohmann::json({{"blob", 2}, {"type", "u32"}, {"count", 1}}));
  CHECK(blobs.add_floats({1.0f}) == nlohmann::json({{"blob", 3}, {"type", "f32"}, {"count", 1}}));
  CHECK(blobs.add_integers({1, 256})["blob"] == 1);
  CHECK(unpack(blobs, 1, 4) == std::string("\1\0\0\1", 4));
  CHECK(blobs.html().find("blob-4") == std::string::npos);
}

TEST_CASE("an empty array is an array, and arrays of other types with equal bytes are stored once") {
  io::ViewBlobs blobs;
  CHECK(blobs.add_integers({}) == nlohmann::json({{"blob", 0}, {"type", "u8"}, {"count", 0}}));
  CHECK(blobs.add_floats({}) == nlohmann::json({{"blob", 0}, {"type", "f32"}, {"count", 0}}));
  CHECK(blobs.add_integers({0, 0, 0, 0})["blob"] == 1);
  CHECK(blobs.add_floats({0.0f})["blob"] == 1);
  CHECK(unpack(blobs, 0, 0).empty());
  CHECK(unpack(blobs, 1, 4) == std::string(4, '\0'));
}

TEST_CASE("coordinates are rounded differences by bytes, and shares keep their complements") {
  io::ViewBlobs blobs;
  const double unit = std::ldexp(1, -20);
  const nlohmann::json reference = blobs.add_coordinates({3 * unit, -1.4 * unit, 0, 301 * unit, 0, -0.2 * unit});
  CHECK(reference == nlohmann::json({{"blob", 0}, {"type", "u16"}, {"count", 6}, {"unit", unit}, {"step", 3}}));
  CHECK(unpack(blobs, 0, 12) == std::string("\6\1\0\x54\2\0\0\0\0\2\0\0", 12));
  CHECK(blobs.add_coordinates({0.5, 0.5, 0.5})["type"] == "u32");
  CHECK(blobs.add_coordinates({1e300, -1e300, 0})["count"] == 3);
  std::mt19937 random(5);
  for (int i = 0; i < 100; ++i) {
    const double b = double(random()) / double(std::mt19937::max());
    io::ViewBlobs pair;
    CHECK(pair.add_shares({b, 1 - b, 1})["unit"] == 1.0 / 65535);
    const std::string bytes = unpack(pair, 0, 6);
    const auto part = [&](std::size_t k) { return std::uint8_t(bytes[2 * k]) + 256 * std::uint8_t(bytes[2 * k + 1]); };
    CHECK(part(0) + part(1) == 65535);
    CHECK(part(0) / 65535.0 == Approx(b).margin(0.5 / 65535));
  }
}

ViewScene scene_of(const Mesh& mesh) {
  ViewScene scene;
  scene.mesh = &mesh;
  return scene;
}

TEST_CASE("the frame is the centre and half the diagonal of the box around all scenes") {
  const Mesh grid = make_grid(4, 3);
  const io::ViewFrame frame = io::compute_view_frame({scene_of(grid)});
  CHECK((frame.origin - Vec3(2, 1.5, 0)).norm() < 1e-15);
  CHECK(frame.scale == Approx(2.5));
  const Mesh far({{10, 0, 0}, {11, 0, 0}, {10, 3, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  const io::ViewFrame both = io::compute_view_frame({scene_of(grid), scene_of(far)});
  CHECK((both.origin - Vec3(5.5, 1.5, 0)).norm() < 1e-15);
  ViewScene over = scene_of(grid);
  over.overlay = ViewOverlay{"", &far};
  CHECK(io::compute_view_frame({over}).origin == both.origin);
}

TEST_CASE("the frame of very large and very small coordinates is finite") {
  for (const double size : {1e150, 1e-150}) {
    const Mesh mesh({{-size, 0, 0}, {size, 0, 0}, {0, size, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
    const io::ViewFrame frame = io::compute_view_frame({scene_of(mesh)});
    CHECK(frame.origin.allFinite());
    CHECK(frame.scale > 0);
    CHECK(std::isfinite(frame.scale));
  }
}

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

}  // namespace gvd::test_scene_entry
