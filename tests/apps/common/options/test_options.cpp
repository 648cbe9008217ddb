// Texts of users.

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

TEST_CASE("texts of the user's are printable and short in messages, and keep their letters whole") {
  CHECK(app::printable("-n") == "-n");
  CHECK(app::printable(std::string("a\n\0\x1b", 4) + "\x7f") == "a    ");
  CHECK(app::printable(std::string(61, 'a')) == std::string(60, 'a') + "...");
  CHECK(app::printable("k\u00e4se", 3) == "k\u00e4...");
  CHECK(app::printable("k\u00e4se", 2) == "k...");
}

}  // namespace gvd::test_options
