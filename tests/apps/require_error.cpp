#include "apps/require_error.hpp"

#include <algorithm>

#include "apps/run_command.hpp"
#include "support/catch.hpp"

namespace gvd::test {

std::ptrdiff_t line_count(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

void require_error(const std::string& name, const std::string& arguments, int code, const std::string& part) {
  CAPTURE(name, arguments);
  const CommandResult result = run_command(name, arguments);
  CAPTURE(result.err);
  CHECK(result.exit_code == code);
  CHECK(result.out.empty());
  CHECK(line_count(result.err) == 1);
  CHECK_THAT(result.err, Catch::Matchers::StartsWith(name + ": error: "));
  CHECK_THAT(result.err, Catch::Matchers::Contains(part));
}

}  // namespace gvd::test
