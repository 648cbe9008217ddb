// Bodies of cubes: they touch in edges and vertices, and enclose a volume that is known.
#include <algorithm>
#include <array>
#include <random>

#include "mesh/reading/soup_files.hpp"

namespace gvd::test_cut_apart {

// Unit cubes in a block of 3 x 3 x 3.
struct Cubes {
  std::array<bool, 27> full{};

  static std::size_t index(int x, int y, int z) { return static_cast<std::size_t>((x * 3 + y) * 3 + z); }
  bool at(const std::array<int, 3>& p) const {
    for (const int x : p) {
      if (x < 0 || x > 2) return false;
    }
    return full[index(p[0], p[1], p[2])];
  }
};

// The quadrilateral between the cube `at` and the empty cell beside it.
std::array<std::int32_t, 4> cube_side(const std::array<int, 3>& at, std::size_t axis, bool up) {
  const auto corner = [&](int u, int v) {
    std::array<int, 3> p = at;
    p[axis] += up;
    p[(axis + 1) % 3] += u;
    p[(axis + 2) % 3] += v;
    return p[0] * 16 + p[1] * 4 + p[2];
  };
  if (up) return {corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
  return {corner(0, 0), corner(0, 1), corner(1, 1), corner(1, 0)};
}

// The surface of the cubes, with a vertex at each corner that cubes share: not manifold where they touch.
PolygonSoup surface_of(const Cubes& cubes) {
  PolygonSoup soup;
  for (int v = 0; v < 64; ++v) soup.positions.emplace_back(v / 16, v / 4 % 4, v % 4);
  for (int i = 0; i < 27; ++i) {
    const std::array<int, 3> at = {i / 9, i / 3 % 3, i % 3};
    for (int side = 0; side < 6 && cubes.at(at); ++side) {
      const auto axis = static_cast<std::size_t>(side / 2);
      const bool up = side % 2 != 0;
      std::array<int, 3> beside = at;
      beside[axis] += up ? 1 : -1;
      if (cubes.at(beside)) continue;
      const auto quad = cube_side(at, axis, up);
      soup.corners.insert(soup.corners.end(), quad.begin(), quad.end());
      soup.first_corner.push_back(soup.corners.size());
    }
  }
  return soup;
}

double volume(const Mesh& mesh) {
  double sum = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    sum += mesh.position(a).dot(mesh.position(b).cross(mesh.position(c))) / 6;
  }
  return sum;
}

// After the cut the cubes enclose the same volume.
CheckedMesh require_closed(const Cubes& cubes) {
  const PolygonSoup soup = surface_of(cubes);
  CheckedMesh checked = build_mesh(soup);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  REQUIRE(summary.boundary_loops == 0);
  REQUIRE(summary.area == Approx(static_cast<double>(soup.polygon_count())));
  REQUIRE(checked.defects.count(DefectKind::inconsistent_orientation) == 0);
  REQUIRE(volume(checked.mesh) == Approx(static_cast<double>(std::count(cubes.full.begin(), cubes.full.end(), true))));
  return checked;
}

TEST_CASE("a body that touches itself along one edge stays closed and gets a vertex on it") {
  // Two cubes that touch in an edge, joined round its lower and its upper end by three cubes each.
  Cubes cubes;
  for (const auto& [x, y, z] : std::vector<std::array<int, 3>>{
           {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {1, 1, 1}, {0, 0, 2}, {1, 0, 2}, {1, 1, 2}}) {
    cubes.full[Cubes::index(x, y, z)] = true;
  }
  const CheckedMesh checked = require_closed(cubes);
  CHECK(checked.defects.count(DefectKind::nonmanifold_edges) == 1);
  CHECK(checked.defects.split_edges == 1);
  CHECK(checked.input_vertex.raw().back() == -1);
  CHECK(checked.mesh.positions().back() == Vec3(1, 1, 1.5));
  CHECK_THAT(checked.defects.messages.back(),
             Catch::Matchers::Contains("1 edge along which the surface touches itself"));
}

TEST_CASE("random solids of cubes that touch in edges and vertices stay closed") {
  std::mt19937 random(5);
  std::int64_t cut_edges = 0, cut_vertices = 0;
  for (int round = 0; round < 300; ++round) {
    Cubes cubes;
    for (bool& full : cubes.full) full = random() % 3 == 0;
    cubes.full[0] = true;
    INFO("round " << round);
    const CheckedMesh checked = require_closed(cubes);
    cut_edges += checked.defects.count(DefectKind::nonmanifold_edges);
    cut_vertices += checked.defects.count(DefectKind::nonmanifold_vertices);
  }
  CHECK(cut_edges > 100);
  CHECK(cut_vertices > 50);
}

}  // namespace gvd::test_cut_apart
