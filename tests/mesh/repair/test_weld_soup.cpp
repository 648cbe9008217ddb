#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <random>

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
                                 "open there; welding would close 2 open edges"});
}

TEST_CASE("a tolerance joins pairs up to it, and no others") {
  CHECK(weld(make_parted_square(0.25), 0.25).mesh.vertex_count() == 4);
  CHECK(weld(make_parted_square(0.25), 0.2499).mesh.vertex_count() == 6);
  CHECK(weld(make_parted_square(0.25)).mesh.vertex_count() == 6);
}

TEST_CASE("faces that collapse are dropped and counted, and a chain is told") {
  PolygonSoup strip;
  for (int i = 0; i < 5; ++i) strip.positions.emplace_back(0.1 * i, 0, 0);
  strip.positions.insert(strip.positions.end(), {{0, 1, 0}, {0.2, 1, 0}});
  for (const std::int32_t v : {0, 1, 5, 1, 2, 5, 2, 3, 6, 3, 4, 6, 2, 6, 5}) strip.corners.push_back(v);
  strip.first_corner = {0, 3, 6, 9, 12, 15};
  const CheckedMesh checked = weld(strip, 0.15);
  CHECK(checked.mesh.face_count() == 1);
  CHECK(checked.defects.count(DefectKind::degenerate_faces) == 4);
  CHECK_THAT(
      checked.defects.messages.front(),
      Contains("welding within 0.15 joins chains of vertices, and moves 3 vertices farther than that, by up to"));
}

TEST_CASE("welding within a tolerance joins exactly the chains of pairs, in any order, and twice is once") {
  std::mt19937 random(5);
  for (int round = 0; round < 50; ++round) {
    PolygonSoup soup;
    for (int v = 0; v < 60; ++v) {
      soup.positions.emplace_back(0.01 * double(random() % 400) - 2, 0.01 * double(random() % 400) - 2,
                                  0.01 * double(random() % 100));
    }
    const double tolerance = 0.4;
    const std::vector<Vec3> before = soup.positions;
    weld_soup(soup, tolerance);
    std::vector<std::int32_t> least(60);
    for (std::int32_t v = 0; v < 60; ++v) least[v] = v;
    for (bool changed = true; changed;) {
      changed = false;
      for (std::int32_t v = 0; v < 60; ++v) {
        for (std::int32_t w = 0; w < 60; ++w) {
          if ((before[v] - before[w]).stableNorm() > tolerance || least[v] >= least[w]) continue;
          least[w] = least[v];
          changed = true;
        }
      }
    }
    for (std::int32_t v = 0; v < 60; ++v) REQUIRE(soup.positions[v] == before[least[v]]);
    const std::vector<Vec3> once = soup.positions;
    weld_soup(soup, tolerance);
    REQUIRE(soup.positions == once);
  }
}

TEST_CASE("welding that joins nothing says so, and how near vertices on open edges are") {
  const auto messages = [](const PolygonSoup& soup, double tolerance) {
    return weld(soup, tolerance).defects.messages;
  };
  using Messages = std::vector<std::string>;
  const std::string gap = "; on open edges, the nearest two that no edge joins are 0.25 apart";
  CHECK(messages(make_parted_square(0.25), 0.1) ==
        Messages{"welding within 0.1 joins nothing: no two vertices are so near" + gap});
  CHECK(messages(make_parted_square(0.25), 0) ==
        Messages{"welding joins nothing: no two vertices are at the same coordinates" + gap});
  CHECK_THAT(messages(make_parted_square(0.25), 0.25).front(), Contains("2 vertices are welded to others within 0.25"));
  CHECK(messages(parse_soup(test::kOff, MeshFormat::off, "a.off"), 0.1) ==
        Messages{"welding within 0.1 joins nothing: no two vertices are so near, and no edge is open"});
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
    CHECK_THAT(weld(soup, 0.5 * least).defects.messages.back(), Contains(fmt::format("are {:.6g} apart", least)));
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
  CHECK_THAT(weld(soup, 0.1).defects.messages.back(), EndsWith("no two vertices are so near"));
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
  CHECK_THROWS_WITH(weld_soup(soup, 5), "welding within 5 joins all vertices: choose a smaller tolerance");
}

}  // namespace gvd::test_weld_soup
