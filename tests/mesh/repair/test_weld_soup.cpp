#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "gvd/read_soup.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/meshes.hpp"

namespace gvd::test_weld_soup {

using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

// Each face with vertices of its own, as in an STL.
PolygonSoup make_loose(const Mesh& mesh) {
  PolygonSoup soup;
  for (const FaceId f : mesh.faces()) {
    for (const VertexId v : mesh.vertices(f)) {
      soup.corners.push_back(static_cast<std::int32_t>(soup.positions.size()));
      soup.positions.push_back(mesh.position(v));
    }
    soup.close_polygon();
  }
  return soup;
}

// Two triangles of a unit square whose copies of the diagonal are `gap` apart.
PolygonSoup make_parted_square(double gap) {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, gap}, {1, 1, gap}, {0, 1, gap}};
  for (const std::int32_t v : {0, 1, 2, 3, 4, 5}) soup.corners.push_back(v);
  soup.first_corner = {0, 3, 6};
  return soup;
}

// Points as vertices of one polygon: vertices that no polygon has are not welded.
PolygonSoup make_polygon(const std::vector<Vec3>& points) {
  PolygonSoup soup;
  soup.positions = points;
  for (const Vec3& p : points) soup.corners.push_back(static_cast<std::int32_t>(&p - points.data()));
  soup.close_polygon();
  return soup;
}

CheckedMesh weld(PolygonSoup soup, double tolerance = 0, DefectPolicy policy = DefectPolicy::repair) {
  weld_soup(soup, tolerance);
  return build_mesh(soup, policy);
}

TEST_CASE("welding loose faces gives the mesh back, with or without a tolerance") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const MeshSummary before = compute_mesh_summary(mesh);
    double shortest = std::numeric_limits<double>::infinity();
    for (const EdgeId e : mesh.edges()) shortest = std::min(shortest, mesh.length(e));
    for (const double tolerance : {0.0, 1e-9 * shortest}) {
      const MeshSummary after = compute_mesh_summary(weld(make_loose(mesh), tolerance).mesh);
      CHECK(after.vertices == before.vertices);
      CHECK(after.faces == before.faces);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
      CHECK(after.area == Approx(before.area));
    }
  }
}

TEST_CASE("what was asked for is no defect: DefectPolicy::error accepts welded vertices") {
  const CheckedMesh checked = weld(make_parted_square(0), 0, DefectPolicy::error);
  CHECK(checked.mesh.vertex_count() == 4);
  CHECK(checked.defects.count(DefectKind::unwelded_vertices) == 2);
  CHECK(checked.defects.messages ==
        std::vector<std::string>{"2 vertices are welded to others at the same coordinates, first vertex 3"});
  CHECK(checked.mesh_vertex[3] == checked.mesh_vertex[0]);
  CHECK(checked.mesh_vertex[4] == checked.mesh_vertex[2]);
}

TEST_CASE("without welding, a note counts the open edges that it would close") {
  const CheckedMesh checked = build_mesh(make_parted_square(0));
  CHECK(checked.defects.coincident_vertices == 2);
  CHECK(checked.defects.closable_edges == 2);
  CHECK(checked.defects.messages ==
        std::vector<std::string>{"2 boundary vertices are at the position of another one: not joined, the surface is "
                                 "open there; \1weld\2 would close 2 open edges"});
}

TEST_CASE("a tolerance joins pairs up to it, and no others") {
  CHECK(weld(make_parted_square(0.25), 0.25).mesh.vertex_count() == 4);
  CHECK(weld(make_parted_square(0.25), 0.2499).mesh.vertex_count() == 6);
  CHECK(weld(make_parted_square(0.25)).mesh.vertex_count() == 6);
}

TEST_CASE("only vertices of faces join: none moves to an unused one, and copies that no face has are not counted") {
  PolygonSoup soup = make_parted_square(0.25);
  // Unused vertices before the others: near vertex 0, and at the place of vertex 2.
  soup.positions.insert(soup.positions.begin(), {{0, 0, -0.125}, {1, 1, 0}});
  for (std::int32_t& v : soup.corners) v += 2;
  for (const double tolerance : {0.0, 0.2, 0.25}) {
    CAPTURE(tolerance);
    const CheckedMesh checked = weld(soup, tolerance);
    const std::int64_t joined = tolerance == 0.25 ? 2 : 0;
    CHECK(checked.mesh.vertex_count() == 6 - joined);
    CHECK(checked.defects.count(DefectKind::unwelded_vertices) == joined);
    CHECK(checked.defects.count(DefectKind::unused_vertices) == 2);
    CHECK(!checked.mesh_vertex[0].valid());
    CHECK(!checked.mesh_vertex[1].valid());
    CHECK(checked.mesh.position(checked.mesh_vertex[2]) == Vec3(0, 0, 0));
    CHECK(checked.mesh.position(checked.mesh_vertex[4]) == Vec3(1, 1, 0));
  }
}

