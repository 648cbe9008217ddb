#include <cmath>
#include <cstdlib>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/quality.hpp"
#include "resample.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_resample {

using namespace paper;

bool is_within_tolerance(int faces, int wanted) { return std::abs(faces - wanted) <= kFacesTolerance * wanted; }

TEST_CASE("a resampled torus has the number of faces asked for, good ones, and the same topology") {
  const Mesh torus = test::make_torus(40, 20);
  // Near the torus's own 1600 faces few edges are split or collapsed, so that sizes are harder to reach, and the
  // quality stays more like that of the torus.
  for (const int faces : {400, 1500, 1600, 2100, 6000}) {
    const Mesh resampled = resample(torus, faces);
    CAPTURE(faces, resampled.face_count());
    CHECK(is_within_tolerance(resampled.face_count(), faces));
    CHECK(compute_triangle_quality(resampled).q_average > 0.75);
    CHECK(compute_mesh_summary(resampled).euler_characteristic == 0);
    CHECK(compute_mesh_summary(resampled).area == Approx(compute_mesh_summary(torus).area).epsilon(0.1));
  }
}

TEST_CASE("the search for an edge length ends, and gives the nearest mesh where none has the number of faces") {
  int tries = 0;
  // Edges of less than 0.3 make 800 faces, longer ones 200.
  const auto remesh = [&](double edge_length) {
    ++tries;
    return edge_length < 0.3 ? test::make_torus(20, 20) : test::make_torus(10, 10);
  };
  CHECK(search_edge_length(remesh, 10, 700).face_count() == 800);
  CHECK(tries == kMostTries);
}

TEST_CASE("a mesh with a boundary is not resampled") { CHECK_THROWS_AS(resample(test::make_grid(3, 3), 100), Error); }

}  // namespace gvd::test_resample
