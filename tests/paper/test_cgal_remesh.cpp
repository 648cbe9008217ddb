#include <cstdlib>

#include "cgal_remesh.hpp"
#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "resample.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_cgal_remesh {

using namespace paper;

TEST_CASE("CGAL's remeshing gives the number of faces asked for, good ones, and the same topology") {
  const Mesh torus = test::make_torus(40, 12);
  if (!has_cgal_remeshing()) {
    CHECK_THROWS_AS(remesh_with_cgal(torus, 1000), Error);
    return;
  }
  for (const int faces : {600, 3000}) {
    const Mesh remeshed = remesh_with_cgal(torus, faces);
    CAPTURE(faces, remeshed.face_count());
    CHECK(std::abs(remeshed.face_count() - faces) <= kFacesTolerance * faces);
    CHECK(compute_triangle_quality(remeshed).q_average > 0.85);
    CHECK(compute_triangle_quality(remeshed).percent_below_30 < 1);
    CHECK(compute_mesh_summary(remeshed).euler_characteristic == 0);
    CHECK(compute_mesh_summary(remeshed).area == Approx(compute_mesh_summary(torus).area).epsilon(0.1));
  }
}

TEST_CASE("CGAL remeshes no mesh with a boundary") {
  CHECK_THROWS_AS(remesh_with_cgal(test::make_grid(3, 3), 100), Error);
}

}  // namespace gvd::test_cgal_remesh