TEST_CASE(
    "of a chain some stay, faces that collapse are dropped, and the note tells of a tolerance above the spacing") {
  PolygonSoup strip;
  for (int i = 0; i < 5; ++i) strip.positions.emplace_back(0.125 * i, 0, 0);
  strip.positions.insert(strip.positions.end(), {{0, 1, 0}, {0.25, 1, 0}});
  for (const std::int32_t v : {0, 1, 5, 1, 2, 5, 2, 3, 6, 3, 4, 6, 2, 6, 5}) strip.corners.push_back(v);
  strip.first_corner = {0, 3, 6, 9, 12, 15};
  const CheckedMesh checked = weld(strip, 0.15);
  // 0, 2 and 4 stay; 1 and 3 are as near to one as to the other, and move to the one before.
  CHECK(checked.mesh_vertex[1] == checked.mesh_vertex[0]);
  CHECK(checked.mesh_vertex[3] == checked.mesh_vertex[2]);
  CHECK(checked.mesh.vertex_count() == 5);
  CHECK(checked.mesh.face_count() == 3);
  CHECK(checked.defects.count(DefectKind::degenerate_faces) == 2);
  CHECK(checked.defects.messages.front() ==
        "welding within 0.15: 2 vertices had several others within the tolerance, and were joined only to the nearest. "
        "Choose a smaller tolerance to join copies only");
}

// The rule of weld_soup, with all pairs compared.
std::vector<Vec3> weld_by_brute_force(const std::vector<Vec3>& positions, double tolerance) {
  const auto distance = [&](std::size_t a, std::size_t b) { return (positions[a] - positions[b]).squaredNorm(); };
  std::vector<std::size_t> staying;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto is_near = [&](std::size_t w) { return distance(v, w) <= tolerance * tolerance; };
    if (std::none_of(staying.begin(), staying.end(), is_near)) staying.push_back(v);
  }
  std::vector<Vec3> moved;
  for (std::size_t v = 0; v < positions.size(); ++v) {
    const auto is_nearer = [&](std::size_t a, std::size_t b) { return distance(v, a) < distance(v, b); };
    moved.push_back(positions[*std::min_element(staying.begin(), staying.end(), is_nearer)]);
  }
  return moved;
}

// Welds, compares with brute force, and checks what the header promises.
void check_rule(const std::vector<Vec3>& before, double tolerance) {
  PolygonSoup soup = make_polygon(before);
  weld_soup(soup, tolerance);
  REQUIRE(soup.positions == weld_by_brute_force(before, tolerance));
  for (std::size_t v = 0; v < before.size(); ++v) {
    REQUIRE((soup.positions[v] - before[v]).norm() <= tolerance * (1 + 1e-15));
    for (std::size_t w = 0; w < v; ++w) {
      const bool are_apart = (soup.positions[v] - soup.positions[w]).squaredNorm() > tolerance * tolerance;
      REQUIRE((are_apart || soup.positions[v] == soup.positions[w]));
    }
  }
  const std::vector<Vec3> once = soup.positions;
  weld_soup(soup, tolerance);
  REQUIRE(soup.positions == once);
}

double random_number(std::mt19937& random, double low, double high) {
  return low + (high - low) * 0x1p-32 * double(random());
}

Vec3 random_vector(std::mt19937& random, double half) {
  const auto coordinate = [&] { return random_number(random, -half, half); };
  const double x = coordinate(), y = coordinate();
  return {x, y, coordinate()};
}

