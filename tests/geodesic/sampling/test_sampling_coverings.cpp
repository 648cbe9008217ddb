// Coverings with a given radius (property 4 of gvd/sampling.hpp).
#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/samples.hpp"

namespace gvd::test_sampling_coverings {

using test::all_distinct;
using test::cover;
using test::edge_distances;
using test::error_of;
using test::kInfinity;

TEST_CASE("property 4: a covering on the plane, by brute force") {
  for (const double radius : {0.4, 1.3, 3.0, 20.0}) {
    const Mesh grid = test::make_grid(8, 6);
    const auto generators = cover(grid, radius);
    double farthest = 0;
    for (double x = 0; x <= 8; x += 0.05) {
      for (double y = 0; y <= 6; y += 0.05) {
        double nearest = kInfinity;
        for (const SurfacePoint& g : generators)
          nearest = std::min(nearest, (position(grid, g) - Vec3(x, y, 0)).norm());
        farthest = std::max(farthest, nearest);
      }
    }
    INFO(radius << ": " << generators.size());
    CHECK(farthest <= radius * 1.001);
    // Farthest points are a packing as well: half the radius' discs hardly overlap.
    CHECK(static_cast<double>(generators.size()) <= (8 + radius) * (6 + radius) / (0.5 * radius * radius) + 1);
  }
}

TEST_CASE("property 4: a covering on the sphere, by its great circles") {
  const Mesh sphere = test::make_sphere(4);
  for (const double radius : {0.15, 0.5, 1.2, 4.0}) {
    const auto generators = cover(sphere, radius);
    double farthest = 0;
    for (int v = 0; v < sphere.vertex_count(); ++v) {
      double nearest = kInfinity;
      for (const SurfacePoint& g : generators) {
        const Vec3 p = position(sphere, g).normalized();
        nearest = std::min(
            nearest, std::atan2(p.cross(sphere.position(VertexId(v))).norm(), p.dot(sphere.position(VertexId(v)))));
      }
      farthest = std::max(farthest, nearest);
    }
    CHECK(farthest <= radius * 1.01);
    CHECK(generators.size() <= 1 + static_cast<std::size_t>(16 / (radius * radius)));
  }
  CHECK(cover(sphere, 4).size() == 1);
}

TEST_CASE("property 4: on every family no vertex is too far, by an independent upper bound") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const double radius = 0.2 * mesh.bbox_diagonal();
    const auto generators = cover(mesh, radius);
    const auto distance = edge_distances(mesh, generators);
    // Edges of a mesh are a detour of up to sqrt 2 on squares with diagonals in one direction, and more among thin
    // faces.
    const double detour = name == "thin-faced sphere" ? 2.0 : std::numbers::sqrt2;
    CHECK(*std::max_element(distance.begin(), distance.end()) <= detour * radius + 2 * mesh.mean_edge_length());
    CHECK(all_distinct(mesh, generators));
  }
}

TEST_CASE("a covering splits large faces") {
  const Mesh square = test::make_grid(1, 1);
  const auto generators = cover(square, 0.1);
  CHECK(generators.size() > 40);  // each disc covers at most 0.01 pi of the unit square
  CHECK(generators.size() < 150);
  CHECK(all_distinct(square, generators));
}

TEST_CASE("property 5: blue noise by radius covers the surface, and keeps its points apart") {
  for (const Mesh& mesh : {test::make_grid(1, 1), test::make_grid(8, 5)}) {
    SamplingOptions options;
    options.kind = Sampling::covering_radius;
    options.blue_noise = true;
    options.radius = 0.1 * mesh.bbox_diagonal();
    const auto points = sample_generators(mesh, options);
    const auto farthest = cover(mesh, options.radius);
    CHECK(points.size() > farthest.size() / 2);
    CHECK(points.size() < 2 * farthest.size());
    double least = kInfinity, largest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        least = std::min(least, (position(mesh, points[i]) - position(mesh, points[k])).norm());
      }
    }
    for (const FaceId f : mesh.faces()) {
      const Vec3 p = position(mesh, SurfacePoint{f, {1.0 / 3, 1.0 / 3, 1.0 / 3}});
      double nearest = kInfinity;
      for (const SurfacePoint& point : points) nearest = std::min(nearest, (position(mesh, point) - p).norm());
      largest = std::max(largest, nearest);
    }
    CHECK(least >= 0.8 * options.radius);  // marching measures too long by little
    CHECK(largest <= options.radius * (1 + 1e-9));
    options.seed = 1;
    CHECK(position(mesh, sample_generators(mesh, options)[1]) != position(mesh, points[1]));
  }
}

TEST_CASE("a covering that would split the surface too often is refused before it is split") {
  // No edge alone takes many splits: it is the area that does. The progress callback is reached by splitting only.
  const Mesh square = test::make_grid(1, 1);
  SamplingOptions options;
  options.kind = Sampling::covering_radius;
  int calls = 0;
  options.progress = [&](std::string_view, double) { return ++calls < 2; };
  for (const double radius : {1e-4, 1e-6, 1e-9, 1e-200}) {
    options.radius = radius;
    calls = 0;
    CHECK(error_of(square, options) == ErrorCode::precondition);
    CHECK(calls == 1);
  }
}

}  // namespace gvd::test_sampling_coverings
