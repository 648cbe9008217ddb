#include "apps/remesh/run_remesh.hpp"

#include "support/catch.hpp"

namespace gvd::test {

std::string run_remesh(const std::string& arguments) {
  const CommandResult result = run_command("gvd-remesh", arguments);
  CAPTURE(arguments, result.err);
  REQUIRE(result.exit_code == 0);
  return result.err;
}

nlohmann::json report_of(const std::string& arguments) {
  const ScratchFolder scratch;
  run_remesh(arguments + " -q --report " + scratch / "report.json");
  return nlohmann::json::parse(read_text(scratch / "report.json"));
}

}  // namespace gvd::test
