// Every option that a command describes, tried well and badly on its command line and in its --config.
//
// An input that is not there ends a run with exit code 3 once all options are taken, and with 2 before.

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "apps/require_error.hpp"
#include "apps/run_command.hpp"
#include "support/catch.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_described_options {

using namespace test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;
using Json = nlohmann::ordered_json;

constexpr int kUsage = 2, kNoInput = 3;
constexpr const char* kInput = "/nonexistent/mesh.obj";

Json describe(const std::string& command) {
  return Json::parse(run_command(command, "--print-options").out)["options"];
}

/// The options to try. A sanitized command takes .1 s to start, and every option goes the same way through it: one in
/// three.
std::vector<Json> options_to_try(const Json& all) {
  std::vector<Json> tried;
  for (std::size_t i = 0; i < all.size(); i += kSanitized ? 3 : 1) tried.push_back(all[i]);
  return tried;
}

/// Options that do nothing unless others are there, with these.
const std::map<std::string, std::string> kCompanions{{"front", "method=gbgvd"},
                                                     {"up", "view=v.html"},
                                                     {"ascii_ply", "output=a.ply"},
                                                     {"no_curves", "output=a.obj"},
                                                     {"region_materials", "output=a.obj"},
                                                     {"carry", "output=a.ply"},
                                                     {"output_format", "output=-"},
                                                     {"paths", "to=3"},
                                                     {"gradation", "density=curvature"}};

/// A value that an option takes; empty for a flag.
std::string good_value(const Json& option) {
  const std::string kind = option["kind"];
  if (option.contains("choices")) return option["choices"][0];
  if (kind == "number") return option.value("most", 2.0) < 1 ? "0.5" : "1";
  if (kind == "whole number") return option.value("least", 1.0) > 1 ? "50" : "1";
  if (kind == "input file") return "list.txt";
  if (kind == "output file") return "out." + option["extensions"][0].get<std::string>();
  if (kind == "folder") return "out";
  if (kind == "vertices" || kind == "points" || kind == "counts") return "1,2";
  if (kind == "curves") return "boundary";
  if (kind == "values") return "heat";
  if (kind == "bytes") return "64G";
  if (kind == "bound") return "0.5%";
  return kind == "crease angle" ? "30" : "on";
}

/// A value that no option of this kind takes; nothing where it takes any text.
std::optional<std::string> bad_value(const Json& option) {
  const std::string kind = option["kind"];
  if (kind == "input file" || kind == "values" || kind == "folder" || kind == "output file" || kind == "curves") {
    return option["name"] == "input" ? std::nullopt : std::optional<std::string>("");
  }
  return kind == "points" ? "-1" : "nonsense";
}

bool excludes(const Json& option, const std::string& name) {
  const Json& all = option["excludes"];
  return std::find(all.begin(), all.end(), name) != all.end();
}

/// A line of options, and the same as a file.
struct Given {
  std::string folder;  ///< for what is written
  std::string line = {}, file = {};

  void add(const Json& option, std::string value) {
    const bool is_written = option["kind"] == "output file" || option["kind"] == "folder";
    if (is_written && !value.empty() && value != "-") value = folder + value;
    const std::string name = option["names"].back().get<std::string>();
    const bool is_flag = option["kind"] == "flag";
    // Behind an equals sign, anything is the value of a name that may stand alone.
    const bool is_joined = name == "--weld" || (is_flag && !value.empty());
    line += ' ' + name + (is_joined ? "='" + value + "'" : is_flag ? "" : " '" + value + "'");
    const bool is_bare =
        is_flag || (!option.contains("choices") && value.find_first_not_of("0123456789.") == value.npos &&
                    (option["kind"] == "number" || option["kind"] == "whole number"));
    file += name.substr(2) + " = " +
            (is_flag && value.empty()    ? "true"
             : is_bare && !value.empty() ? value
                                         : '"' + value + '"') +
            '\n';
  }
};

const Json& find(const Json& all, const std::string& name) {
  return *std::find_if(all.begin(), all.end(), [&](const Json& option) { return option["name"] == name; });
}

