#include "io/fixture.hpp"
#include "io/writers/unnamed_file.hpp"
#include "support/catch.hpp"

namespace gvd::test_unnamed_file {

using namespace test;

TEST_CASE("a file without a name gets one that is free") {
  const TemporaryFolder folder;
  std::FILE* const file = gvd::detail::open_unnamed(folder / "");
  if (file == nullptr) {
    WARN("skipped: no files without a name here");
    return;
  }
  CHECK(std::fputs("new", file) >= 0);
  CHECK(std::fflush(file) == 0);
  CHECK(folder.names().empty());
  write_bytes(folder / "taken", "old");
  CHECK(!gvd::detail::give_name(file, folder / "taken"));
  CHECK(errno == EEXIST);
  CHECK(!gvd::detail::give_name(file, folder / "none/a"));
  CHECK(gvd::detail::give_name(file, folder / "free"));
  std::fclose(file);
  CHECK(read_bytes(folder / "free") == "new");
  CHECK(read_bytes(folder / "taken") == "old");
}

TEST_CASE("there is no file without a name in a folder that is not there") {
  const TemporaryFolder folder;
  CHECK(gvd::detail::open_unnamed(folder / "none") == nullptr);
}

}  // namespace gvd::test_unnamed_file
