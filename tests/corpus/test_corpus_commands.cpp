// The three commands over real meshes: each run succeeds, or is refused with one line.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <iostream>

#include "apps/run_command.hpp"
#include "corpus/corpus.hpp"
#include "support/catch.hpp"

namespace gvd::test_corpus_commands {

using namespace test;

struct Call {
  std::string command;
  std::string options;
  std::string output;
  std::vector<int> refusals;  ///< exit codes that are allowed for meshes that the command can't handle
  bool is_long = false;
};

/// Long runs are made on small meshes, and on one large mesh in four.
constexpr std::uintmax_t kLarge = 200'000;  // bytes
constexpr int kLargeStep = 4;

std::vector<Call> calls() {
  // gvd-remesh guarantees a proper mesh. Thin faces and components of a few faces do not always have one.
  return {{"gvd-segment", "-n 30", "regions.ply", {3, 4}},
          {"gvd-segment", "-n 30 --cut", "pieces.ply", {3, 4}},
          {"gvd-lloyd", "-n 12 --iterations 5", "relaxed.txt", {3, 4}, true},
          {"gvd-remesh", "-n 60", "coarse.ply", {3, 4, 5}, true}};
}

TEST_CASE("the commands succeed on every mesh of the corpus, or refuse it with one line") {
  int runs = 0, refused = 0, large = 0;
  for (const auto& file : corpus()) {
    const bool is_left_out = std::filesystem::file_size(file) >= kLarge && large++ % kLargeStep != 0;
    for (const Call& call : calls()) {
      if (call.is_long && is_left_out) continue;
      const ScratchFolder scratch;
      CAPTURE(file, call.command, call.options);
      const std::string arguments = fmt::format("'{}' -q {} -o {}", file.string(), call.options, scratch / call.output);
      const CommandResult result = run_command(call.command, arguments);
      CAPTURE(result.err);
      CHECK(result.out.empty());
      ++runs;
      if (result.exit_code == 0) {
        CHECK(result.err.empty());
        CHECK(!std::filesystem::is_empty(scratch / ""));
        continue;
      }
      ++refused;
      CHECK(std::count(call.refusals.begin(), call.refusals.end(), result.exit_code) == 1);
      CHECK(std::count(result.err.begin(), result.err.end(), '\n') == 1);
      CHECK(std::filesystem::is_empty(scratch / ""));
    }
  }
  CHECK(5 * refused <= runs);
  std::cout << runs << " runs, " << refused << " refused\n";
}

}  // namespace gvd::test_corpus_commands
