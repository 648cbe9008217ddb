#include <algorithm>
#include <cmath>

#include "constraints.hpp"
#include "crease_generators.hpp"
#include "gvd/error.hpp"
#include "gvd/lloyd.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_crease_generators {

/// A closed box with sides of length 1, 1 and `thickness`: 12 creases and 8 corners.
Mesh make_box(int n) { return test::make_plate(n, 0.5); }

std::vector<EdgeId> all_boundary(const Mesh& mesh) { return find_creases(mesh, {180, true}); }

TEST_CASE("creases: points near them are snapped to their vertices and edges, others stay") {
  const Mesh box = make_box(4);
  const std::vector<EdgeId> creases = find_creases(box, {30});
  const auto snap = [&](const SurfacePoint& p) { return snap_to_creases(box, creases, {p}, 1e-5).front(); };
  for (const EdgeId e : creases) {
    const HalfedgeId h = box.halfedge(e);
    const auto from = static_cast<std::size_t>(Mesh::corner(h)), to = (from + 1) % 3, beside = (from + 2) % 3;
    const auto point = [&](double near_from, double near_to) {
      SurfacePoint p{Mesh::face(h), {}};
      p.bary[from] = near_from, p.bary[to] = near_to, p.bary[beside] = 1 - near_from - near_to;
      return p;
    };
    CHECK(snap(point(1 - 2e-6, 1e-6)) == vertex_point(box, box.from(h)));  // beside the edge, next to its end
    CHECK(snap(edge_point(h, 1e-6)) == vertex_point(box, box.from(h)));
    const SurfacePoint middle = snap(point(0.5, 0.5 - 1e-6));
    CHECK(middle.kind() == SurfacePoint::Kind::edge);
    CHECK((position(box, middle) - position(box, edge_point(h, 0.5))).norm() < 1e-6);
    CHECK(snap(edge_point(h, 0.3)) == edge_point(h, 0.3));
    CHECK(snap(point(0.4, 0.4)) == point(0.4, 0.4));
    CHECK(snap(vertex_point(box, box.from(h))) == vertex_point(box, box.from(h)));
  }
  const SurfacePoint near = edge_point(box.halfedge(creases[0]), 1e-6);
  CHECK(snap_to_creases(box, {}, {near}, 1e-5).front() == near);
}

TEST_CASE("creases: corners are fixed, and generators between them evenly spaced") {
  const Mesh grid = test::make_grid(6, 3);
  const FeatureGenerators placed = place_on_creases(grid, all_boundary(grid), 1.5);
  // Four corners; four parts along each long side, two along each short one.
  REQUIRE(placed.points.size() == 4 + 2 * 3 + 2 * 1);
  CHECK(std::count(placed.freedom.begin(), placed.freedom.end(), Freedom::fixed) == 4);
  CHECK(
      std::is_partitioned(placed.freedom.begin(), placed.freedom.end(), [](Freedom f) { return f == Freedom::fixed; }));
  for (const SurfacePoint& p : placed.points) {
    const Vec3 at = position(grid, p);
    CHECK(std::fmod(at.x() + 1e-9, 1.5) < 1e-6);
    CHECK(std::fmod(at.y() + 1e-9, 1.5) < 1e-6);
  }
  CHECK_THROWS_AS(place_on_creases(grid, all_boundary(grid), 0), Error);
  const FeatureGenerators of_box = place_on_creases(make_box(4), find_creases(make_box(4), {30}), 10);
  CHECK(of_box.points.size() == 8);
}

TEST_CASE("creases: a closed one without a corner has at least three generators, each once") {
  const Mesh ring = test::make_ring(40, 3);
  const double round = 2 * std::acos(-1.0);
  for (const double spacing : {100.0, round / 8}) {
    const FeatureGenerators placed = place_on_creases(ring, all_boundary(ring), spacing);
    CHECK(placed.points.size() == (spacing > 10 ? 6 : 16));
    CHECK(std::count(placed.freedom.begin(), placed.freedom.end(), Freedom::on_crease) == std::ssize(placed.points));
  }
}

