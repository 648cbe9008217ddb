// Flat strips of thin faces whose corners are generators: branch points lie on edges, by ties, and distances are known
// exactly.
#include <algorithm>
#include <vector>

#include "gvd/diagram.hpp"
#include "support/catch.hpp"

namespace gvd::test_thin_faces {

Mesh make_sheet(const std::vector<double>& xs, const std::vector<double>& ys) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  const auto columns = static_cast<int>(xs.size());
  for (const double y : ys) {
    for (const double x : xs) positions.push_back({x, y, 0});
  }
  for (int row = 0; row + 1 < static_cast<int>(ys.size()); ++row) {
    for (int column = 0; column + 1 < columns; ++column) {
      const int a = row * columns + column, c = a + columns;
      faces.push_back({VertexId(a), VertexId(a + 1), VertexId(c)});
      faces.push_back({VertexId(a + 1), VertexId(c + 1), VertexId(c)});
    }
  }
  return Mesh(std::move(positions), std::move(faces));
}

/// The largest difference of the distances from a bisector's point to its two generators and to the nearest generator,
/// in mean edge lengths.
double largest_error(const Mesh& mesh, const std::vector<int>& vertices) {
  std::vector<SurfacePoint> generators;
  for (const int v : vertices) generators.push_back(vertex_point(mesh, VertexId(v)));
  const auto distance = [&](GeneratorId g, const Vec3& p) {
    return (position(mesh, generators[g.index()]) - p).norm();
  };
  double largest = 0;
  for (const Bisector& bisector : compute_diagram(mesh, generators).bisectors) {
    for (const SurfacePoint& point : bisector.points) {
      const Vec3 p = position(mesh, point);
      double least = std::min(distance(bisector.left, p), distance(bisector.right, p));
      for (std::size_t g = 0; g < generators.size(); ++g) {
        least = std::min(least, distance(GeneratorId(g), p));
      }
      largest = std::max({largest, distance(bisector.left, p) - least, distance(bisector.right, p) - least});
    }
  }
  return largest / mesh.mean_edge_length();
}

/// Twice the chord tolerance.
constexpr double kAllowed = 2e-4;

TEST_CASE("branch points on edges of thin faces are where the generators are equally far") {
  const Mesh strip = make_sheet({0, 0.25, 0.5, 1}, {0, 0.001});
  CHECK(largest_error(strip, {3, 4, 1, 6, 5, 7}) < kAllowed);
  CHECK(largest_error(strip, {7, 1, 0, 4, 5, 6, 2}) < kAllowed);
}

// Where four corners of two faces are equally far from one point, a first branch point there leaves a sliver for the
// second one.
TEST_CASE("two branch points in one place of a thin face are both there") {
  CHECK(largest_error(make_sheet({0, 0.25, 0.5, 1}, {0, 0.0001}), {3, 4, 7, 6, 0, 2, 5, 1}) < kAllowed);
  const Mesh sheet = make_sheet({0, 0.25, 0.5, 1}, {0, 0.0001, 0.0002, 0.0003});
  CHECK(largest_error(sheet, {12, 13, 1, 6, 14, 0, 4, 5, 3, 8, 10, 15, 7, 2, 11, 9}) < kAllowed);
}

}  // namespace gvd::test_thin_faces
