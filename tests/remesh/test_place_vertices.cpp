// Whole placements: features are met, fixed vertices stay, and the result depends on no thread.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "crease_meshes.hpp"
#include "dual/placed_faces.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/quality.hpp"
#include "gvd/remesh.hpp"
#include "gvd/sampling.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_place_vertices {

RemeshResult remesh_at_generators(const Mesh& mesh, int count) {
  RemeshOptions options;
  options.placement.method = Placement::generator;
  return remesh(mesh, test::random_generators(mesh, count, 1), options);
}

std::vector<Vec3> place(const Mesh& mesh, const RemeshResult& result, const PlacementOptions& options) {
  return place_vertices(mesh, result.diagram, result.mesh, result.face_points, options).positions;
}

TEST_CASE("the rim of a plate is met: the distances fall by more than on smooth surfaces") {
  const Mesh mesh = test::make_plate(12, 0.2);
  const RemeshResult before = remesh_at_generators(mesh, 120);
  for (const Placement method : {Placement::quadric, Placement::fit}) {
    PlacementOptions options;
    options.method = method;
    const RemeshResult after = [&] {
      RemeshOptions all;
      all.placement = options;
      return remesh(mesh, before.generators, all);
    }();
    CHECK(after.input_to_output.rms < 0.6 * before.input_to_output.rms);
    CHECK(after.mesh.positions() == place(mesh, before, options));
  }
}

TEST_CASE("the fit brings the mesh nearer and its triangles do not get worse") {
  const Mesh mesh = test::make_bumpy_sphere(4, 1);
  const RemeshResult before = remesh_at_generators(mesh, 150);
  RemeshOptions fit;
  fit.placement.method = Placement::fit;
  const RemeshResult after = remesh(mesh, before.generators, fit);
  CHECK(after.input_to_output.rms < 0.6 * before.input_to_output.rms);
  const TriangleQuality was = compute_triangle_quality(before.mesh), is = compute_triangle_quality(after.mesh);
  CHECK(is.q_average > was.q_average);
  CHECK(is.angle_min >= 0.999 * std::min(was.angle_min, PlacementOptions().least_angle));
}

RemeshResult fit_samples(const Mesh& mesh, int count, unsigned seed, double shape) {
  SamplingOptions sampling;
  sampling.kind = Sampling::poisson;  // inside faces, so that no generator is on a crease
  sampling.count = count;
  sampling.seed = seed;
  RemeshOptions options;
  options.placement.shape = shape;
  return remesh(mesh, sample_generators(mesh, sampling), options);
}

TEST_CASE("triangles at creases stay good: no angle falls below 20 degrees, and hardly one below 30") {
  double faces = 0, thinned = 0;
  for (const unsigned seed : test::thinned({0U, 1U, 2U})) {
    for (const Mesh& mesh : {test::make_plate(12, 0.2), test::make_can(48, 1.5)}) {
      const RemeshResult result = fit_samples(mesh, 200, seed, PlacementOptions().shape);
      const PlacedFaces fitted(result.mesh);
      std::vector<Vec3> start;
      for (const SurfacePoint& p : result.generators) start.push_back(position(mesh, p));
      for (const FaceId f : result.mesh.faces()) {
        const auto [a, b, c] = fitted.corners(f);
        const auto [p, q, r] = PlacedFaces(result.mesh, start).corners(f);
        const double was = compute_min_angle(p, q, r), is = compute_min_angle(a, b, c);
        CHECK(is >= std::min(20.0, 0.999 * was));
        ++faces;
        thinned += is < 30 && was >= 30;
      }
      CHECK(result.certificate.flipped_faces == 0);
      CHECK(find_self_intersections(result.mesh).empty());
    }
  }
  CHECK(thinned / faces <= 0.005);
}

TEST_CASE("the shape leads from small distances to good triangles") {
  for (const Mesh& mesh : {test::make_plate(12, 0.2), test::make_bumpy_sphere(4, 1)}) {
    double rms = 0, quality = 0;
    for (const double shape : {0.0, 0.5, 1.0}) {
      CAPTURE(shape);
      const RemeshResult result = fit_samples(mesh, 150, 1, shape);
      CHECK(std::max(result.input_to_output.rms, result.output_to_input.rms) > rms);
      CHECK(result.output_quality.q_average > quality);
      rms = std::max(result.input_to_output.rms, result.output_to_input.rms);
      quality = result.output_quality.q_average;
      CHECK(result.certificate.flipped_faces == 0);
      CHECK(find_self_intersections(result.mesh).empty());
    }
  }
}

