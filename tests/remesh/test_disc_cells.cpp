// Cells made discs: the given generators stay, the fewest that are known suffice, and no added one is in vain.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "gvd/disc_cells.hpp"
#include "gvd/error.hpp"
#include "gvd/sampling.hpp"
#include "gvd/segment.hpp"
#include "segment/plain_topology.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_disc_cells {

using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;

DiscCells make(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiscOptions& options = {}) {
  return make_discs(mesh, compute_diagram(mesh, generators, options.diagram), options);
}

/// Whether the given generators come first, all cells are discs, and none of the added ones can be left out.
void check_discs(const Mesh& mesh, const std::vector<SurfacePoint>& given, const DiscCells& made) {
  const std::vector<SurfacePoint>& generators = made.diagram.generators;
  REQUIRE(generators.size() == given.size() + std::size_t(made.added));
  CHECK(std::equal(given.begin(), given.end(), generators.begin()));
  CHECK(find_non_discs(made.diagram).empty());
  for (std::size_t i = given.size(); i < generators.size() && !made.search_cut_short; ++i) {
    std::vector<SurfacePoint> without = generators;
    without.erase(without.begin() + std::ptrdiff_t(i));
    CHECK(!find_non_discs(compute_diagram(mesh, without)).empty());
  }
}

TEST_CASE("disc cells: surfaces take the fewest generators that their topology allows") {
  const struct {
    const char* name;
    Mesh mesh;
    std::size_t fewest;
  } cases[] = {{"sphere", test::make_sphere(2), 2}, {"half sphere", test::make_half_sphere(2), 1},
               {"plate", test::make_plate(4), 2},   {"grid", test::make_grid(5, 4), 1},
               {"ring", test::make_ring(24, 3), 2}, {"pyramid", test::make_pyramid(30, 5), 2}};
  for (const auto& [name, mesh, fewest] : cases) {
    INFO(name);
    for (unsigned seed = 1; seed < 4; ++seed) {
      const auto given = test::random_generators(mesh, 1, seed);
      const DiscCells made = make(mesh, given);
      check_discs(mesh, given, made);
      CHECK(made.diagram.generators.size() == fewest);
    }
  }
}

TEST_CASE("disc cells: a torus takes at least three, and few more are found") {
  const Mesh mesh = test::make_torus(24, 12);
  for (unsigned seed = 1; seed < 5; ++seed) {
    const auto given = test::random_generators(mesh, 1, seed);
    const DiscCells made = make(mesh, given);
    check_discs(mesh, given, made);
    CHECK(made.diagram.generators.size() >= 3);
    CHECK(made.diagram.generators.size() <= 6);
  }
}

TEST_CASE("disc cells: on a long thin body, each cell that goes round it takes one generator") {
  // Edges are 100 times as long as the girth: a point of them is on the opposite side, but far along the body.
  const Mesh sphere = test::make_sphere(2);
  for (const double length : {100.0, 1000.0, 1e5}) {
    const Mesh needle = test::stretched(sphere, {length, 1, 1});
    for (const int count : {3, 6, 12}) {
      CAPTURE(length, count);
      SamplingOptions sampling;
      sampling.count = count;
      const auto given = sample_generators(needle, sampling);
      const std::size_t annuli = find_non_discs(compute_diagram(needle, given)).size();
      const DiscCells made = make(needle, given);
      check_discs(needle, given, made);
      CHECK(annuli > 0);
      CHECK(std::size_t(made.added) == annuli);
    }
  }
}

/// An open tube of radius 1 round half a circle of radius 100: `rings` rings of twelve vertices.
Mesh make_bent_tube(int rings) {
  constexpr int kSides = 12;
  std::vector<Vec3> positions;
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i < rings; ++i) {
    const double along = std::numbers::pi * i / (rings - 1);
    for (int k = 0; k < kSides; ++k) {
      const double round = 2 * std::numbers::pi * k / kSides, radius = 100 + std::cos(round);
      positions.emplace_back(radius * std::cos(along), radius * std::sin(along), std::sin(round));
      if (i == 0) continue;
      const int a = kSides * i + k, b = kSides * i + (k + 1) % kSides;
      faces.push_back({a - kSides, b - kSides, b});
      faces.push_back({a - kSides, b, a});
    }
  }
  return test::make_mesh(std::move(positions), faces);
}

TEST_CASE("disc cells: on a long thin limb that bends, rounds that are in vain let other candidates come first") {
  const Mesh tube = make_bent_tube(61);
  SamplingOptions sampling;
  for (const auto kind : {Sampling::farthest, Sampling::random}) {
    for (const int count : {1, 2, 5}) {
      CAPTURE(int(kind), count);
      sampling.kind = kind;
      sampling.count = count;
      const auto given = sample_generators(tube, sampling);
      const DiscCells made = make(tube, given);
      check_discs(tube, given, made);
      CHECK(made.added < 30);
    }
  }
}

