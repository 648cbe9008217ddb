// gvd-distance: exact distances on the surface from points of a list, shortest paths, and isolines.
//
// The library measures (gvd/distances_operation.hpp). Files hold the table of distances, or the mesh with those of its
// vertices; paths and isolines go where curves fit.

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/options/shared_options.hpp"
#include "common/run_observer.hpp"
#include "common/run_parts.hpp"
#include "gvd/barriers.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/error.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/unreached_points.hpp"

namespace gvd::app {
namespace {

constexpr const char* kExamples =
    "  gvd-distance bunny.obj --from 17 --to 90\n"
    "  gvd-distance bunny.obj --from 17 -o distances.npy\n"
    "  gvd-distance bunny.obj --from 17 --to 90,4000 --paths -o paths.vtp --view a.html\n"
    "  gvd-distance bunny.obj --from seeds.csv --isolines 0.05 -o curves.obj\n"
    "  gvd-distance scan.stl --from seeds.txt --each --max-distance 40 -o rows.npy\n";

const std::vector<std::string> kFormats{"npy", "csv", "ply", "vtp", "vtu", "obj", "json", "shape.gii", "curv", "txt"};

struct OwnOptions : Options {
  DistancesCall call;
};

void describe_own(OptionList& list, OwnOptions& own) {
  own.has_diagram = false;
  own.output.prints = true;
  describe_input(list, own.input);
  describe(list, own.call);
  list.group("Computing");
  describe_resources(list, own.compute);
  describe_output(list, own.output, kFormats);
}

/// Where no file is named, standard output has a text that a script reads as it is, or else the simplest format that
/// holds all.
void complete(OwnOptions& own, const Given& given) {
  if (names_file(own.output)) return;
  if (!given.has("output_format")) own.output.formats = {own.call.isolines ? "json" : own.call.paths ? "csv" : "txt"};
  own.output.files = {"-"};
}

bool writes(const Options& options, const std::vector<std::string>& formats) {
  const std::vector<std::string> written = written_formats(options.output);
  return std::any_of(written.begin(), written.end(), [&](const std::string& f) { return contains(formats, f); });
}

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// The file of -o that has this format, for messages.
std::string named(const OutputOptions& output, const std::string& format) {
  for (const std::string& file : output.files) {
    if (file != "-" && format_of(output, file) == format) return "-o " + file;
  }
  return "--output-format " + format;
}

/// Refuses a mesh or a text that would hold nothing of what was asked for.
void check_content(const Options& options, const DistancesCall& own) {
  const OutputOptions& output = options.output;
  const bool has_targets = own.targets.are_listed(), has_curves = own.paths || own.isolines;
  if (!has_curves && writes(options, {"obj"})) {
    refuse(has_targets
               ? fmt::format("{}: .obj holds no distances; add --paths for the shortest paths, or write .csv, .npy or "
                             ".json",
                             named(output, "obj"))
               : fmt::format("{}: .obj holds no distances; write .ply, .vtp, .csv, .npy or .json, or add --isolines",
                             named(output, "obj")));
  }
  const bool holds_targets =
      !output.report.empty() || !output.view.empty() || writes(options, {"npy", "csv", "json", "txt"});
  for (const char* format : {"ply", "vtp", "vtu"}) {
    if (!has_targets || has_curves || holds_targets || !writes(options, {format})) continue;
    refuse(
        fmt::format("{}: .{} has the distances of all vertices, for which --to does nothing; {}write .csv, .npy or "
                    ".json, or leave --to out",
                    named(output, format), format, format == std::string("ply") ? "" : "add --paths, "));
  }
  if (own.paths && !writes(options, {"csv", "json", "obj", "vtp", "vtu"}) && output.report.empty() &&
      output.view.empty()) {
    refuse(
        "--paths: only .csv, .json, .obj, .vtp, .vtu, --view and --report hold paths; write one of them or leave "
        "--paths out");
  }
}

/// Refuses options that contradict each other or have no effect.
void check(const Options& options, const DistancesCall& own) {
  const bool has_targets = own.targets.are_listed(), has_view = !options.output.view.empty();
  if (own.paths && !has_targets)
    refuse("--paths does nothing here: add --to, where the paths begin, or leave --paths out");
  if (own.each && own.isolines) refuse("--each and --isolines exclude each other: isolines are of the nearest source");
  if (own.each && has_view) refuse("--each and --view exclude each other: the page shows the nearest source");
  if (own.each && !own.paths && writes(options, {"ply", "vtp", "vtu", "obj"})) {
    refuse(
        "--each: .ply, .vtp, .vtu and .obj hold one distance for each vertex; write .npy, .csv or .json, or add --to "
        "and "
        "--paths");
  }
  if (has_targets && writes(options, {"shape.gii", "curv"})) {
    refuse("--to: .shape.gii and .curv hold a distance for each vertex; write .npy, .csv or .json, or leave --to out");
  }
  if (own.each && writes(options, {"curv"})) {
    refuse("--each: .curv holds one distance for each vertex; write .shape.gii, .npy, .csv or .json");
  }
  const bool holds_curves =
      has_view || !options.output.report.empty() || writes(options, {"obj", "vtp", "vtu", "json"});
  if (own.isolines && !holds_curves) {
    refuse(
        "--isolines: only .obj, .vtp, .vtu, .json, --view and --report hold curves; write one of them or leave "
        "--isolines "
        "out");
  }
  check_content(options, own);
}

/// The part of the machine's memory that a table may take: it is computed and written beside other things.
constexpr double kMemoryShare = 0.5;

double most_table_bytes(const ComputeOptions& compute) {
  const double machine = kMemoryShare * double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  return std::min(machine, double(compute.max_memory.value_or(INT64_MAX)));
}

/// Notes the first distances to the points of --to, and why the others are infinite.
void note_targets(RunObserver& observer, const DistancesOutcome& made, bool are_printed) {
  const DistanceTable& table = made.table;
  const std::size_t all = table.rows.size() * table.targets.size();
  if (all == 0) return;
  if (are_printed) {  // on standard output
    if (all <= kToldDistances && made.unreached > 0) observer.note(describe_unreached(made));
    return;
  }
  UnreachedPoints unreached(made);
  std::size_t told = 0;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    for (std::size_t i = 0; i < table.targets.size() && told < kToldDistances; ++i, ++told) {
      const double distance = table.rows[row][i];
      const std::string target = table.target_name(i);
      observer.note(std::isfinite(distance)
                        ? fmt::format("{} is {:.9g} from {}", target, distance, table.source_name(table.source(row, i)))
                        : fmt::format("{} is not reached from {}: it is {}", target,
                                      table.nearest.empty() ? table.source_name(GeneratorId(row)) : "any source",
                                      describe(unreached.find(row, i), unreached.inside())));
    }
  }
  if (told < all) observer.note(fmt::format("... and {} more", all - told));
}

void measure(Run& run, OwnOptions& own) {
  check(run.options(), own.call);
  const auto input = std::make_shared<CheckedMesh>(load_input(run));
  own.call.most_bytes = most_table_bytes(own.compute);
  const auto made = [&] {
    RunObserver observer(run);
    auto measured = gvd::run(input, own.call, observer);
    note_targets(observer, *measured, contains(run.options().output.files, "-"));
    return measured;
  }();
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
}  // namespace gvd::app

int main(int argc, char** argv) {
  using namespace gvd::app;
  return run_command<OwnOptions>(
      {"gvd-distance",
       "Measures exact distances on a triangle mesh from given points, with shortest paths and isolines.",
       kExamples,
       {kFormats, false}},
      {describe_own, measure, complete}, argc, argv);
}
