// Creases at the scale of a sampling: one chain for each that a person would draw, and none where there is none.
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "gvd/creases.hpp"
#include "gvd/error.hpp"
#include "mesh/creases.hpp"
#include "support/catch.hpp"
#include "support/featured_meshes.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_crease_chains {

/// An open strip over a curve in the plane of x and z, `length` long along y: its points at y = 0, 1 / `per_unit`, ...
Mesh make_profile(
    const std::vector<std::array<double, 2>>& curve, double length, int per_unit,
    const std::function<double(double)>& height_at = [](double) { return 1.0; }) {
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  const int rows = static_cast<int>(length * per_unit), columns = static_cast<int>(curve.size());
  for (int row = 0; row <= rows; ++row) {
    const double y = double(row) / per_unit;
    for (const auto& [x, z] : curve) positions.emplace_back(x, y, z * height_at(y));
  }
  for (int row = 0; row < rows; ++row) {
    for (int i = 0; i + 1 < columns; ++i) {
      const int a = row * columns + i, b = a + columns;
      faces.insert(faces.end(), {{a, a + 1, b + 1}, {a, b + 1, b}});
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

/// Two legs at a right angle, joined by a part of a circle with this radius and number of sides.
std::vector<std::array<double, 2>> rounded_corner(double radius, int sides, double leg = 1) {
  std::vector<std::array<double, 2>> curve;
  for (int i = 0; i < 10; ++i) curve.push_back({0, -leg - radius + leg * i / 10});
  for (int i = 0; i <= sides; ++i) {
    const double angle = std::numbers::pi / 2 * i / sides;
    curve.push_back({radius - radius * std::cos(angle), -radius + radius * std::sin(angle)});
  }
  for (int i = 1; i <= 10; ++i) curve.push_back({radius + leg * i / 10, 0});
  return curve;
}

std::vector<EdgeId> chains_of(const Mesh& mesh, double spacing, double angle = 40) {
  return find_crease_chains(mesh, angle, spacing).edges;
}

TEST_CASE(
    "crease chains: at sharp edges they are what the faces say, and crisp, at any scale that they are longer than") {
  for (const Mesh& mesh : {test::make_plate(4, 0.5), test::make_plate(6, 0.05), test::make_genus3(2)}) {
    const std::vector<EdgeId> sharp = find_creases(mesh, {40});
    for (const double spacing : {0.02, 0.1, 0.2}) {
      CAPTURE(mesh.face_count(), spacing);
      const CreaseChains chains = find_crease_chains(mesh, 40, spacing);
      CHECK(chains.edges == sharp);
      REQUIRE(chains.crispness.size() == sharp.size());
      const double sum = std::accumulate(chains.crispness.begin(), chains.crispness.end(), 0.0);
      CHECK(sum > 0.95 * static_cast<double>(sharp.size()));  // but where a third face is near
    }
  }
}

TEST_CASE("crease chains: curved surfaces have none at a scale at which they are smooth") {
  for (const double spacing : {0.05, 0.2, 0.5}) {
    CAPTURE(spacing);
    CHECK(chains_of(test::make_sphere(3), spacing).empty());
    CHECK(chains_of(test::make_torus(48, 24), spacing).empty());
    CHECK(chains_of(test::make_ring(24, 3), spacing).empty());
  }
}

TEST_CASE("crease chains: folds of slivers along an edge have no voice, and it is one chain") {
  const Mesh box = test::make_plate(6, 0.5), folded = test::fold_creases(box, 0.01);
  const double length = total_length(box, find_creases(box, {40}));
  const std::vector<EdgeId> sharp = find_creases(folded, {40});
  CHECK(total_length(folded, sharp) > 1.9 * length);  // each edge, and the way round its sliver
  for (const double spacing : {0.1, 0.2, 0.3}) {
    CAPTURE(spacing);
    const std::vector<EdgeId> chains = chains_of(folded, spacing);
    CHECK(total_length(folded, chains) == Approx(length).epsilon(0.005));
    CHECK(trace_creases(folded, chains, spacing / 2).size() == 12);
  }
}

TEST_CASE("crease chains: a rounded edge is one chain where it is narrow, and none where its curve can be sampled") {
  const Mesh rounded = make_profile(rounded_corner(0.1, 6), 2, 20);
  CHECK(find_creases(rounded, {40}).empty());  // 15 degrees at each edge
  const CreaseChains chains = find_crease_chains(rounded, 40, 0.5);
  const std::vector<CreaseCurve> curves = trace_creases(rounded, chains.edges);
  REQUIRE(curves.size() == 1);
  CHECK(total_length(rounded, chains.edges) == Approx(2).epsilon(0.05));
  for (const VertexId v : curves[0].vertices) {
    const Vec3& p = rounded.position(v);
    CHECK(p.x() + p.z() + 0 == Approx(0).margin(0.06));  // near the middle of the curve
    CHECK(p.x() < 0.1);
    CHECK(p.z() > -0.1);
  }
  CHECK(*std::ranges::max_element(chains.crispness) < 0.9);
  CHECK(chains_of(rounded, 0.05).empty());
}

TEST_CASE("crease chains: the two edges of a bevel are one where it is narrow, and two where it is wide") {
  const Mesh bevelled = make_profile(rounded_corner(0.1, 1), 2, 10);
  CHECK(trace_creases(bevelled, chains_of(bevelled, 0.4)).size() == 1);
  CHECK(trace_creases(bevelled, chains_of(bevelled, 0.1)).size() == 2);
}

TEST_CASE("crease chains: one goes on to half of its angle, and ends on smooth ground") {
  // A roof whose slope falls along its ridge: the angle of the ridge is 2 atan(slope).
  const auto slope = [](double y) { return 0.6 * (1 - y / 10); };
  std::vector<std::array<double, 2>> roof;
  for (int i = -8; i <= 8; ++i) roof.push_back({i / 4.0, -std::abs(i / 4.0)});
  const Mesh mesh = make_profile(roof, 10, 4, slope);
  const auto end_at = [&](double angle) { return 10 * (1 - std::tan(angle / 2 * std::numbers::pi / 180) / 0.6); };
  const std::vector<CreaseCurve> curves = trace_creases(mesh, chains_of(mesh, 0.5));
  REQUIRE(curves.size() == 1);
  const auto y = [&](VertexId v) { return mesh.position(v).y(); };
  const double first = y(curves[0].vertices.front()), last = y(curves[0].vertices.back());
  CHECK(std::min(first, last) == 0);
  CHECK(std::max(first, last) == Approx(end_at(20)).margin(0.5));
  CHECK(total_length(mesh, find_creases(mesh, {40})) == Approx(end_at(40)).margin(0.5));
}

TEST_CASE("crease chains: what is shorter than the spacing is none") {
  std::vector<Vec3> positions = test::make_grid(40, 40).positions();
  const Mesh grid = test::make_grid(40, 40);
  for (Vec3& p : positions) {
    if (p.x() == 20 && std::abs(p.y() - 20) <= 2) p.z() = 1;  // a short ridge
  }
  const Mesh ridge(std::move(positions), grid.face_vertices());
  CHECK_FALSE(find_creases(ridge, {40}).empty());
  CHECK_FALSE(chains_of(ridge, 2).empty());
  CHECK(chains_of(ridge, 15).empty());
}

TEST_CASE("crease chains: a surface open at its creases has ends at the boundary, which are no branches to cut") {
  const Mesh corner = make_profile({{0, -1}, {0, 0}, {1, 0}}, 3, 2);
  CHECK(total_length(corner, chains_of(corner, 1)) == Approx(3));
}

TEST_CASE("crease chains: numbers out of their range are refused, and 180 degrees are no crease") {
  const Mesh box = test::make_plate(2, 1);
  CHECK_THROWS_WITH(find_crease_chains(box, 0, 1), "the angle of creases must be above 0 and at most 180 degrees");
  CHECK_THROWS_AS(find_crease_chains(box, 181, 1), Error);
  CHECK_THROWS_WITH(find_crease_chains(box, 40, 0), "the spacing of samples must be above 0");
  CHECK(chains_of(box, 0.3, 180).empty());
}

}  // namespace gvd::test_crease_chains
