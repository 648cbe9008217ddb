#include "common/name_options.hpp"
#include "gvd/error.hpp"
#include "gvd/soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_name_options {

using namespace app;
using Catch::Matchers::EndsWith;

TEST_CASE("a message that ends with advice of the library names the option") {
  CHECK(name_options("a.xyz:1: 3 from the surface; move it, or raise max_snap") ==
        "a.xyz:1: 3 from the surface; move it, or raise --max-snap");
  CHECK(name_options("name the format") == "name the format with --input-format obj, ply, off or stl");
}

TEST_CASE("any other message stays as it is") {
  CHECK(name_options("").empty());
  CHECK(name_options("name the format.obj: there is no such file") == "name the format.obj: there is no such file");
}

TEST_CASE("the library gives the advice that names --on-defect") {
  PolygonSoup soup;
  soup.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, 5, 5}};  // the last one is in no face
  soup.corners = {0, 1, 2};
  soup.close_polygon();
  try {
    build_mesh(soup, DefectPolicy::error);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK_THAT(name_options(error.what()), EndsWith("allow its repair with --on-defect repair"));
  }
}

}  // namespace gvd::test_name_options
