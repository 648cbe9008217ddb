// Pairs of faces of whole meshes.
#include <algorithm>

#include "gvd/self_intersections.hpp"
#include "intersection/faces_intersect.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_self_intersections {

std::vector<FacePair> search_all_pairs(const Mesh& mesh) {
  std::vector<FacePair> pairs;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    for (std::int32_t j = i + 1; j < mesh.face_count(); ++j) {
      if (faces_intersect(mesh, FaceId(i), FaceId(j))) pairs.push_back({FaceId(i), FaceId(j)});
    }
  }
  return pairs;
}

/// The mesh with every vertex moved by at most `distance` along each axis.
Mesh shake(const Mesh& mesh, double distance, unsigned seed) {
  test::Random random(seed);
  std::vector<Vec3> positions = mesh.positions();
  const auto shift = [&] { return random.real(-distance, distance); };
  for (Vec3& p : positions) p += Vec3(shift(), shift(), shift());
  std::vector<std::array<VertexId, 3>> faces;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) faces.push_back(mesh.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

std::size_t count_pairs(const std::vector<Vec3>& positions, const std::vector<std::array<int, 3>>& faces) {
  return find_self_intersections(test::make_mesh(positions, faces)).size();
}

TEST_CASE("two separate triangles intersect where they cross, touch or overlap") {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meets = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return count_pairs({a, b, c, p, q, r}, {{0, 1, 2}, {3, 4, 5}}) == 1;
  };
  CHECK_FALSE(meets({0, 0, 1}, {4, 0, 1}, {0, 4, 1}));
  CHECK(meets({1, 1, -1}, {1, 1, 1}, {2, 1, 1}));       // one crosses the other
  CHECK(meets({1, 1, 0}, {1, 1, 1}, {2, 1, 1}));        // a vertex touches a face
  CHECK(meets({4, 0, 0}, {5, 0, 1}, {5, 1, 1}));        // two vertices touch
  CHECK(meets({2, 2, -1}, {2, 2, 1}, {9, 9, 0}));       // two edges touch
  CHECK(meets({1, 1, 0}, {9, 1, 0}, {9, 2, 0}));        // coplanar, overlapping
  CHECK(meets({0.5, 0.5, 0}, {1, 0.5, 0}, {1, 1, 0}));  // coplanar, one inside the other
  CHECK_FALSE(meets({3, 3, 0}, {9, 3, 0}, {9, 4, 0}));  // coplanar, apart
  CHECK_FALSE(meets({2.5, 2, -1}, {2, 2.5, 1}, {9, 9, 0}));
}

TEST_CASE("two triangles of one vertex intersect where they cross beyond it") {
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meets = [&](const Vec3& p, const Vec3& q) {
    // The third face joins them to one fan.
    const Mesh fan = test::make_mesh({a, b, c, p, q}, {{0, 1, 2}, {0, 3, 4}, {0, 2, 3}});
    const std::vector<FacePair> pairs = find_self_intersections(fan);
    return std::find(pairs.begin(), pairs.end(), FacePair{FaceId(0), FaceId(1)}) != pairs.end();
  };
  CHECK_FALSE(meets({-1, 0, 0}, {0, -1, 0}));
  CHECK_FALSE(meets({1, 1, 1}, {2, 1, 1}));
  CHECK(meets({1, 1, -1}, {1, 1, 1}));
  CHECK(meets({9, 9, -1}, {9, 9, 1}));
  CHECK(meets({1, 1, 0}, {1, 2, 3}));  // along an edge of one
}

TEST_CASE("two triangles of one edge intersect where they are folded flat") {
  const auto meets = [&](const Vec3& p) {
    return count_pairs({{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p}, {{0, 1, 2}, {1, 0, 3}}) == 1;
  };
  CHECK_FALSE(meets({0, -4, 0}));
  CHECK_FALSE(meets({0, 4, 1}));
  CHECK(meets({4, 4, 0}));
}

TEST_CASE("no mesh of the family intersects itself") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    CHECK(find_self_intersections(mesh).empty());
  }
}

TEST_CASE("the pairs are those of a search over all pairs, for any number of threads") {
  std::size_t found = 0;
  for (unsigned seed = 0; seed < 4; ++seed) {
    for (const auto& [name, mesh] : test::small_family()) {
      INFO(name << ", seed " << seed);
      const Mesh shaken = shake(mesh, 0.4 * mesh.mean_edge_length(), seed);
      const std::vector<FacePair> pairs = find_self_intersections(shaken, 1);
      CHECK(pairs == search_all_pairs(shaken));
      CHECK(pairs == find_self_intersections(shaken, 4));
      found += pairs.size();
    }
  }
  CHECK(found > 1000);
}

}  // namespace gvd::test_self_intersections
