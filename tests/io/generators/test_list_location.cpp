#include "gvd/error.hpp"
#include "io/generators/list_location.hpp"
#include "support/catch.hpp"

namespace gvd::test_list_location {

using namespace test;

TEST_CASE("a location is a name and, where there is one, a line") {
  const std::string name = "a.txt";
  CHECK(detail::ListLocation{name, 12}.text() == "a.txt:12");
  CHECK(detail::ListLocation{name}.text() == "a.txt");
  try {
    detail::ListLocation{name, 12}.refuse("wrong");
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unreadable_input);
    CHECK(error.element() == 11);
    CHECK(std::string(error.what()) == "a.txt:12: wrong");
  }
}

}  // namespace gvd::test_list_location