/// What a command needs beside an option: an input, sources or generators, and the options that it works with.
Given companions(const Json& all, const Json& option, const std::string& folder) {
  Given given{folder};
  const std::string name = option["name"];
  const bool measures = std::any_of(all.begin(), all.end(), [](const Json& o) { return o["name"] == "from"; });
  const std::string source = measures ? "from" : name == "max_snap" ? "generators" : "vertices";
  const std::string usual = measures ? "from" : "count";
  std::vector<std::string> needed = option["needs"];
  // What an option needs may be a source: a list, for its format.
  const bool needs_source = std::any_of(needed.begin(), needed.end(),
                                        [&](const std::string& other) { return excludes(find(all, other), usual); });
  const bool has_source = name == usual || excludes(option, usual) || needs_source;
  if (!has_source) given.add(find(all, usual), "3");
  const bool is_source = excludes(option, source) || name == source || measures || needs_source;
  if (has_source && !is_source) given.add(find(all, source), source == "vertices" ? "1" : "list.txt");
  for (const std::string& other : needed) {
    if (other != usual && (other != source || needs_source)) given.add(find(all, other), good_value(find(all, other)));
  }
  if (const auto found = kCompanions.find(name); found != kCompanions.end()) {
    const std::size_t equals = found->second.find('=');
    given.add(find(all, found->second.substr(0, equals)), found->second.substr(equals + 1));
  }
  return given;
}

TEST_CASE("commands: every option is taken with a value of its kind, on the line and in a file") {
  const ScratchFolder scratch;
  for (const std::string command : {"gvd-segment", "gvd-lloyd", "gvd-remesh", "gvd-distance"}) {
    const Json all = describe(command);
    for (const Json& option : options_to_try(all)) {
      const std::string name = option["name"];
      if (name == "input" || name == "config" || name == "open" || name == "verify") continue;  // pages and builds
      Given given = companions(all, option, scratch / "");
      given.add(option, option["kind"] == "flag" ? "" : good_value(option));
      CAPTURE(command, given.line);
      const CommandResult line = run_command(command, kInput + given.line);
      CHECK(line.exit_code == kNoInput);
      CAPTURE(line.err);
      write_text(scratch / "o.toml", given.file);
      const CommandResult file = run_command(command, kInput + std::string(" --config ") + scratch / "o.toml");
      CAPTURE(file.err, given.file);
      CHECK(file.exit_code == kNoInput);
    }
  }
}

TEST_CASE("commands: every option refuses a wrong value by its name, and in a file with its place") {
  const ScratchFolder scratch;
  for (const std::string command : {"gvd-segment", "gvd-lloyd", "gvd-remesh", "gvd-distance"}) {
    for (const Json& option : options_to_try(describe(command))) {
      const std::optional<std::string> bad = bad_value(option);
      if (!bad || option["name"] == "view") continue;  // a page may have no name
      Given given{""};
      given.add(option, *bad);
      const std::string name = option["names"].back();
      CAPTURE(command, given.line);
      const CommandResult line = run_command(command, kInput + given.line);
      CHECK(line.exit_code == kUsage);
      CHECK(line_count(line.err) == 1);
      CHECK_THAT(line.err, StartsWith(command + ": error: " + name));
      if (option["name"] == "config") continue;
      write_text(scratch / "o.toml", given.file);
      const CommandResult file = run_command(command, kInput + std::string(" --config ") + scratch / "o.toml");
      CHECK(file.exit_code == kUsage);
      CHECK_THAT(file.err, StartsWith(command + ": error: " + scratch / "o.toml:1:") && Contains(name.substr(2)));
    }
  }
}

TEST_CASE("commands: every option that takes a value says so where it is missing") {
  for (const std::string command : {"gvd-segment", "gvd-lloyd", "gvd-remesh", "gvd-distance"}) {
    for (const Json& option : options_to_try(describe(command))) {
      const std::string value = option["value"], name = option["names"].back();
      if (option["kind"] == "flag" || name == "INPUT" || name == "--weld" || name == "--view") continue;
      CAPTURE(command, name);
      const CommandResult result = run_command(command, kInput + (' ' + name));
      CHECK(result.exit_code == kUsage);
      CHECK_THAT(result.err,
                 StartsWith(command + ": error: " + name + ": its value is missing; write " + name + ' ' + value));
    }
  }
}

TEST_CASE("commands: no rule and no text names an option that the command lacks") {
  for (const std::string command : {"gvd-segment", "gvd-lloyd", "gvd-remesh", "gvd-distance"}) {
    CAPTURE(command);
    CHECK(run_command(command, "--print-options").exit_code == 0);  // it looks for such names
  }
}

}  // namespace gvd::test_described_options
