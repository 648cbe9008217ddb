// Repairs on a part of the mesh, after repairs on the whole one.
#include <algorithm>

#include "gvd/dual.hpp"
#include "repair/propose_generators.hpp"
#include "repair/propose_nearby.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_propose_nearby {

/// A closed surface with many defects at 80 generators, in many places: a torus whose tube is thin.
Mesh make_thin_torus() {
  const Mesh torus = test::make_torus(240, 12);
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const Vec3& p : torus.positions()) {
    const Vec3 on_circle = Vec3(p.x(), p.y(), 0).normalized();
    positions.push_back(on_circle + 0.15 * (p - on_circle));
  }
  for (std::int32_t f = 0; f < torus.face_count(); ++f) faces.push_back(torus.vertices(FaceId(f)));
  return Mesh(std::move(positions), std::move(faces));
}

std::vector<SurfacePoint> joined(std::vector<SurfacePoint> first, const std::vector<SurfacePoint>& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

std::size_t count_defects(const Mesh& mesh, const std::vector<SurfacePoint>& generators) {
  return check_dual(mesh, compute_diagram(mesh, generators)).size();
}

TEST_CASE("generators nearby: with them fewer defects are left, within the number allowed") {
  const Mesh mesh = make_thin_torus();
  int repaired = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    INFO("seed " << seed);
    const auto generators = test::random_generators(mesh, 60, seed);
    const Diagram diagram = compute_diagram(mesh, generators);
    const auto defects = check_dual(mesh, diagram);
    REQUIRE(!defects.empty());
    const auto points = propose_generators(mesh, diagram, {defects.front()}, 10).points;
    const auto nearby = propose_nearby(mesh, diagram, points, 20, {});
    CHECK(nearby.size() <= 20);
    CHECK(propose_nearby(mesh, diagram, points, 1, {}).size() <= 1);
    CHECK(propose_nearby(mesh, diagram, points, 20, {}) == nearby);
    if (nearby.empty()) continue;
    ++repaired;
    const auto with_points = joined(generators, points);
    CHECK(count_defects(mesh, joined(with_points, nearby)) < count_defects(mesh, with_points));
  }
  CHECK(repaired > 0);
}

TEST_CASE("generators nearby: none where the part would be more than a quarter of the mesh") {
  const Mesh mesh = make_thin_torus();
  const auto generators = test::random_generators(mesh, 4, 1);
  const Diagram diagram = compute_diagram(mesh, generators);
  const auto defects = check_dual(mesh, diagram);
  REQUIRE(!defects.empty());
  const auto points = propose_generators(mesh, diagram, {defects.front()}, 10).points;
  CHECK(propose_nearby(mesh, diagram, points, 20, {}).empty());
}

}  // namespace gvd::test_propose_nearby
