// Isolines and shortest paths beside CGAL's exact distances.

#include <cmath>

#include "gvd/exact_field.hpp"
#include "gvd/verify.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_isolines_oracle {

TEST_CASE("the reference's distances of points of isolines are their levels, and of points of paths the ways left") {
  std::size_t compared = 0;
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    const SurfacePoint source = test::random_generators(mesh, 1, 11).front();
    const ExactField field(mesh, {source});
    double largest = 0;
    for (const VertexId v : mesh.vertices()) {
      if (std::isfinite(field.distance(v))) largest = std::max(largest, field.distance(v));
    }
    std::vector<SurfacePoint> points;
    std::vector<double> expected;
    for (const Isoline& line : field.isolines({0.03 * largest, 0.4 * largest, 0.93 * largest})) {
      for (std::size_t i = 0; i < line.points.size(); i += 5) {
        points.push_back(line.points[i]);
        expected.push_back(line.level);
      }
    }
    for (const SurfacePoint& start : test::random_generators(mesh, 5, 12)) {
      const GeodesicPath path = field.path(start);
      double left = path.length;
      for (std::size_t i = 0; i < path.points.size(); ++i) {
        if (i > 0) left -= (position(mesh, path.points[i]) - position(mesh, path.points[i - 1])).norm();
        points.push_back(path.points[i]);
        expected.push_back(left);
      }
    }
    const std::vector<double> distances = compute_exact_distances(mesh, {{source, points}}).front();
    for (std::size_t i = 0; i < points.size(); ++i) {
      CHECK(distances[i] == Approx(expected[i]).epsilon(1e-9).margin(1e-9 * largest));
    }
    compared += points.size();
  }
  CHECK(compared > 500);
}

}  // namespace gvd::test_isolines_oracle
