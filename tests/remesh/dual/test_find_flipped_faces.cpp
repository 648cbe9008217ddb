// Faces of a remesh against the normals of the surface, on one flat square.
#include <array>
#include <utility>
#include <vector>

#include "gvd/dual.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_find_flipped_faces {

/// The faces that are flipped against the plane, of one triangle for each three positions.
std::vector<FaceId> find_flipped(const std::vector<Vec3>& positions) {
  const Mesh plane = test::make_jittered_grid(1, 1, 0, 1);
  std::vector<std::array<int, 3>> faces;
  for (int i = 0; i + 2 < static_cast<int>(positions.size()); i += 3) faces.push_back({i, i + 1, i + 2});
  // Where the generators lie on a plane makes no difference to its normal.
  const SurfacePoint anywhere = make_surface_point(FaceId(0), {0.25, 0.25, 0.5});
  return find_flipped_faces(plane, test::make_mesh(positions, faces),
                            std::vector<SurfacePoint>(positions.size(), anywhere),
                            std::vector<SurfacePoint>(faces.size(), anywhere));
}

TEST_CASE("faces that turn their back to the surface are flipped, and are listed in order") {
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  CHECK(find_flipped({a, b, c}).empty());
  CHECK(find_flipped({a, c, b}) == std::vector<FaceId>{FaceId(0)});
  CHECK(find_flipped({a, c, b, a, b, c, b, a, c}) == std::vector<FaceId>{FaceId(0), FaceId(2)});
}

TEST_CASE("a face without area, or upright on the surface, counts as flipped up to the tolerance") {
  const Vec3 a(0, 0, 0), b(1, 0, 0);
  CHECK(find_flipped({a, b, {0.5, 0, 0}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 0.5 * kFlipTolerance, 0}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 2 * kFlipTolerance, 0}}).empty());
  CHECK(find_flipped({a, b, {0.5, 0, 1}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 0.5 * kFlipTolerance, 1}}).size() == 1);
  CHECK(find_flipped({a, b, {0.5, 2 * kFlipTolerance, 1}}).empty());
}

TEST_CASE("triangles of a dual are judged without the rest of it") {
  const Mesh sphere = test::make_sphere(2);
  const Diagram diagram = compute_diagram(sphere, test::random_generators(sphere, 30, 0));
  DualMesh dual = build_dual(sphere, diagram);
  CHECK(find_flipped_triangles(sphere, diagram, dual).empty());
  std::swap(dual.faces[2][0], dual.faces[2][1]);
  dual.faces[4] = dual.faces[2];  // no mesh any more: two faces with the same corners, and a hole
  dual.branch_points[4] = dual.branch_points[2];
  CHECK(find_flipped_triangles(sphere, diagram, dual) == std::vector<std::size_t>{2, 4});
}

}  // namespace gvd::test_find_flipped_faces