TEST_CASE("welding is what its rule says for random points, at any size and place, and twice is once") {
  std::mt19937 random(5);
  for (int round = 0; round < 60; ++round) {
    const double size = std::pow(10.0, random_number(random, -60, 60));
    const Vec3 place = round % 2 == 0 ? Vec3(0, 0, 0) : Vec3(random_vector(random, 3 * size));
    std::vector<Vec3> points;
    for (int v = 0; v < 80; ++v) {
      Vec3 p = place + random_vector(random, size);
      if (round % 3 == 0) p.z() = place.z();
      points.push_back(p);
      if (v % 4 == 0) points.push_back(p);
      if (v % 5 == 0) points.push_back(p + random_vector(random, 0.01 * size));
    }
    check_rule(points, size * std::pow(10.0, random_number(random, -4, 0)));
  }
}

TEST_CASE("welding is what its rule says on lattices, where many distances equal the tolerance") {
  std::vector<Vec3> lattice;
  for (int i = 0; i < 343; ++i) lattice.emplace_back(i % 7 - 3, i / 7 % 7 - 3, i / 49 - 3);
  for (const double tolerance : {0.5, 1.0, std::sqrt(2.0), 2.0, 4.0}) check_rule(lattice, tolerance);
}

TEST_CASE("welding is what its rule says where the tolerance is near the rounding of coordinates, and far below it") {
  const double unit = std::numeric_limits<double>::epsilon();
  std::vector<Vec3> points{{1e75, 0, 0}, {0, -1e75, 0}};
  for (int i = 0; i < 60; ++i) {
    const int layer = i / 20;
    points.emplace_back(1 - unit * (i % 20), -2 + unit * (i % 7), unit * layer);
  }
  for (const double tolerance : {0.25 * unit, 0.5 * unit, unit, 3 * unit, 1e-30, 1e-100}) check_rule(points, tolerance);
}

TEST_CASE("copies nearer than the tolerance, and farther from all others, become one in any order") {
  std::mt19937 random(9);
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    double shortest = std::numeric_limits<double>::infinity();
    for (const EdgeId e : mesh.edges()) shortest = std::min(shortest, mesh.length(e));
    if (!(shortest > 0)) continue;
    const MeshSummary before = compute_mesh_summary(mesh);
    PolygonSoup loose = make_loose(mesh);
    const double tolerance = 1e-3 * shortest;
    for (Vec3& p : loose.positions) p += random_vector(random, 0.25 * tolerance);  // copies are .87 tolerances apart
    PolygonSoup reversed = loose;  // the same polygons, and the vertices in the opposite order
    std::reverse(reversed.positions.begin(), reversed.positions.end());
    for (std::int32_t& v : reversed.corners) v = std::int32_t(reversed.positions.size()) - 1 - v;
    for (const PolygonSoup& soup : {loose, reversed}) {
      const CheckedMesh checked = weld(soup, tolerance);
      const MeshSummary after = compute_mesh_summary(checked.mesh);
      CHECK(after.vertices == before.vertices);
      CHECK(after.faces == before.faces);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.boundary_loops == before.boundary_loops);
    }
  }
}

TEST_CASE("many copies in few places, and a tolerance of most of the mesh, take no time that grows with the pairs") {
  // 200,000 vertices in two places would be 10^10 pairs: all pairs within one place, or all between the two.
  std::vector<Vec3> before;
  for (int v = 0; v < 200000; ++v) before.emplace_back(v % 2, 1e-9 * (v % 1000), 0);
  PolygonSoup soup = make_polygon(before);
  weld_soup(soup, 0.99);
  for (int v = 0; v < 200000; ++v) REQUIRE(soup.positions[v] == before[v % 2]);
  soup.positions = before;
  weld_soup(soup, 1e-6);
  for (int v = 0; v < 200000; ++v) REQUIRE(soup.positions[v] == before[v % 2]);
}

TEST_CASE("welding that joins nothing says so, and how near vertices on open edges are") {
  const auto messages = [](const PolygonSoup& soup, double tolerance) {
    return weld(soup, tolerance).defects.messages;
  };
  using Messages = std::vector<std::string>;
  const std::string gap = "; on open edges, the nearest two that no edge joins are 0.25 apart";
  CHECK(messages(make_parted_square(0.25), 0.1) ==
        Messages{"welding within 0.1 joins nothing: no two vertices are that close" + gap});
  CHECK(messages(make_parted_square(0.25), 0) ==
        Messages{"welding joins nothing: no two vertices are at the same coordinates" + gap});
  CHECK_THAT(messages(make_parted_square(0.25), 0.25).front(), Contains("2 vertices are welded to others within 0.25"));
  CHECK(messages(parse_soup(test::kOff, MeshFormat::off, "a.off"), 0.1) ==
        Messages{"welding within 0.1 joins nothing: no two vertices are that close, and no edge is open"});
}

