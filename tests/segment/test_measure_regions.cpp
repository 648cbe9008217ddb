#include "gvd/error.hpp"
#include "gvd/segment.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_measure_regions {

TEST_CASE("the sizes of regions count faces and add areas, unlabelled faces left out") {
  const Mesh mesh = test::make_grid(2, 2);  // eight faces of area 1/2
  IdVector<FaceId, GeneratorId> label(8, GeneratorId(0));
  label[FaceId(3)] = label[FaceId(4)] = GeneratorId(2);
  label[FaceId(7)] = GeneratorId();
  const auto sizes = measure_regions(mesh, label, 3);
  REQUIRE(sizes.size() == 3);
  CHECK(sizes[GeneratorId(0)].faces == 5);
  CHECK(sizes[GeneratorId(0)].area == Approx(2.5));
  CHECK(sizes[GeneratorId(1)].faces == 0);
  CHECK(sizes[GeneratorId(1)].area == 0);
  CHECK(sizes[GeneratorId(2)].faces == 2);
  CHECK(sizes[GeneratorId(2)].area == Approx(1));
}

TEST_CASE("labels that do not fit the mesh or the number of regions are refused") {
  const Mesh mesh = test::make_grid(2, 2);
  const IdVector<FaceId, GeneratorId> short_by_one(7, GeneratorId(0)), labels(8, GeneratorId(3));
  CHECK_THROWS_AS(measure_regions(mesh, short_by_one, 1), Error);
  CHECK_THROWS_AS(measure_regions(mesh, labels, 3), Error);
  CHECK_NOTHROW(measure_regions(mesh, labels, 4));
}

}  // namespace gvd::test_measure_regions
