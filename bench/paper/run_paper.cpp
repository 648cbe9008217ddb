// gvd-paper: the measurements of section 5 of the paper, as one JSON document that scripts/make_paper.py makes pages
// of.
//
//   gvd-paper [--runs 3] [--models FOLDER...] [--tables 1,4] [--scale 1] -o FILE.json
//
// Models that no folder has are replaced by data/figure.obj. Times are processor times of one thread.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fstream>
#include <iostream>

#include "command_line.hpp"
#include "gvd/error.hpp"
#include "tables.hpp"

namespace gvd::paper {
namespace {

struct Settings {
  std::vector<std::string> folders;
  std::vector<std::string> tables;
  std::string output;
  int runs = 3;
  double scale = 1;
};

void read_arguments(CLI::App& app, Settings& settings) {
  app.add_option("--runs", settings.runs, "runs, each with generators of another seed")->check(CLI::PositiveNumber);
  app.add_option("--models", settings.folders, "folders with meshes that this repository does not have")
      ->check(CLI::ExistingDirectory);
  std::vector<std::string> keys;
  for (const Table& table : list_tables()) keys.push_back(table.key);
  app.add_option("--tables", settings.tables, "tables to measure (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember(keys));
  app.add_option("--scale", settings.scale, "multiplies the paper's numbers of faces")->check(CLI::Range(0.01, 1.0));
  app.add_option("-o,--output", settings.output, "the JSON document")->required();
}

nlohmann::json measure_tables(const Settings& settings) {
  const auto report = [](const std::string& title) { std::cerr << fmt::format("gvd-paper: {}\n", title); };
  const Evaluation evaluation{Models(settings.folders, settings.scale), settings.runs, report};
  nlohmann::json tables = nlohmann::json::object();
  for (const Table& table : list_tables()) {
    const auto& chosen = settings.tables;
    if (chosen.empty() || std::find(chosen.begin(), chosen.end(), table.key) != chosen.end()) {
      tables[table.key] = table.measure(evaluation);
    }
  }
  return {{"runs", settings.runs}, {"scale", settings.scale}, {"tables", std::move(tables)}};
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Measures the tables of the paper's section 5");
  read_arguments(app, settings);
  CLI11_PARSE(app, argc, argv);
  const nlohmann::json document = measure_tables(settings);
  std::ofstream file(settings.output);
  file << document.dump(1) << "\n";
  if (!file.flush()) throw Error(ErrorCode::unwritable_output, fmt::format("could not write {}", settings.output));
  return 0;
}

}  // namespace
}  // namespace gvd::paper

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-paper", gvd::paper::run, argc, argv); }
