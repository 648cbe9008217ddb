#include "io/fixture.hpp"
#include "io/writers/regions.hpp"
#include "support/catch.hpp"

namespace gvd::test_regions {

using namespace test;

TEST_CASE("regions are ordered by label, the faces without a label come last") {
  const Labelled labelled;
  const std::vector<io::Region> regions = io::collect_regions(labelled.view());
  REQUIRE(regions.size() == 4);
  for (int i = 0; i < 3; ++i) CHECK(regions[std::size_t(i)].label == GeneratorId(i));
  CHECK(!regions[3].label.valid());
  std::size_t faces = 0;
  for (const io::Region& region : regions) {
    CHECK(std::is_sorted(region.faces.begin(), region.faces.end()));
    for (const FaceId f : region.faces) CHECK(labelled.face_label[f] == region.label);
    faces += region.faces.size();
  }
  CHECK(faces == labelled.face_label.size());
}

TEST_CASE("a mesh without labels is one region of all faces") {
  const Labelled labelled;
  const std::vector<io::Region> regions = io::collect_regions({labelled.mesh});
  REQUIRE(regions.size() == 1);
  CHECK(!regions[0].label.valid());
  CHECK(regions[0].faces.size() == static_cast<std::size_t>(labelled.mesh.face_count()));
}

TEST_CASE("regions are named by their label") {
  CHECK(io::region_name(GeneratorId(12)) == "region_12");
  CHECK(io::region_name(GeneratorId()) == "unlabelled");
}

}  // namespace gvd::test_regions
