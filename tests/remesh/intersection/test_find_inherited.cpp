// Intersections of a remesh where its surface intersects itself.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "gvd/self_intersections.hpp"
#include "intersection/face_boxes.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_find_inherited {

/// The definition, with each pair of pairs.
std::vector<FacePair> search_all(const Mesh& surface, const Mesh& remesh, const std::vector<FacePair>& pairs) {
  const std::vector<FacePair> given = find_self_intersections(surface);
  std::vector<FacePair> inherited;
  for (const FacePair& pair : pairs) {
    const Box3 a = face_box(remesh, pair.first), b = face_box(remesh, pair.second);
    const double margin = std::max((a.high - a.low).norm(), (b.high - b.low).norm()) / 2;
    const Box3 common{a.low.cwiseMax(b.low).array() - margin, a.high.cwiseMin(b.high).array() + margin};
    const bool is_near = std::any_of(given.begin(), given.end(), [&](const FacePair& other) {
      return overlap(common, face_box(surface, other.first)) && overlap(common, face_box(surface, other.second));
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
  for (std::int32_t f = 0; f < flat.face_count(); ++f) faces.push_back(flat.vertices(FaceId(f)));
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

}  // namespace gvd::test_find_inherited
