// The search for fewer generators: what it leaves is right, and nothing in it is needless.
#include <algorithm>
#include <limits>

#include "gvd/dual.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "remesh/dual_defects.hpp"
#include "repair/fewer_generators.hpp"
#include "repair/propose_generators.hpp"
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

constexpr auto kNoLimit = std::numeric_limits<std::int64_t>::max();

/// A search that accepts what is right, and makes `diagram` that of what it accepts.
GeneratorSearch make_search(const Mesh& mesh, Diagram& diagram, std::size_t kept, std::size_t least = 0,
                            std::int64_t most_events = kNoLimit) {
  GeneratorSearch search;
  search.kept = kept;
  search.most_events = most_events;
  search.least = least;
  search.accept = [&mesh, &diagram](const std::vector<SurfacePoint>& tried) {
    Diagram after = compute_diagram(mesh, tried);
    if (!test::find_dual_defects(mesh, after).empty()) return false;
    diagram = std::move(after);
    return true;
  };
  return search;
}

std::vector<SurfacePoint> search(const Mesh& mesh, const std::vector<SurfacePoint>& generators, std::size_t given) {
  Diagram diagram = compute_diagram(mesh, generators);
  CHECK(search_fewer_generators(mesh, diagram, make_search(mesh, diagram, given)));
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

TEST_CASE("fewer generators: changes apart from each other are decided on together") {
  const Mesh mesh = test::make_sphere(4);
  auto generators = test::random_generators(mesh, 150, 1);
  const std::size_t given = generators.size();
  const auto needless = test::random_generators(mesh, 12, 2);
  generators.insert(generators.end(), needless.begin(), needless.end());
  Diagram diagram = compute_diagram(mesh, generators);
  REQUIRE(test::find_dual_defects(mesh, diagram).empty());
  GeneratorSearch counting = make_search(mesh, diagram, given);
  int decided = 0;
  counting.accept = [&decided, accept = counting.accept](const std::vector<SurfacePoint>& tried) {
    ++decided;
    return accept(tried);
  };
  CHECK(search_fewer_generators(mesh, diagram, counting));
  CHECK(diagram.generators.size() == given);
  CHECK(decided <= 6);
}

TEST_CASE("fewer generators: the search ends at its limit, says so, and what it leaves is right") {
  const Mesh mesh = test::make_sphere(3);
  auto generators = test::random_generators(mesh, 40, 1);
  const auto needless = test::random_generators(mesh, 20, 2);
  generators.insert(generators.end(), needless.begin(), needless.end());
  const Diagram first = compute_diagram(mesh, generators);
  for (const std::int64_t diagrams : {0, 1, 3}) {
    CAPTURE(diagrams);
    Diagram diagram = first;
    const std::int64_t most = diagrams * first.report.propagation_events;
    CHECK_FALSE(search_fewer_generators(mesh, diagram, make_search(mesh, diagram, 40, 0, most)));
    CHECK(is_right(mesh, diagram.generators));
    CHECK(diagram.generators.size() > 40);
  }
}

TEST_CASE("exchange: exactly so many are left, the first ones stay, and the dual is right") {
  int meshes = 0, successes = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto repaired = repair(mesh, test::random_generators(mesh, 40, 1));
    const std::size_t kept = 5, count = repaired.size() - 4;
    Diagram diagram = compute_diagram(mesh, repaired);
    const bool found = exchange_generators(mesh, diagram, make_search(mesh, diagram, kept, count));
    ++meshes;
    successes += found ? 1 : 0;
    CHECK((found ? diagram.generators.size() == count : diagram.generators.size() > count));
    CHECK(is_right(mesh, diagram.generators));
    CHECK(std::equal(repaired.begin(), repaired.begin() + kept, diagram.generators.begin()));
  }
  CHECK(10 * successes >= 9 * meshes);
}