TEST_CASE("fixed vertices stay at their generators") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const RemeshResult before = remesh_at_generators(mesh, 40);
  PlacementOptions options;
  options.fixed = {GeneratorId(0), GeneratorId(7)};
  const std::vector<Vec3> placed = place(mesh, before, options);
  int moved = 0;
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const bool stays = placed[i] == before.mesh.positions()[i];
    if (i == 0 || i == 7) CHECK(stays);
    moved += !stays;
  }
  CHECK(moved > 30);
}

TEST_CASE("placements do not depend on the number of threads") {
  const Mesh mesh = test::make_bumpy_sphere(3, 1);
  const RemeshResult before = remesh_at_generators(mesh, 60);
  PlacementOptions one, many;
  one.threads = 1;
  many.threads = 3;
  CHECK(place(mesh, before, one) == place(mesh, before, many));
}

TEST_CASE("a remesh of another diagram is refused") {
  const Mesh mesh = test::make_sphere(2);
  const RemeshResult a = remesh_at_generators(mesh, 10), b = remesh_at_generators(mesh, 12);
  CHECK_THROWS_AS(place_vertices(mesh, a.diagram, b.mesh, b.face_points), Error);
}

TEST_CASE("shapes and angles out of range, and fixed generators that there are not are refused") {
  const Mesh mesh = test::make_sphere(2);
  const RemeshResult result = remesh_at_generators(mesh, 12);
  const auto is_refused = [&](const PlacementOptions& options) {
    try {
      place(mesh, result, options);
    } catch (const Error& error) {
      return error.code() == ErrorCode::invalid_option;
    }
    return false;
  };
  for (const double angle : {-1.0, 60.1, std::nan("")}) {
    CAPTURE(angle);
    PlacementOptions smooth, crease;
    smooth.least_angle = crease.least_crease_angle = angle;
    CHECK(is_refused(smooth));
    CHECK(is_refused(crease));
  }
  for (const double shape : {-0.1, 1.1, std::nan("")}) {
    PlacementOptions options;
    options.shape = shape;
    CHECK(is_refused(options));
  }
  for (const GeneratorId g : {GeneratorId(), GeneratorId(std::ssize(result.generators))}) {
    PlacementOptions options;
    options.fixed = {g};
    CHECK(is_refused(options));
  }
  PlacementOptions steep;
  steep.least_angle = 61;
  RemeshOptions options;
  options.placement = steep;
  CHECK_THROWS_AS(remesh(mesh, result.generators, options), Error);
}

TEST_CASE("a cube with a generator at each corner stays a cube") {
  const Mesh cube = test::make_plate(4, 1);
  Eigen::AlignedBox3d box;
  for (const Vec3& p : cube.positions()) box.extend(p);
  std::vector<SurfacePoint> corners;
  for (std::int32_t v = 0; v < cube.vertex_count(); ++v) {
    const Vec3 at = (cube.position(VertexId(v)) - box.center()).cwiseQuotient(box.sizes());
    if (at.cwiseAbs().minCoeff() > 0.49) corners.push_back(vertex_point(cube, VertexId(v)));
  }
  REQUIRE(corners.size() == 8);
  const RemeshResult result = remesh(cube, corners, {});
  CHECK(result.input_to_output.hausdorff < 1e-6);
  CHECK(result.output_to_input.hausdorff < 1e-6);
}

TEST_CASE("vertices of cells at the boundary go to it") {
  const Mesh grid = test::make_grid(12, 12);
  const RemeshResult before = remesh_at_generators(grid, 60);
  const RemeshResult after = remesh(grid, before.generators, {});
  CHECK(compute_area(after.mesh) > compute_area(before.mesh));
  CHECK(after.input_to_output.rms < 0.5 * before.input_to_output.rms);
}

}  // namespace gvd::test_place_vertices
