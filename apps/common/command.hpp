#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>
#include <vector>

#include "common/options.hpp"
#include "common/run.hpp"

namespace gvd::app {

struct CommandInfo {
  std::string name;         ///< "gvd-segment"
  std::string description;  ///< one sentence
  std::string examples;     ///< for --help: lines, each one a call
  /// Extensions without the dot that `-o` takes. `-o -` writes the first one unless --output-format names another.
  std::vector<std::string> output_formats;
};

/// A command: the shared options, its own, and the way from main() to an exit code.
///
///     int main(int argc, char** argv) {
///       bool cut = false;
///       gvd::app::Command command({"gvd-segment", "Labels ...", "gvd-segment bunny.obj -n 30 -o out.ply", {"ply",
///       "obj"}}); command.cli().add_flag("--cut", cut, "Split faces along the bisectors"); return command.run(argc,
///       argv, [&](gvd::app::Run& run) {
///         const auto input = gvd::app::load_input(run);
///         ...
///       });
///     }
class Command {
 public:
  explicit Command(CommandInfo info);
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  /// For the command's own options. A check that needs several of them belongs in `body`, as Error{invalid_option}.
  CLI::App& cli() { return cli_; }

  /// Parses, runs `body`, and returns the exit code: 0 where it returns, 2 to 6 and 130 for a gvd::Error of each code
  /// (with its message in one line on stderr), 2 for a usage error, 5 where memory runs out.
  int run(int argc, const char* const* argv, const std::function<void(Run&)>& body);

 private:
  void parse(int argc, const char* const* argv);

  CommandInfo info_;
  Options options_;
  CLI::App cli_;
};

}  // namespace gvd::app
