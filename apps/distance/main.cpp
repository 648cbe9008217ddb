// gvd-distance: exact distances on the surface from points of a list, shortest paths, and isolines.
//
// The library measures (gvd/distances_operation.hpp). Files hold the table of distances, or the mesh with the distances
// of its vertices; paths and isolines go into formats that can hold curves.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/load_input.hpp"
#include "common/options/shared_options.hpp"
#include "common/run_parts.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/io/distance_writer.hpp"

namespace gvd::app {
namespace {

constexpr const char* kExamples =
    "  gvd-distance bunny.obj --from 17 --to 90\n"
    "  gvd-distance bunny.obj --from 17 -o distances.npy\n"
    "  gvd-distance bunny.obj --from 17 --to 90,4000 --paths -o paths.vtp --view a.html\n"
    "  gvd-distance bunny.obj --from seeds.csv --isolines 0.05 -o curves.obj\n"
    "  gvd-distance scan.stl --from seeds.txt --each --max-distance 40 -o rows.npy\n";

const std::vector<std::string> kFormats = output_extensions(DistancesOutcome::kContent);

struct DistanceCommandOptions : Options {
  DistancesCall call;
};

void describe_own(OptionList& list, DistanceCommandOptions& own) {
  own.has_diagram = false;
  own.output.prints = true;
  describe_input(list, own.input);
  describe(list, own.call);
  describe_resources(list, own.compute);
  describe_output(list, own.output, kFormats, "npy");
  list.excludes("each", {"view"}, "the page shows the nearest source");
}

/// If no file is named, chooses the format of standard output: plain text for scripts, or otherwise the simplest format
/// that holds all results.
void complete(DistanceCommandOptions& own, const Given& given) {
  if (names_file(own.output)) return;
  if (!given.has("output_format")) own.output.formats = {own.call.isolines ? "json" : own.call.paths ? "csv" : "txt"};
  own.output.files = {"-"};
}

/// Checks that the outputs together hold all results. Messages call a file by the option that decides on its format.
void check_written(const OutputOptions& output, const DistancesCall& call) {
  std::vector<WrittenFile> files;
  for (const std::string& format : written_formats(output)) {
    const auto has_it = [&](const std::string& file) { return file != "-" && format_of(output, file) == format; };
    const auto file = std::ranges::find_if(output.files, has_it);
    const bool is_named = output.folder.empty() && file != output.files.end();
    const std::string name = is_named ? placeholder("output", *file) : placeholder("output_format", format);
    if (const Format* const row = find_output(format)) files.push_back({name, row});
  }
  check_files(asked_of(call), files, {"\1view\2", "\1report\2"}, !output.report.empty() || !output.view.empty());
}

/// The share of the machine's memory that a table may take, because there are other data beside it.
constexpr double kMemoryShare = 0.5;

double most_table_bytes(const ComputeOptions& compute) {
  const double machine = kMemoryShare * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  return std::min(machine, double(compute.max_memory.value_or(INT64_MAX)));
}

/// Notes the first distances to the points of --to, unless they go to standard output, and why distances are infinite.
void note_targets(Run& run, const DistancesOutcome& made) {
  const std::size_t all = made.table.rows.size() * made.table.targets.size();
  if (contains(run.options().output.files, "-")) {
    if (all > 0 && all <= kToldDistances && made.unreached > 0) run.note(describe_unreached(made));
    return;
  }
  for (const std::string& line : describe_targets(made)) run.note(line);
}

void measure(Run& run, DistanceCommandOptions& own) {
  check_written(run.options().output, own.call);
  const MeshPtr input = load_input(run);
  own.call.most_bytes = most_table_bytes(own.compute);
  const auto made = run_operation(run, input, own.call);
  note_targets(run, *made);
  report_figures(run, *made);
  report_generators(run, input->mesh, made->table.sources, made->snap_distance);
  write_output_files(run, *made);
  if (made->field) {
    write_view_file(run, "gvd-distance", [&] {
      std::vector scenes{make_distance_scene("Distances", made->surface(), *made->field, made->table)};
      for (const GeneratorCurve& curve : made->curves) {
        for (auto& line : polylines(made->surface(), curve)) scenes[0].paths.push_back(std::move(line));
      }
      return scenes;
    });
  }
  write_report(run);
}

}  // namespace

Command distance_command() {
  return make_command<DistanceCommandOptions>(
      {"gvd-distance",
       "Measures exact distances on a triangle mesh from given points, with shortest paths and isolines.",
       kExamples,
       {kFormats, false}},
      {describe_own, measure, complete});
}

}  // namespace gvd::app
