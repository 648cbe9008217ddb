// gvd-paper: the measurements of section 5 of the paper, as one JSON document that scripts/make_paper.py makes pages
// of.
//
//   gvd-paper [--runs 3] [--models FOLDER...] [--tables 1,4] [--scale 1] -o FILE.json
//
// Models that no folder has are replaced by data/figure.obj. Times are processor times of one thread. The document has
// "runs", "scale" and "tables": for each key of list_tables a list of rows. A table that was not asked for is missing,
// and the script then refuses to make pages. --scale below 1 is for tests: it makes all meshes coarser.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "command_line.hpp"
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
  bench::add_positive(app, "--runs", settings.runs, "runs, each with generators of another seed");
  app.add_option("--models", settings.folders, "folders with meshes that this repository does not have")
      ->check(CLI::ExistingDirectory);
  std::vector<std::string> keys;
  for (const Table& table : list_tables()) keys.push_back(table.key);
  bench::add_choice(app, "--tables", settings.tables, keys, "tables to measure (default: all)");
  app.add_option("--scale", settings.scale, "multiplies the paper's numbers of faces")->check(CLI::Range(0.01, 1.0));
  app.add_option("-o,--output", settings.output, "the JSON document")->required();
}

nlohmann::json measure_tables(const Settings& settings) {
  const auto report = [](const std::string& title) { std::cerr << fmt::format("gvd-paper: {}\n", title); };
  const Evaluation evaluation{Models(settings.folders, settings.scale), settings.runs, report};
  nlohmann::json tables = nlohmann::json::object();
  for (const Table& table : list_tables()) {
    const bool is_chosen = settings.tables.empty() || bench::contains(settings.tables, table.key);
    if (is_chosen) tables[table.key] = table.measure(evaluation);
  }
  return {{"runs", settings.runs}, {"scale", settings.scale}, {"tables", std::move(tables)}};
}

int run(int argc, char** argv) {
  Settings settings;
  CLI::App app("Measures the tables of the paper's section 5");
  read_arguments(app, settings);
  CLI11_PARSE(app, argc, argv);
  bench::write_file(settings.output, measure_tables(settings).dump(1) + "\n");
  return 0;
}

}  // namespace
}  // namespace gvd::paper

int main(int argc, char** argv) { return gvd::bench::run_program("gvd-paper", gvd::paper::run, argc, argv); }
