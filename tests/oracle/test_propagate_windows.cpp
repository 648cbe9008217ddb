#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "gvd/exact_field.hpp"
#include "support/catch.hpp"
#include "support/exact_fields.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/models.hpp"

namespace gvd::test_propagate_windows {

double relative_difference(double actual, double expected) {
  if (actual == expected) return 0;  // infinity, too
  return std::abs(actual - expected) / std::max(expected, std::numeric_limits<double>::min());
}

TEST_CASE("windows give the reference's distances, one run a generator") {
  for (const std::string& name : test::list_references()) {
    INFO(name);
    const test::Reference reference = test::read_reference(name);
    double worst = 0;
    for (std::size_t g = 0; g < reference.generators.size(); ++g) {
      const WindowField field =
          propagate_windows(reference.mesh, {reference.generators[g]}, {KeepWindows::none, {}}, {});
      for (std::size_t v = 0; v < reference.distances[g].size(); ++v) {
        worst = std::max(worst, relative_difference(field.distance.raw()[v], reference.distances[g][v]));
      }
    }
    CHECK(worst <= 1e-12);
  }
}

TEST_CASE("windows of all generators at once give the nearest distance, and a label that has it") {
  for (const std::string& name : test::list_references()) {
    INFO(name);
    const test::Reference reference = test::read_reference(name);
    for (const auto& [keep, partition_faces] :
         {std::pair{KeepWindows::none, 8192}, std::pair{KeepWindows::near_bisectors, 300},
          std::pair{KeepWindows::all, 8192}}) {
      const WindowField field =
          propagate_windows(reference.mesh, reference.generators, {keep, {}, 0, partition_faces}, {});
      double worst = 0, worst_label = 0;
      for (std::size_t v = 0; v < field.distance.size(); ++v) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const auto& row : reference.distances) nearest = std::min(nearest, row[v]);
        worst = std::max(worst, relative_difference(field.distance.raw()[v], nearest));
        REQUIRE(field.label.raw()[v].valid());
        worst_label =
            std::max(worst_label, relative_difference(reference.distances[field.label.raw()[v].index()][v], nearest));
      }
      CHECK(worst <= 1e-12);
      CHECK(worst_label <= 1e-9);
    }
  }
}

TEST_CASE("distances at any points, and paths of that length, on every family and from generators of any kind") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const auto generators = test::random_generators(mesh, 7, 11), points = test::random_generators(mesh, 60, 12);
    const ExactField exact(mesh, generators);
    std::vector<DistanceQuery> queries;
    for (const SurfacePoint& g : generators) queries.push_back({g, points});
    const auto expected = compute_exact_distances(mesh, queries);
    for (std::size_t i = 0; i < points.size(); ++i) {
      INFO(i);
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& row : expected) nearest = std::min(nearest, row[i]);
      const auto found = exact.nearest(points[i]);
      CHECK(relative_difference(found.distance, nearest) <= 1e-9);
      if (std::isinf(nearest)) {
        CHECK_FALSE(found.generator.valid());
        continue;
      }
      CHECK(relative_difference(expected[found.generator.index()][i], nearest) <= 1e-9);
      const GeodesicPath path = exact.path(points[i]);
      CHECK(path.length == Approx(nearest).epsilon(1e-9).margin(1e-12));
      double length = 0;
      for (std::size_t k = 0; k + 1 < path.points.size(); ++k) {
        length += (position(mesh, path.points[k + 1]) - position(mesh, path.points[k])).norm();
      }
      CHECK(length == Approx(nearest).epsilon(1e-9).margin(1e-12));
      const Vec3 end = position(mesh, path.points.back());
      CHECK((end - position(mesh, generators[path.generator.index()])).norm() <= 1e-9 * mesh.bbox_diagonal());
    }
  }
}

}  // namespace gvd::test_propagate_windows
