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

/// What holds curves without a surface and, of the formats with one, those that draw lines beside it.
constexpr Content kPaths = Content::curves | Content::paths, kIsolines = Content::curves | Content::isolines;

const std::vector<std::string> kFormats =
    output_extensions(Content::distances | Content::rows | Content::targets | kPaths | kIsolines);

struct OwnOptions : Options {
  DistancesCall call;
};

void describe_own(OptionList& list, OwnOptions& own) {
  own.has_diagram = false;
  own.output.prints = true;
  describe_input(list, own.input);
  describe(list, own.call);
  describe_resources(list, own.compute);
  describe_output(list, own.output, kFormats, "npy");
}

/// Where no file is named, standard output has a text that a script reads as it is, or else the simplest format that
/// holds all.
void complete(OwnOptions& own, const Given& given) {
  if (names_file(own.output)) return;
  if (!given.has("output_format")) own.output.formats = {own.call.isolines ? "json" : own.call.paths ? "csv" : "txt"};
  own.output.files = {"-"};
}

[[noreturn]] void refuse_use(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

/// The first of the written formats that carries any of `any`, but nothing of `none`. Null: there is none.
const Format* find_written(const OutputOptions& output, Content any, Content none = Content::nothing) {
  for (const std::string& format : written_formats(output)) {
    const Format* const row = find_output(format);
    if (row != nullptr && has_any(row->carries, any) && !has_any(row->carries, none)) return row;
  }
  return nullptr;
}

/// "-o p.obj: .obj", the file that has this format, for messages.
std::string named(const OutputOptions& output, const Format& format) {
  const std::string& name = format.extensions.front();
  for (const std::string& file : output.files) {
    if (file != "-" && format_of(output, file) == name) return fmt::format("-o {}: .{}", file, name);
  }
  return fmt::format("--output-format {0}: .{0}", name);
}

/// The formats to write instead.
std::string list_formats(Content any, Content none = Content::nothing) {
  return list_extensions(output_extensions(any, none), "or");
}

/// Refuses a mesh or a text that would hold nothing of what was asked for.
void check_content(const Options& options, const DistancesCall& own) {
  const OutputOptions& output = options.output;
  const bool has_targets = own.targets.are_listed(), has_curves = own.paths || own.isolines;
  constexpr Content kDistances = Content::distances | Content::rows;
  if (const Format* const lines = find_written(output, Content::curves, kDistances); lines != nullptr && !has_curves) {
    refuse_use(has_targets
                   ? fmt::format("{} holds no distances; add {{option:paths}} for the shortest paths, or write {}",
                                 named(output, *lines), list_formats(Content::targets))
                   : fmt::format("{} holds no distances; write {}, or add {{option:isolines}}", named(output, *lines),
                                 list_formats(kDistances)));
  }
  const bool has_report = !output.report.empty() || !output.view.empty();
  const Format* const mesh = find_written(output, Content::distances, Content::targets);
  if (has_targets && !has_curves && !has_report && mesh != nullptr && !writes(output, Content::targets)) {
    refuse_use(
        fmt::format("{} has the distances of all vertices, for which {{option:to}} does nothing; {}write {}, or leave "
                    "{{option:to}} out",
                    named(output, *mesh), has_any(mesh->carries, Content::curves) ? "add {option:paths}, " : "",
                    list_formats(Content::targets)));
  }
  if (own.paths && !has_report && !writes(output, kPaths)) {
    refuse_use(fmt::format("{{option:paths}}: {} paths; write one of them or leave {{option:paths}} out",
                           only_formats(kPaths, {"{option:view}", "{option:report}"})));
  }
}

/// Refuses options that contradict each other or have no effect.
void check(const Options& options, const DistancesCall& own) {
  const OutputOptions& output = options.output;
  const bool has_targets = own.targets.are_listed(), has_view = !output.view.empty();
  if (own.each && has_view)
    refuse_use("{option:each} and {option:view} exclude each other: the page shows the nearest source");
  const Format* const values = find_written(output, Content::distances, Content::surface);
  if (has_targets && values != nullptr) {
    refuse_use(fmt::format("{{option:to}}: {} hold a distance for each vertex; write {}, or leave {{option:to}} out",
                           list_extensions(output_extensions(Content::distances, Content::surface), "and"),
                           list_formats(Content::targets)));
  }
  const Format* const single = find_written(output, Content::distances, Content::rows);
  if (own.each && single != nullptr && !(own.paths && has_any(single->carries, Content::surface))) {
    refuse_use(fmt::format(
        "{{option:each}}: {} hold one distance for each vertex; write {}{}",
        list_extensions(output_extensions(Content::distances, Content::rows), "and"), list_formats(Content::rows),
        has_any(single->carries, Content::surface) ? ", or add {option:to} and {option:paths}" : ""));
  }
  if (own.isolines && !has_view && output.report.empty() && !writes(output, kIsolines)) {
    refuse_use(fmt::format("{{option:isolines}}: {} curves; write one of them or leave {{option:isolines}} out",
                           only_formats(kIsolines, {"{option:view}", "{option:report}"})));
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

Command distance_command() {
  return make_command<OwnOptions>(
      {"gvd-distance",
       "Measures exact distances on a triangle mesh from given points, with shortest paths and isolines.",
       kExamples,
       {kFormats, false}},
      {describe_own, measure, complete});
}

}  // namespace gvd::app
