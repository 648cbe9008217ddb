// The edges of a remesh along creases and boundaries.

#include <algorithm>

#include "creases/crease_gaps.hpp"
#include "creases/follow_creases.hpp"
#include "gvd/remesh.hpp"
#include "remesh/creases/crease_meshes.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"

namespace gvd::test_follow_creases {

std::vector<CreaseCurve> curves_of(const Mesh& mesh) { return trace_creases(mesh, find_creases(mesh, {40, true})); }

/// Every chain of a crease is a chain of edges, and its corners are vertices.
void require_followed(const Mesh& mesh, const std::vector<CreaseCurve>& curves, const RemeshResult& result) {
  for (const CreaseCurve& curve : curves) {
    const std::vector<std::size_t> along = test::generators_along(mesh, curve, result.generators);
    const bool is_loop = curve.vertices.front() == curve.vertices.back();
    REQUIRE(along.size() >= (is_loop ? 3u : 2u));
    for (std::size_t k = 1; k < along.size(); ++k) CHECK(test::are_joined(result.mesh, along[k - 1], along[k]));
    if (curve.closed) CHECK(test::are_joined(result.mesh, along.front(), along.back()));
    if (curve.closed) continue;
    CHECK(position(mesh, result.generators[along.front()]) == mesh.position(curve.vertices.front()));
    CHECK(position(mesh, result.generators[along.back()]) == mesh.position(curve.vertices.back()));
  }
}

RemeshResult follow(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  RemeshOptions options;
  options.creases = curves_of(mesh);
  return remesh(mesh, generators, options);
}

TEST_CASE("creases: a cube with eight generators is a cube") {
  const Mesh cube = test::make_cube(5);
  const auto creases = find_creases(cube, {40});
  const RemeshResult result = follow(cube, place_on_creases(cube, creases, 10).points);
  CHECK(result.added == 0);
  CHECK(result.mesh.vertex_count() == 8);
  CHECK(result.mesh.face_count() == 12);
  CHECK(result.crease_length == Approx(12));
  CHECK(result.crease_gap_length == 0);
  CHECK(result.input_to_output.hausdorff < 1e-9);
}

TEST_CASE("creases: edges follow them, whatever generators are given") {
  for (const auto& [name, mesh] : test::creased_meshes()) {
    const std::vector<CreaseCurve> curves = curves_of(mesh);
    REQUIRE_FALSE(curves.empty());
    for (const int count : {4, 20}) {
      INFO(name << ", " << count << " generators");
      const RemeshResult result = follow(mesh, test::random_generators(mesh, count, 1));
      CHECK(result.crease_gap_length == 0);
      CHECK(result.added_on_creases <= count + 100);
      require_followed(mesh, curves, result);
    }
  }
}

TEST_CASE("creases: without them, edges do not follow") {
  const Mesh cube = test::make_cube(4);
  const RemeshResult result = remesh(cube, test::random_generators(cube, 20, 1));
  CHECK(result.added_on_creases == 0);
  CHECK(result.crease_length == 0);
  const auto curves = curves_of(cube);
  CHECK_FALSE(CreaseGaps(cube, curves, result.diagram, 100).find().empty());
}

TEST_CASE("creases: no more generators are added than allowed, and what is left is measured") {
  const Mesh cube = test::make_cube(4);
  RemeshOptions options;
  options.creases = curves_of(cube);
  options.max_added = 3;
  const RemeshResult few = remesh(cube, test::random_generators(cube, 40, 1), options);
  CHECK(few.added == 3);
  CHECK(few.crease_gap_length > 0);
  CHECK(few.crease_gap_length < few.crease_length);
  options.refine = false;
  CHECK(remesh(cube, test::random_generators(cube, 40, 1), options).added == 0);
}

TEST_CASE("creases: no more generators are proposed than repairs have left") {
  const Mesh cube = test::make_cube(4);
  const std::vector<CreaseCurve> curves = curves_of(cube);
  std::vector<SurfacePoint> generators = test::random_generators(cube, 40, 1);
  CreaseFollower follower(cube, curves, 7, 100);
  for (const auto& [may_add, expected] : {std::pair{2, 2u}, {0, 0u}, {100, 5u}, {100, 0u}}) {
    const auto points = follower.propose(compute_diagram(cube, generators), may_add);
    CHECK(points.size() == expected);
    generators.insert(generators.end(), points.begin(), points.end());
  }
  CHECK(follower.added() == 7);
}

TEST_CASE("creases: a generator too near to a corner does not keep others from the rest of the creases") {
  const Mesh cube = test::make_cube(4);
  const std::vector<CreaseCurve> curves = curves_of(cube);
  std::vector<SurfacePoint> generators = place_on_creases(cube, find_creases(cube, {40}), 0.3).points;
  const SurfacePoint corner = generators.front();
  REQUIRE(corner.kind() == SurfacePoint::Kind::vertex);
  for (double& b : generators.front().bary) b = b == 1 ? 1 - 2e-7 : 1e-7;
  for (const SurfacePoint& p : test::random_generators(cube, 200, 1)) {
    if (p.kind() == SurfacePoint::Kind::face) generators.push_back(p);
  }
  CreaseFollower follower(cube, curves, 1000, 100);
  std::size_t at_curves_of_corner = 0;
  while (true) {
    const auto points = follower.propose(compute_diagram(cube, generators), 1000);
    if (points.empty()) break;
    for (const SurfacePoint& p : points) {
      const Vec3 way = (position(cube, p) - position(cube, corner)).cwiseAbs();
      CHECK(way.norm() > 1e-3);
      at_curves_of_corner += way.sum() < way.maxCoeff() + 1e-9;
    }
    generators.insert(generators.end(), points.begin(), points.end());
  }
  CHECK(at_curves_of_corner > 0);
  CHECK(follower.gap_length() == Approx(1));  // beside the corner, a third of each of its three curves
}

TEST_CASE("creases: two that leave a corner at an acute angle take few generators") {
  const Mesh sector = test::make_sector(3, 0.2);
  std::vector<SurfacePoint> generators = test::random_generators(sector, 6, 3);
  const RemeshResult result = follow(sector, generators);
  CHECK(result.crease_gap_length == 0);
  CHECK(result.rounds <= 8);
  CHECK(result.mesh.vertex_count() <= 40);
}

}  // namespace gvd::test_follow_creases
