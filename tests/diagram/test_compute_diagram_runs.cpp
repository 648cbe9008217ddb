// Properties of whole runs: scaling, repetition, progress and cancelling.
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/same_diagram.hpp"
#include "support/sound_diagram.hpp"
#include "support/stages.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_compute_diagram_runs {

using test::compute_sound;
using test::kFronts;

/// Requires that the callback of `options` cancels the run.
void require_cancelled(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const DiagramOptions& options) {
  try {
    compute_diagram(mesh, generators, options);
    FAIL("was not cancelled");
  } catch (const Error& error) {
    REQUIRE(error.code() == ErrorCode::interrupted);
  }
}

/// Requires the same diagram at 2^-exponent and at 2^exponent times the size, up to the last digits of its length:
/// powers of two scale every number exactly.
void check_scaled(const Mesh& mesh, Method method, int exponent, double epsilon) {
  DiagramOptions options;
  options.method = method;
  const auto generators = test::random_generators(mesh, 20, 17);
  const Diagram diagram = compute_diagram(mesh, generators, options);
  for (const double scale : {std::ldexp(1.0, -exponent), std::ldexp(1.0, exponent)}) {
    INFO("scale " << scale);
    const Mesh scaled = test::scaled(mesh, scale);
    const Diagram other = compute_diagram(scaled, generators, options);
    CHECK(check_diagram(scaled, other).ok());
    CHECK(test::same_topology(diagram, other));
    CHECK(other.length / scale == Approx(diagram.length).epsilon(epsilon));
  }
}

TEST_CASE("two runs give equal diagrams, in every field") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const Front front : kFronts) {
      INFO(name << ", " << test::name(front));
      const auto generators = test::random_generators(mesh, 40, 19);
      const Diagram first = compute_sound(mesh, generators, front),
                    second = compute_sound(Mesh(mesh), generators, front);
      REQUIRE(test::same_diagram(first, second));
      REQUIRE(test::same_topology(first, second));
    }
  }
}

TEST_CASE("very small and very large coordinates give the same diagram") {
  for (const auto& [name, mesh] : test::small_family()) {
    const auto generators = test::random_generators(mesh, 20, 17);
    const Diagram diagram = compute_sound(mesh, generators);
    INFO(name);
    check_scaled(mesh, Method::gbgvd, 40, 1e-12);
    // Other factors round. Rounding may exchange face events with equal keys, and so change what the domination test
    // keeps of a generator beyond its cell. The nearest distances stay, and bisectors move a little (measured: 0.1 % in
    // length).
    for (const double scale : {1e-12, 1e-6, 1e6, 1e12}) {
      INFO(name << ", scale " << scale);
      const Diagram other = compute_sound(test::scaled(mesh, scale), generators);
      CHECK(other.branch_points.size() == diagram.branch_points.size());
      CHECK(other.bisectors.size() == diagram.bisectors.size());
      CHECK(other.length / scale == Approx(diagram.length).epsilon(0.005));
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        const double distance = diagram.vertex_distance[VertexId(v)],
                     scaled = other.vertex_distance[VertexId(v)] / scale;
        if (std::isfinite(distance)) REQUIRE(scaled == Approx(distance).margin(1e-9 * mesh.bbox_diagonal()));
        REQUIRE(std::isfinite(distance) == std::isfinite(scaled));
      }
    }
  }
}

TEST_CASE("exact diagrams keep their figures far beyond the range of floats") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    check_scaled(mesh, Method::exact, 200, 1e-9);
  }
}

TEST_CASE("progress begins with the working mesh and ends with the cells, and every step can cancel") {
  const Mesh mesh = test::make_sphere(3);
  const auto generators = test::random_generators(mesh, 30, 4);
  std::vector<std::string> steps;
  DiagramOptions options;
  options.progress = [&](std::string_view step, double fraction) {
    REQUIRE((fraction >= 0 && fraction <= 1));
    if (steps.empty() || steps.back() != step) steps.emplace_back(step);
    return true;
  };
  compute_diagram(mesh, generators, options);
  CHECK(steps.front() == "working mesh");
  CHECK(std::count(steps.begin(), steps.end(), "distances") == 1);
  CHECK(std::count(steps.begin(), steps.end(), "bisectors") >= 1);
  CHECK(steps.back() == "cells");
  for (std::size_t stop = 0; stop < steps.size(); ++stop) {
    std::size_t changes = 0;
    std::string current;
    options.progress = [&](std::string_view step, double) {
      if (step != current) current = step, ++changes;
      return changes <= stop;
    };
    INFO("at step " << stop);
    require_cancelled(mesh, generators, options);
  }
}

TEST_CASE("every long step of an exact diagram can be cancelled while it runs") {
  const Mesh mesh = test::make_sphere(5);
  const auto generators = test::random_generators(mesh, 300, 4);
  for (const std::string step : {"distances", "bisectors", "faces"}) {
    INFO(step);
    DiagramOptions options;
    options.threads = 1;  // with more, the others may do all of a step before the calling thread reports
    // The first call of a step has fraction 0; after the faces are closed, "bisectors" is at 0.5.
    options.progress = [&](std::string_view current, double fraction) {
      return current != step || fraction == 0 || fraction == 0.5;
    };
    require_cancelled(mesh, generators, options);
  }
}

TEST_CASE("every method reports the beginning of its distances once, and can be cancelled within each step") {
  const Mesh mesh = test::make_sphere(5);
  const auto generators = test::random_generators(mesh, 300, 4);
  const std::vector<std::pair<Method, std::vector<std::string>>> expected{
      {Method::exact, {"working mesh", "distances", "bisectors", "faces"}},
      {Method::gbgvd, {"working mesh", "bisectors", "growth"}},
      {{Solver::windows, Tracer::growth}, {"working mesh", "distances", "tables", "bisectors", "growth"}},
      {{Solver::fast_marching, Tracer::envelope}, {"working mesh", "bisectors"}}};
  for (const auto& [method, steps] : expected) {
    DiagramOptions options;
    options.method = method;
    options.front = Front::planar;
    int beginnings = 0;
    std::map<std::string, int, std::less<>> within;
    options.progress = [&](std::string_view step, double fraction) {
      beginnings += step == "distances" && fraction == 0;
      within[std::string(step)] += fraction > 0;
      return true;
    };
    compute_diagram(mesh, generators, options);
    CHECK(beginnings == 1);
    for (const std::string& step : steps) {
      INFO(step);
      CHECK(within[step] > 0);
      options.progress = [&](std::string_view current, double fraction) { return current != step || fraction == 0; };
      require_cancelled(mesh, generators, options);
    }
  }
}

TEST_CASE("the comparison of diagrams can tell them apart") {
  const Mesh mesh = test::make_sphere(2);
  const Diagram diagram = compute_sound(mesh, test::at_vertices(mesh, {0, 3, 40})),
                other = compute_sound(mesh, test::at_vertices(mesh, {0, 3, 41}));
  CHECK_FALSE(test::same_diagram(diagram, other));
  Diagram moved = diagram;
  moved.vertex_distance[VertexId(5)] = std::nextafter(moved.vertex_distance[VertexId(5)], 10.0);
  CHECK_FALSE(test::same_diagram(diagram, moved));
  CHECK(test::same_topology(diagram, moved));
}

}  // namespace gvd::test_compute_diagram_runs
