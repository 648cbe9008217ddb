// The faces that a box finds, pairs of faces of whole meshes, and intersections of a remesh where its surface
// intersects itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "dual/dual_steps.hpp"
#include "gvd/self_intersections.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_self_intersections {

TEST_CASE("a box finds exactly the faces whose boxes overlap it") {
  const Mesh mesh = test::make_torus(20, 10);
  const FaceBoxes boxes(mesh, mesh.faces());
  test::Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Vec3 low(random.real(-1.5, 1.5), random.real(-1.5, 1.5), random.real(-0.5, 0.5));
    const Box3 box(low, low + Vec3::Constant(random.real(0, 0.5)));
    std::vector<FaceId> found, wanted;
    const auto collect = [&](FaceId f) {
      found.push_back(f);
      return false;
    };
    CHECK_FALSE(boxes.any_of(box, collect));
    std::sort(found.begin(), found.end());
    for (const FaceId f : mesh.faces()) {
      if (face_box(mesh, f).intersects(box)) wanted.push_back(f);
    }
    CHECK(found == wanted);
  }
}

TEST_CASE("closed boxes that touch overlap, and an empty mesh has none") {
  const Box3 unit(Vec3(0, 0, 0), Vec3(1, 1, 1));
  CHECK(unit.intersects(Box3(Vec3(1, 1, 1), Vec3(2, 2, 2))));
  CHECK_FALSE(unit.intersects(Box3(Vec3(1, 1, 1.5), Vec3(2, 2, 2))));
  const Mesh empty;
  CHECK_FALSE(FaceBoxes(empty, empty.faces()).any_of(unit, [](FaceId) { return true; }));
}

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

/// The definition, with each pair of pairs.
std::vector<FacePair> search_all(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs) {
  const std::vector<FacePair> given = find_self_intersections(surface);
  std::vector<FacePair> inherited;
  for (const FacePair& pair : pairs) {
    const Box3 a = face_box(remesh, pair.first), b = face_box(remesh, pair.second);
    const Vec3 margin = Vec3::Constant(std::max((a.max() - a.min()).norm(), (b.max() - b.min()).norm()) / 2);
    const Box3 common(a.min().cwiseMax(b.min()) - margin, a.max().cwiseMin(b.max()) + margin);
    const bool is_near = std::any_of(given.begin(), given.end(), [&](const FacePair& other) {
      return common.intersects(face_box(surface, other.first)) && common.intersects(face_box(surface, other.second));
    });
    if (is_near) inherited.push_back(pair);
  }
  return inherited;
}

/// A sheet that passes through itself in some places only: two grids, one of them with waves.
Mesh make_crossing_sheets(int n, double level) {
  const Mesh flat = test::make_grid(n, n);
  std::vector<Vec3> positions = flat.positions();
  std::vector<std::array<VertexId, 3>> faces;
  for (const FaceId f : flat.faces()) faces.push_back(flat.vertices(f));
  for (const Vec3& p : flat.positions()) {
    positions.push_back({p.x(), p.y(), level + std::sin(p.x()) * std::cos(1.3 * p.y())});
  }
  const std::int64_t offset = flat.vertex_count();
  for (std::size_t f = 0, count = faces.size(); f < count; ++f) {
    const auto& [a, b, c] = faces[f];
    faces.push_back({VertexId(a.value() + offset), VertexId(b.value() + offset), VertexId(c.value() + offset)});
  }
  return Mesh(std::move(positions), std::move(faces));
}

TEST_CASE("inherited intersections are those that the definition gives") {
  for (const double level : {0.3, 0.7, 0.95}) {
    const Mesh surface = make_crossing_sheets(12, 0.8), remesh = make_crossing_sheets(12, level);
    const auto pairs = find_self_intersections(remesh);
    REQUIRE(pairs.size() > 4);
    const auto inherited = find_inherited(surface, remesh, pairs);
    CHECK(inherited == search_all(surface, remesh, pairs));
    if (level == 0.3) CHECK((!inherited.empty() && inherited.size() < pairs.size()));
  }
}

TEST_CASE("nothing is inherited from a surface that does not intersect itself") {
  const Mesh remesh = make_crossing_sheets(12, 0.5);
  const auto pairs = find_self_intersections(remesh);
  REQUIRE_FALSE(pairs.empty());
  CHECK(find_inherited(make_crossing_sheets(12, 9), remesh, pairs).empty());
  CHECK(find_inherited(remesh, remesh, {}).empty());
  CHECK(find_inherited(remesh, remesh, pairs) == pairs);
}

}  // namespace gvd::test_self_intersections
