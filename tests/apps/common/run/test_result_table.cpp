#include "common/run/result_table.hpp"
#include "support/catch.hpp"

namespace gvd::test_result_table {

using namespace app;

TEST_CASE("results stand in columns, with a column for each figure that a run has") {
  const std::vector<RunResult> results{{"a.ply", "done", {30, std::nullopt, 1.5}, 0.125},
                                       {"long-name.ply", "failed (3: unreadable input)", {}, 12}};
  CHECK(format_results(results) ==
        std::vector<std::string>{"input          result                        regions  energy     time",
                                 "a.ply          done                               30     1.5   0.12 s",
                                 "long-name.ply  failed (3: unreadable input)        -       -  12.00 s"});
  const std::vector<std::string> plain = format_results({{"a", "done", {1, 0.5, std::nullopt}, 0}});
  CHECK(plain.front() == "input  result  regions    E    time");
}

TEST_CASE("columns are as wide as the letters in them, whatever bytes these take") {
  const auto lines = format_results({{"\u00fc.off", "done", {1, {}, {}}, 0}, {"ab.off", "done", {1, {}, {}}, 0}});
  CHECK(lines[1] == "\u00fc.off   done          1  0.00 s");
  CHECK(lines[2] == "ab.off  done          1  0.00 s");
}

}  // namespace gvd::test_result_table