TEST_CASE("exchange: fixed generators stay, wherever they are in the list") {
  const Mesh mesh = test::make_sphere(3);
  const auto generators = test::random_generators(mesh, 40, 1);
  REQUIRE(is_right(mesh, generators));
  Diagram diagram = compute_diagram(mesh, generators);
  GeneratorSearch fixing = make_search(mesh, diagram, 2, 20);
  for (std::size_t i = 5; i < generators.size(); i += 4) fixing.fixed.push_back(generators[i]);
  CHECK(exchange_generators(mesh, diagram, fixing));
  CHECK(std::equal(generators.begin(), generators.begin() + 2, diagram.generators.begin()));
  CHECK(find_in_order(fixing.fixed, diagram.generators).size() == fixing.fixed.size());
}

TEST_CASE("remesh: the vertices of fixed generators stay at them where others are left out") {
  int left_out = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto given = test::random_generators(mesh, 24, 3);
    RemeshOptions options;
    options.vertex_count = std::ssize(given);
    for (const std::size_t i : {23u, 22u, 17u, 11u, 5u}) options.placement.fixed.emplace_back(i);
    try {
      const RemeshResult result = remesh(mesh, given, options);
      left_out += result.left_out > 0 ? 1 : 0;
      for (const GeneratorId g : options.placement.fixed) {
        const auto at = std::find(result.generators.begin(), result.generators.end(), given[g.index()]);
        REQUIRE(at != result.generators.end());
        const VertexId v(at - result.generators.begin());
        CHECK(result.mesh.position(v) == position(mesh, given[g.index()]));
      }
    } catch (const Error& error) {
      CHECK(error.code() == ErrorCode::no_valid_result);
    }
  }
  CHECK(left_out > 0);
}

TEST_CASE("fewer generators: the search ends with so many as are wanted") {
  const Mesh mesh = test::make_sphere(3);
  auto generators = test::random_generators(mesh, 40, 1);
  const auto needless = test::random_generators(mesh, 20, 2);
  generators.insert(generators.end(), needless.begin(), needless.end());
  for (const std::size_t least : {57u, 58u, 59u}) {
    Diagram diagram = compute_diagram(mesh, generators);
    CHECK(search_fewer_generators(mesh, diagram, make_search(mesh, diagram, 40, least)));
    CHECK(diagram.generators.size() == least);
  }
}

TEST_CASE("exchange: no torus has three vertices") {
  const Mesh mesh = test::make_torus(24, 12);
  Diagram diagram = compute_diagram(mesh, repair(mesh, test::random_generators(mesh, 9, 1)));
  CHECK_FALSE(exchange_generators(mesh, diagram, make_search(mesh, diagram, 0, 3)));
  CHECK(diagram.generators.size() >= 7);
}

TEST_CASE("exchange: what lies on flat parts goes before what a bend needs") {
  const Mesh mesh = test::make_plate(12);
  std::vector<SurfacePoint> generators;
  for (const VertexId v : mesh.vertices()) generators.push_back(vertex_point(mesh, v));
  Diagram diagram = compute_diagram(mesh, generators);
  REQUIRE(test::find_dual_defects(mesh, diagram).empty());
  const std::size_t count = generators.size() - 10;
  CHECK(exchange_generators(mesh, diagram, make_search(mesh, diagram, 0, count)));
  const auto on_rim = [&](const std::vector<SurfacePoint>& points) {
    return std::count_if(points.begin(), points.end(), [&](const SurfacePoint& p) {
      const Vec3 at = position(mesh, p);
      return at.x() < 1e-9 || at.y() < 1e-9 || at.x() > 1 - 1e-9 || at.y() > 1 - 1e-9;
    });
  };
  CHECK(on_rim(diagram.generators) == on_rim(generators));
}

TEST_CASE("remesh: where many generators are added, none of them is needless") {
  int added = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto given = test::random_generators(mesh, 8, 3);
    RemeshOptions patient;
    patient.earlier_diagrams = 10000;  // the search may take a third of these
    const RemeshResult result = remesh(mesh, given, patient);
    CHECK_FALSE(result.search_cut_short);
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