TEST_CASE("creases: turns near sharper ones, or near ends of creases, are no corners on demand") {
  const Mesh grid = test::make_grid(6, 1);
  const auto corners = [&](double distance) {
    const auto placed = place_on_creases(grid, all_boundary(grid), 100, distance);
    return std::count(placed.freedom.begin(), placed.freedom.end(), Freedom::fixed);
  };
  CHECK(corners(0) == 4);
  CHECK(corners(0.9) == 4);
  CHECK(corners(1.5) == 2);  // one at each end of the strip
  CHECK(trace_creases(grid, all_boundary(grid), 1.5).size() == 2);
  const Mesh box = make_box(4);  // corners of three creases stay
  CHECK(place_on_creases(box, find_creases(box, {30}), 100, 10).points.size() == 8);
}

TEST_CASE("creases: a path follows the crease by its length, over vertices, to the next corner") {
  const Mesh grid = test::make_grid(6, 3);
  const CreaseNetwork network(grid, all_boundary(grid));
  for (const SurfacePoint& start : place_on_creases(grid, all_boundary(grid), 0.7).points) {
    const Vec3 from = position(grid, start);
    for (const Vec2& wish : {Vec2(0.9, 0.4), Vec2(-0.9, 0.4), Vec2(0.1, -1.3), Vec2(-5, -1)}) {
      const Vec2 step = project_to_crease(grid, network, start, wish);
      CHECK(step.norm() <= wish.norm() + 1e-12);
      const GeodesicTrace trace = follow_crease(grid, network, start, step);
      const Vec3 to = position(grid, trace.points.back());
      CHECK((to - from).norm() == Approx(trace.length).margin(1e-12));
      CHECK(network.contains(trace.points.back()));
      CHECK(trace.complete == (trace.length >= step.norm()));
      if (!(trace.length > 0) || !trace.complete) continue;
      // Back the same way.
      const GeodesicTrace back = follow_crease(grid, network, trace.points.back(), -trace.length * trace.direction);
      CHECK((position(grid, back.points.back()) - from).norm() < 1e-9);
    }
  }
}

TEST_CASE("lloyd: fixed generators stay, and those on creases stay on them") {
  const Mesh box = make_box(6);
  LloydOptions options;
  options.creases = find_creases(box, {30});
  const FeatureGenerators placed = place_on_creases(box, options.creases, 0.4);
  auto start = placed.points;
  options.freedom = placed.freedom;
  for (const SurfacePoint& p : test::random_generators(box, 30, 3)) {
    if (p.kind() != SurfacePoint::Kind::face) continue;
    start.push_back(p);
    options.freedom.push_back(start.size() % 4 == 0 ? Freedom::fixed : Freedom::free);
  }
  for (const Acceleration acceleration : {Acceleration::none, Acceleration::lbfgs}) {
    options.acceleration = acceleration;
    const LloydResult result = relax_generators(box, start, options);
    CHECK(result.final_energy < result.initial_energy);
    const CreaseNetwork network(box, options.creases);
    for (std::size_t i = 0; i < start.size(); ++i) {
      if (options.freedom[i] == Freedom::fixed) CHECK(result.generators[i] == start[i]);
      if (options.freedom[i] == Freedom::on_crease) CHECK(network.contains(result.generators[i]));
    }
  }
}

TEST_CASE("lloyd: wrong numbers of freedoms, and generators beside their creases, are refused") {
  const Mesh grid = test::make_grid(4, 4);
  const auto start = test::random_generators(grid, 3, 1);
  LloydOptions options;
  options.freedom = {Freedom::free};
  CHECK_THROWS_AS(relax_generators(grid, start, options), Error);
  options.freedom = {Freedom::free, Freedom::free, Freedom::on_crease};
  CHECK_THROWS_AS(relax_generators(grid, start, options), Error);
}

}  // namespace gvd::test_crease_generators