TEST_CASE("disc cells: several given generators stay, and discs get no further ones") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    for (int count : {2, 9}) {
      const auto given = test::random_generators(mesh, count, 5);
      const DiscCells made = make(mesh, given);
      check_discs(mesh, given, made);
      const Diagram before = compute_diagram(mesh, given);
      CHECK((made.added == 0) == find_non_discs(before).empty());
      CHECK((made.rounds == 0) == (made.added == 0));
    }
  }
}

TEST_CASE("disc cells: a surface of genus 3 becomes discs with one generator a handle and few more") {
  const Mesh mesh = test::make_genus3(4);
  const auto given = test::random_generators(mesh, 1, 2);
  const DiscCells made = make(mesh, given);
  check_discs(mesh, given, made);
  CHECK(made.added <= 9);
}

/// A closed surface round the bars of a lattice of `cells`^3 cubes: unit squares, each two faces. Bars are a square
/// wide.
Mesh make_lattice(int cells) {
  const int size = 2 * cells + 1;
  const auto is_solid = [&](const std::array<int, 3>& at) {
    const auto is_inside = [&](int i) { return i >= 0 && i < size; };
    return std::ranges::all_of(at, is_inside) && std::ranges::count_if(at, [](int i) { return i % 2 == 0; }) >= 2;
  };
  std::map<std::array<int, 3>, int> number;
  std::vector<std::array<int, 3>> faces;
  std::vector<Vec3> positions;
  const auto corner = [&](const std::array<int, 3>& at) {
    const auto [found, is_new] = number.emplace(at, int(positions.size()));
    if (is_new) positions.emplace_back(at[0], at[1], at[2]);
    return found->second;
  };
  const auto add_side = [&](std::array<int, 3> at, std::size_t axis, bool is_upper) {
    at[axis] += is_upper;
    std::array<int, 4> square{};
    for (std::size_t i = 0; i < 4; ++i) {
      auto place = at;
      place[(axis + (is_upper ? 1 : 2)) % 3] += i == 1 || i == 2;
      place[(axis + (is_upper ? 2 : 1)) % 3] += i >= 2;
      square[i] = corner(place);
    }
    faces.push_back({square[0], square[1], square[2]});
    faces.push_back({square[0], square[2], square[3]});
  };
  for (int i = 0; i < size * size * size; ++i) {
    const std::array<int, 3> at{i % size, i / size % size, i / size / size};
    if (!is_solid(at)) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool is_upper : {false, true}) {
        auto beside = at;
        beside[axis] += is_upper ? 1 : -1;
        if (!is_solid(beside)) add_side(at, axis, is_upper);
      }
    }
  }
  return test::make_mesh(positions, faces);
}

TEST_CASE("disc cells: a lattice of bars as wide as its faces becomes discs from few generators") {
  const Mesh lattice = make_lattice(3);
  SamplingOptions sampling;
  sampling.count = 5;
  const auto given = sample_generators(lattice, sampling);
  const DiscCells made = make(lattice, given);
  check_discs(lattice, given, made);
  CHECK(made.added < 110);  // the surface has 81 handles
  CHECK(made.rounds < 40);
}

TEST_CASE("disc cells: the pieces of the cut mesh are discs") {
  const Mesh mesh = test::make_torus(24, 12);
  const DiscCells made = make(mesh, test::random_generators(mesh, 1, 1));
  const CutMesh cut = cut_faces(mesh, made.diagram);
  for (const auto& [label, region] : test::find_topology(cut.mesh, cut.label)) {
    CHECK(region.components == 1);
    CHECK(region.euler_characteristic == 1);
  }
  for (const Cell& cell : made.diagram.cells) CHECK(cell.boundary_loops == 1);
}

TEST_CASE("disc cells: no bit depends on the number of threads") {
  const Mesh mesh = test::make_genus3(4);
  const auto given = test::random_generators(mesh, 2, 3);
  DiscOptions one, three;
  one.diagram.threads = 1;
  three.diagram.threads = 3;
  CHECK(test::same_diagram(make(mesh, given, one).diagram, make(mesh, given, three).diagram));
}

TEST_CASE("disc cells: refusals name the cell, or the option") {
  const Mesh mesh = test::make_torus(24, 12);
  const auto given = test::random_generators(mesh, 1, 1);
  DiscOptions few;
  few.max_added = 1;
  try {
    make(mesh, given, few);
    FAIL("one more generator can't make discs of a torus");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::no_valid_result);
    CHECK(error.element() >= 0);
    CHECK_THAT(error.what(),
               Contains("is no disc") && Contains(": 1 generator was added in 1 round, and 1 such cell became ") &&
                   EndsWith("give so many generators that they are closer to each other than the way round the surface "
                            "there, or raise max_added"));
  }
  few.max_added = -1;
  CHECK_THROWS_AS(make(mesh, given, few), Error);
  DiscOptions weighted;
  weighted.diagram.weights = {1.0};
  CHECK_THROWS_AS(make(mesh, given, weighted), Error);
}

}  // namespace gvd::test_disc_cells
