// The search for fewer generators: what it leaves is right, and nothing in it is needless.
#include <algorithm>

#include "gvd/dual.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "remesh/dual_defects.hpp"
#include "repair/repair_steps.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_fewer_generators {

bool is_right(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return test::find_dual_defects(mesh, compute_diagram(mesh, generators)).empty();
}

/// Whether it is right, and no triangle is flipped.
bool is_right_and_unfolded(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  const Diagram diagram = compute_diagram(mesh, generators);
  return test::find_dual_defects(mesh, diagram).empty() &&
         find_flipped_triangles(mesh, diagram, build_dual(mesh, diagram)).empty();
}

/// Adds generators until the dual has no defect.
std::vector<SurfacePoint> repair(const Mesh& mesh, std::vector<SurfacePoint> generators) {
  for (int round = 0; round < 30; ++round) {
    const Diagram diagram = compute_diagram(mesh, generators);
    const auto defects = test::find_dual_defects(mesh, diagram);
    if (defects.empty()) break;
    const auto added = propose_generators(mesh, diagram, defects, 100).points;
    generators.insert(generators.end(), added.begin(), added.end());
  }
  REQUIRE(is_right(mesh, generators));
  return generators;
}

std::vector<SurfacePoint> search(const Mesh& mesh, const std::vector<SurfacePoint>& generators, std::size_t given) {
  Diagram diagram = compute_diagram(mesh, generators);
  search_fewer_generators(mesh, diagram, given, {}, [&](const std::vector<SurfacePoint>& tried) {
    Diagram after = compute_diagram(mesh, tried);
    if (!test::find_dual_defects(mesh, after).empty()) return false;
    diagram = std::move(after);
    return true;
  });
  return diagram.generators;
}

bool has(const std::vector<SurfacePoint>& points, const SurfacePoint& p) {
  return std::find(points.begin(), points.end(), p) != points.end();
}

TEST_CASE("fewer generators: those that no defect asks for go, the given ones stay") {
  const Mesh mesh = test::make_sphere(3);
  const auto given = test::random_generators(mesh, 40, 1);
  REQUIRE(is_right(mesh, given));
  auto generators = given;
  const auto needless = test::random_generators(mesh, 6, 2);
  generators.insert(generators.end(), needless.begin(), needless.end());
  REQUIRE(is_right(mesh, generators));
  CHECK(search(mesh, generators, given.size()) == given);
}

TEST_CASE("fewer generators: on every mesh right, no more than before, and none of them needless") {
  std::size_t before = 0, after = 0, replaced = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    for (const unsigned seed : test::thinned({1u, 2u})) {
      INFO(name << ", seed " << seed);
      const auto given = test::random_generators(mesh, 6, seed);
      const auto repaired = repair(mesh, given);
      const auto fewer = search(mesh, repaired, given.size());
      CHECK(is_right(mesh, fewer));
      CHECK(fewer.size() <= repaired.size());
      CHECK(std::equal(given.begin(), given.end(), fewer.begin()));
      CHECK(search(mesh, repaired, given.size()) == fewer);
      before += repaired.size() - given.size();
      after += fewer.size() - given.size();
      for (std::size_t i = given.size(); i < fewer.size(); ++i) {
        auto without = fewer;
        without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
        CHECK_FALSE(is_right_and_unfolded(mesh, without));
        replaced += has(repaired, fewer[i]) ? 0 : 1;
      }
    }
  }
  CHECK(after < before);
  CHECK(replaced > 0);
}

TEST_CASE("remesh: where many generators are added, none of them is needless") {
  int added = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto given = test::random_generators(mesh, 8, 3);
    const RemeshResult result = remesh(mesh, given);
    for (std::size_t i = given.size(); i < result.generators.size(); ++i) {
      auto without = result.generators;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      RemeshOptions options;
      options.refine = false;
      CHECK_THROWS_AS(remesh(mesh, without, options), Error);
      ++added;
    }
  }
  CHECK(added > 0);
}

}  // namespace gvd::test_fewer_generators
