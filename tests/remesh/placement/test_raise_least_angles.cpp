// Thin triangles get larger angles, and the others keep theirs.
#include <algorithm>

#include "gvd/quality.hpp"
#include "placement/raise_least_angles.hpp"
#include "placement/with_positions.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"

namespace gvd::test_raise_least_angles {

/// A sphere whose vertices were moved at random.
Mesh make_uneven_sphere(unsigned seed) {
  const Mesh sphere = test::make_sphere(3);
  test::Random random(seed);
  std::vector<Vec3> positions = sphere.positions();
  const double far = 0.4 * sphere.mean_edge_length();
  for (Vec3& p : positions) p += far * Vec3(random.real(-1, 1), random.real(-1, 1), random.real(-1, 1));
  for (Vec3& p : positions) p.normalize();
  return with_positions(sphere, positions);
}

std::vector<double> angles_of(const Mesh& mesh) {
  std::vector<double> angles;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) {
    const auto& [a, b, c] = mesh.vertices(FaceId(f));
    angles.push_back(compute_min_angle(mesh.position(a), mesh.position(b), mesh.position(c)));
  }
  return angles;
}

TEST_CASE("the smallest angles grow, and no triangle gets thinner than the bound or than it was") {
  for (unsigned seed = 0; seed < 5; ++seed) {
    const Mesh before = make_uneven_sphere(seed);
    const Mesh after =
        with_positions(before, raise_least_angles(before, std::vector<char>(before.positions().size(), 1), 30));
    const auto was = angles_of(before), is = angles_of(after);
    CHECK(*std::min_element(is.begin(), is.end()) > 5 + *std::min_element(was.begin(), was.end()));
    for (std::size_t f = 0; f < is.size(); ++f) CHECK(is[f] >= std::min(was[f], 30.0) - 1e-6);
  }
}

TEST_CASE("vertices that may not move, and those of good triangles, stay") {
  const Mesh uneven = make_uneven_sphere(0), sphere = test::make_sphere(2);
  CHECK(raise_least_angles(uneven, std::vector<char>(uneven.positions().size(), 0), 30) == uneven.positions());
  CHECK(raise_least_angles(sphere, std::vector<char>(sphere.positions().size(), 1), 30) == sphere.positions());
}

}  // namespace gvd::test_raise_least_angles
