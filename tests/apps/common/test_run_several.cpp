#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>

#include "apps/run_command.hpp"
#include "common/process.hpp"
#include "common/run_several.hpp"
#include "gvd/error.hpp"
#include "support/catch.hpp"

namespace gvd::test_run_several {

using namespace app;

std::vector<Options> quiet_runs(const std::vector<std::string>& inputs) {
  std::vector<Options> runs;
  for (const std::string& input : inputs) {
    runs.emplace_back().input.path = input;
    runs.back().general.quiet = true;
  }
  return runs;
}

TEST_CASE("a run that fails does not stop the others, and the first failure is the exit code") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b", "c"}), [&](Run& run) {
    const std::string& input = run.options().input.path;
    gvd::test::write_text(scratch / input, input);
    if (input == "a") throw Error(ErrorCode::precondition, "a: refused by a test");
    if (input == "b") throw Error(ErrorCode::unreadable_input, "b: refused by a test");
  });
  for (const char* input : {"a", "b", "c"}) CHECK(gvd::test::read_text(scratch / input) == input);
  CHECK(code == 4);
  CHECK(run_several("gvd-test", quiet_runs({"a"}), [](Run&) {}) == 0);
}

TEST_CASE("a run without memory does not end the others, and has let go of its own") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  std::vector<Options> runs = quiet_runs({"a", "b"});
  for (Options& options : runs) {
    if (!test::kSanitized) options.compute.max_memory = peak_memory_bytes() + (256 << 20);
  }
  CHECK(run_several("gvd-test", runs, [&](Run& run) {
          const std::string& input = run.options().input.path;
          if (input == "a") throw std::bad_alloc();
          const std::string kept(std::size_t{70} << 20, 'x');
          gvd::test::write_text(scratch / input, input);
        }) == 5);
  CHECK(gvd::test::read_text(scratch / "b") == "b");
}

TEST_CASE("an interruption ends all runs") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b"}), [&](Run& run) {
    gvd::test::write_text(scratch / run.options().input.path, "seen");
    std::raise(SIGINT);
    check_interrupt();
  });
  CHECK(code == 130);
  CHECK(gvd::test::read_text(scratch / "a") == "seen");
  CHECK(gvd::test::read_text(scratch / "b").empty());
  install_signal_handlers();
}

TEST_CASE("runs that an interruption leaves out are not done, even if the last one was") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const int code = run_several("gvd-test", quiet_runs({"a", "b"}), [&](Run& run) {
    gvd::test::write_text(scratch / run.options().input.path, "seen");
    std::raise(SIGINT);
  });
  CHECK(code == 130);
  CHECK(gvd::test::read_text(scratch / "b").empty());
  install_signal_handlers();
}

TEST_CASE("results stand in columns, with a column for each figure that a run has") {
  const Cells relaxed{{"diagram.cells", "30"}, {"results.final_energy", "1.5"}};
  const std::vector<RunResult> results{{"a.ply", "done", 0.125, 0, "", relaxed},
                                       {"long-name.ply", "failed (3: unreadable input)", 12}};
  CHECK(format_results(results) ==
        std::vector<std::string>{"input          result                        generators  energy     time",
                                 "a.ply          done                                  30     1.5   0.12 s",
                                 "long-name.ply  failed (3: unreadable input)           -       -  12.00 s"});
  const Cells verified{{"diagram.cells", "1"}, {"diagram.verify.error_integral", "0.5"}};
  const std::vector<std::string> plain = format_results({{"a", "done", 0, 0, "", verified}});
  CHECK(plain.front() == "input  result  generators    E    time");
  CHECK(format_results({{"a", "done", 0}}).front() == "input  result    time");  // gvd-distance
}

TEST_CASE("a summary has the columns of all runs, quotes fields, and names inputs that have not run") {
  const std::vector<RunResult> results{{"a", "done", 0.5, 0, "", {{"input.faces", "4"}, {"results.stop", "x,\"y"}}},
                                       {"b,c", "failed", 0, 3, "two\nlines", {}},
                                       {"d", "done", 1, 0, "", {{"input.faces", "8"}, {"results.late", "true"}}}};
  CHECK(format_summary({"a", "b,c", "d", "e"}, results) ==
        "input,exit_code,error,input.faces,results.stop,results.late,seconds\n"
        "a,0,,4,\"x,\"\"y\",,0.500\n"
        "\"b,c\",3,\"two\nlines\",,,,0.000\n"
        "d,0,,8,,true,1.000\n"
        "e,,not run,,,,\n");
  CHECK(format_summary({"a"}, {}) == "input,exit_code,error,seconds\na,,not run,\n");
}

TEST_CASE("the summary grows by a row after each run, and is written anew for a new column") {
  install_signal_handlers();
  const gvd::test::ScratchFolder scratch;
  const std::string table = scratch / "all.csv";
  std::vector<Options> runs = quiet_runs({"a", "b", "c", "d"});
  for (Options& options : runs) {
    options.output.summary = table;
    options.input.paths = {"a", "b", "c", "d"};
  }
  std::vector<std::string> seen;
  const int code = run_several("gvd-test", runs, [&](Run& run) {
    const std::string& input = run.options().input.path;
    if (input != "a") seen.push_back(gvd::test::read_text(table));
    if (input == "b") std::ofstream(table, std::ios::app) << "mark\n";
    run.report().at("results")[input == "c" ? "late" : "n"] = 7;
    if (input == "c") std::raise(SIGINT);
  });
  CHECK(code == 130);
  REQUIRE(seen.size() == 2);
  const std::string before = seen[0].substr(0, seen[0].rfind(','));
  CHECK(before == "input,exit_code,error,results.n,seconds\na,0,,7");
  CHECK(seen[1].starts_with(seen[0] + "mark\nb,0,,7,"));  // appended
  const std::string all = gvd::test::read_text(table);
  CHECK(all.starts_with("input,exit_code,error,results.n,results.late,seconds\na,0,,7,,"));
  CHECK(all.ends_with("\nd,,not run,,,\n"));
  CHECK(std::count(all.begin(), all.end(), '\n') == 5);
  install_signal_handlers();
  CHECK(run_several("gvd-test", runs, [&](Run&) { std::filesystem::remove(table); }) == 0);
  const std::string again = gvd::test::read_text(table);
  CHECK(std::count(again.begin(), again.end(), '\n') == 5);
}

TEST_CASE("figures of a report are its numbers, texts and truth values, without lists and nulls") {
  RunReport report("gvd-test", {});
  report.at("results") = {
      {"faces", 3}, {"list", {1, 2}}, {"none", nullptr}, {"bad", NAN}, {"deep", {{"ok", true}, {"stop", "x"}}}};
  CHECK(list_figures(report) == Cells{{"results.faces", "3"}, {"results.deep.ok", "true"}, {"results.deep.stop", "x"}});
}

TEST_CASE("columns are as wide as the letters in them, whatever bytes these take") {
  const Cells one{{"diagram.cells", "1"}};
  const auto lines = format_results({{"\u00fc.off", "done", 0, 0, "", one}, {"ab.off", "done", 0, 0, "", one}});
  CHECK(lines[1] == "\u00fc.off   done             1  0.00 s");
  CHECK(lines[2] == "ab.off  done             1  0.00 s");
}

}  // namespace gvd::test_run_several
