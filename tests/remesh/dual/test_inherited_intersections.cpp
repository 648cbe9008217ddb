// Which pairs of faces of a remesh may intersect, since the surface does.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "dual/inherited_intersections.hpp"
#include "dual/self_intersections.hpp"
#include "gvd/remesh.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_inherited_intersections {

/// Two square sheets of 2 n n faces that cross along a line at x = 0: one level, one upright.
Mesh make_crossing_squares(int n) {
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const bool is_upright : {false, true}) {
    const int first = int(positions.size());
    const auto at = [&](int i, int j) { return VertexId(first + i * (n + 1) + j); };
    for (int i = 0; i <= n; ++i) {
      for (int j = 0; j <= n; ++j) {
        const double u = double(i) / n - 0.43, v = double(j) / n - 0.57;
        positions.push_back(is_upright ? Vec3(0, v + 0.02, u) : Vec3(u, v, 0));
      }
    }
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
    }
  }
  return {std::move(positions), std::move(faces)};
}

double longest_side(const Mesh& mesh, const FacePair& pair) {
  double longest = 0;
  for (const FaceId f : {pair.first, pair.second}) {
    for (const HalfedgeId h : Mesh::halfedges(f)) longest = std::max(longest, mesh.length(h));
  }
  return longest;
}

Box3 meeting_of(const Mesh& mesh, const FacePair& pair) {
  const PlacedFaces faces(mesh);
  return meeting_box(faces.corners(pair.first), faces.corners(pair.second));
}

TEST_CASE("two triangles that cross meet in a box round their common segment") {
  const Triangle level{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};
  const Box3 crossed = meeting_box(level, {Vec3(1, 1, -1), Vec3(1, 1.5, -1), Vec3(1, 1, 1)});
  CHECK((crossed.min() - Vec3(1, 1, 0)).norm() < 1e-12);
  CHECK((crossed.max() - Vec3(1, 1.25, 0)).norm() < 1e-12);
  // Triangles in one plane have no such segment.
  const Box3 flat = meeting_box(level, {Vec3(1, 1, 0), Vec3(3, 1, 0), Vec3(1, 3, 0)});
  CHECK(flat.min() == Vec3(1, 1, 0));
  CHECK(flat.max() == Vec3(3, 3, 0));
}

TEST_CASE("no more pairs are inherited than the surface has, and each near one of its own") {
  const Mesh surface = make_crossing_squares(12);
  const auto given = find_self_intersections(surface);
  RemeshOptions options;
  options.allow_intersections = true;
  const RemeshResult result = remesh(surface, test::random_generators(surface, 60, 1), options);
  const auto& pairs = result.certificate.self_intersections;
  REQUIRE(pairs.size() > 8);
  REQUIRE(given.size() > pairs.size());
  const auto inherited = [&](const std::vector<FacePair>& of_surface) {
    return find_inherited_pairs({surface, result.diagram, result.mesh, result.face_points}, pairs, of_surface);
  };
  CHECK(inherited({}).empty());
  CHECK(inherited(given).size() == pairs.size());
  std::size_t most = 0;
  for (std::size_t count = 1; count < 6; ++count) {
    const std::vector<FacePair> few(given.begin(), given.begin() + std::ptrdiff_t(count));
    const auto found = inherited(few);
    CHECK(found.size() <= count);
    most = std::max(most, found.size());
    for (const FacePair& pair : found) {
      CHECK(std::ranges::any_of(few, [&](const FacePair& own) {
        return std::sqrt(meeting_of(surface, own).squaredExteriorDistance(meeting_of(result.mesh, pair))) <=
               longest_side(result.mesh, pair);
      }));
    }
  }
  CHECK(most > 1);
}

TEST_CASE("two large faces that cross excuse as many pairs of small ones as lie along their line") {
  const Mesh surface = make_crossing_squares(1);
  const auto given = find_self_intersections(surface);
  const RemeshResult result = remesh(surface, test::random_generators(surface, 150, 1));
  CHECK(result.certificate.ok());
  CHECK(result.certificate.self_intersections.size() > given.size());
}

}  // namespace gvd::test_inherited_intersections
