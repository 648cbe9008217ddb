// Names of files.

#include "common/options/options.hpp"
#include "support/catch.hpp"

namespace gvd::test_options {

using namespace app;

TEST_CASE("an extension is in lower case and has no dot") {
  CHECK(file_extension("a.ply") == "ply");
  CHECK(file_extension("folder.d/A.tar.OBJ") == "obj");
  CHECK(file_extension("a.") == "");
  for (const char* none : {"", "a", "folder.d/a", ".hidden", "-"}) {
    CAPTURE(none);
    CHECK(file_extension(none).empty());
  }
}

}  // namespace gvd::test_options