/// The number in the note that welding within the tolerance joins nothing.
double told_gap(const PolygonSoup& soup, double tolerance) {
  const std::string note = weld(soup, tolerance).defects.messages.back();
  const std::string before = "that no edge joins are ";
  REQUIRE_THAT(note, Contains(before) && EndsWith(" apart"));
  return std::stod(note.substr(note.find(before) + before.size()));
}

TEST_CASE("the nearest vertices on open edges are those of all pairs that no edge joins") {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    PolygonSoup soup;
    const auto number = [&] { return 1e-3 * double(random() % 10000); };
    for (int v = 0; v < 90; ++v) {
      soup.positions.emplace_back(number(), number(), number());
      soup.corners.push_back(v);
      if (v % 3 == 2) soup.close_polygon();
    }
    double least = std::numeric_limits<double>::infinity();
    for (int v = 0; v < 90; ++v) {
      for (int w = 0; w < v; ++w) {
        if (v / 3 != w / 3) least = std::min(least, (soup.positions[v] - soup.positions[w]).norm());
      }
    }
    const double told = told_gap(soup, 0.5 * least);
    CHECK(told >= least);
    CHECK(told <= least + 1e-5 * least);  // a step of the sixth digit
  }
}

TEST_CASE("the number that a note tells of the nearest vertices joins them") {
  // Distances between decimals and just above them, whose sixth digit would be rounded down.
  for (const double gap : {0.25, 0.1234564, 0.1234566, 1e-3 + 1e-12, 9.9999996e-3, 1.0 / 3, 2.0 / 3, 7.0e-9}) {
    CAPTURE(gap);
    const PolygonSoup soup = make_parted_square(gap);
    const double told = told_gap(soup, 0.5 * gap);
    CHECK(told >= gap);
    CHECK(told <= gap + 1e-5 * gap);
    CHECK(weld(soup, told).defects.count(DefectKind::unwelded_vertices) == 2);
  }
}

TEST_CASE("the nearest vertices on open edges are not told where finding them takes long") {
  // Triangles in one plane, on which the direction of the sweep is perpendicular.
  PolygonSoup soup;
  const Vec3 right = Vec3(1.618, -1, 0).normalized(), up = Vec3(1, 1.618, 2.618).cross(right).normalized();
  for (int i = 0; i < 20; ++i) {
    for (int j = 0; j < 20; ++j) {
      for (const auto& [x, y] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1)}) {
        soup.corners.push_back(static_cast<std::int32_t>(soup.positions.size()));
        soup.positions.push_back((3 * i + x) * right + (3 * j + y) * up);
      }
      soup.close_polygon();
    }
  }
  CHECK_THAT(weld(soup, 0.1).defects.messages.back(), EndsWith("no two vertices are that close"));
}

TEST_CASE("welding keeps the texture coordinates of corners") {
  PolygonSoup soup = make_parted_square(0);
  for (int corner = 0; corner < 6; ++corner) soup.appearance.texture.push_back({0.1 * corner, 0.5});
  const CheckedMesh checked = weld(soup);
  CHECK(checked.mesh.vertex_count() == 4);
  CHECK(checked.appearance.texture == soup.appearance.texture);
}

TEST_CASE("a tolerance that is no number from 0 on, or joins all vertices, is refused") {
  PolygonSoup soup = make_parted_square(0.1);
  for (const double wrong : {-1.0, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    CHECK_THROWS_WITH(weld_soup(soup, wrong), Contains("is not a finite number from 0 on"));
  }
  CHECK_THROWS_WITH(weld_soup(soup, 1e-101), "weld: the tolerance 1e-101 is below 1e-100; 0 joins exact copies");
  for (const double all : {5.0, 1.45, std::numeric_limits<double>::max()}) {
    CHECK_THROWS_WITH(weld_soup(soup, all),
                      fmt::format("welding within {:g} joins all vertices: choose a smaller tolerance", all));
  }
  // All are near the first vertex, and not near each other.
  PolygonSoup middle = make_polygon({{0, 0, 0}, {1, 0, 0}, {-1, 0, 0}});
  CHECK_THROWS_WITH(weld_soup(middle, 1), "welding within 1 joins all vertices: choose a smaller tolerance");
}

}  // namespace gvd::test_weld_soup
