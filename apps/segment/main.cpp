// gvd-segment: labels the faces of a mesh, or cuts them along the bisectors.
//
// The library does the work (gvd/segment_operation.hpp). This file has the outputs.

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/load_input.hpp"
#include "common/options/shared_options.hpp"
#include "common/referred_files.hpp"
#include "common/run_parts.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "gvd/segment_operation.hpp"

namespace gvd::app {
namespace {

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view a.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < a.ply > b.ply\n"
    "  gvd-segment bunny.obj -n 350 --balance area --cut -o equal.ply\n"
    "  gvd-segment bunny.obj -n 20 --disc --uv flat -o charts.glb\n"
    "  gvd-segment scans/*.stl -n 30 --output-dir regions --output-format ply,json\n";

/// A million generators on 5,876 faces took 27 s of processor time and 3.6 GB.
constexpr GeneratorCost kGeneratorCost{27, 3.6};

const std::vector<std::string> kFormats = output_extensions(SegmentOutcome::kContent);

/// The formats of an output of numbers: arrays, tables, and formats that hold nothing but such numbers of vertices.
std::vector<std::string> array_formats(Content numbers) {
  std::vector<std::string> found{"npy", "csv"};
  for (const Format& format : formats()) {
    const bool is_alone = has_any(format.carries, numbers) && !has_any(format.carries, Content::surface);
    if (format.write != nullptr && is_alone) {
      found.insert(found.end(), format.extensions.begin(), format.extensions.end());
    }
  }
  return found;
}

struct SegmentCommandOptions : Options {
  SegmentCall call;
  std::string face_labels, vertex_labels, vertex_distances, stats, adjacency;  ///< files; empty: none
};

void describe_targets(OptionList& list, SegmentCommandOptions& own) {
  const auto add = [&](const char* name, std::string& file, std::vector<std::string> extensions, Spec spec) {
    describe_target(list, own.output, name, file, extensions, std::move(spec));
  };
  add("face_labels", own.face_labels, {"npy", "csv"},
      {.help = "Write the label of each face, in the order of the faces in .ply (-1 for none)"});
  add("vertex_labels", own.vertex_labels, array_formats(Content::vertex_labels),
      {.help = "Write the nearest generator of each vertex, in the order of the vertices in .ply (-1 for none)"});
  add("vertex_distances", own.vertex_distances, array_formats(Content::distances),
      {.help = "Write the distance of each vertex from its generator, in the order of the vertices in .ply",
       .more = "; .csv has the generators, too"});
  add("stats", own.stats, {"csv"},
      {.help = "Write the area, perimeter, radius and neighbours of each region (CSV)", .shown = Shown::main});
  add("adjacency", own.adjacency, {"graphml"},
      {.help = "Write the graph of the regions: their areas, and the length of each border (GraphML)"});
}

void describe_own(OptionList& list, SegmentCommandOptions& own) {
  describe_input(list, own.input);
  describe(list, own.call);
  describe_generators_format(list, own.input);
  describe_resources(list, own.compute);
  describe_verify(list, own.compute);
  describe_output(list, own.output, kFormats, "ply");
  describe_no_curves(list, own.output);
  describe_diagram_output(list, own.output);
  describe_targets(list, own);
  list.group("Output");
  list.option("region_materials", Flag{&own.output.region_materials},
              {.help = "Give each region a material of its own in .obj also where \1input\2 has materials",
               .more = ", in place of these"});
  list.excludes("curves", {"verify"});
  ValueRule charts = format_rule(own.output, "uv", output_extensions(Content::texture),
                                 fmt::format("\1uv\2: {} texture coordinates; write one, such as "
                                             "\1output=FILE.obj\2, or leave it out",
                                             only_formats(Content::texture)));
  charts.why_idle = [&own, why_lost = std::move(charts.why_idle)](const Given& given) {
    const bool has_figures = !own.stats.empty() || !own.output.report.empty();  // figures of the charts
    return has_figures || written_formats(own.output).empty() ? "" : why_lost(given);
  };
  list.rule(std::move(charts));
  list.rule(format_rule(own.output, "region_materials", output_extensions(Content::materials),
                        fmt::format("\1region_materials\2: {} materials; write one, as in "
                                    "\1output=FILE.obj\2, or leave it out",
                                    only_formats(Content::materials))));
}

void complete(SegmentCommandOptions& own, const Given&) { own.call.complete(); }

/// Writes the labels of the faces and vertices, and the distances of the vertices, each as an array, as a table, or in
/// a format that holds nothing else. With levels, each face has the labels of all levels.
void write_arrays(Run& run, const LabelledMesh& output) {
  const DistanceTable distances{.rows = {output.vertex_distance->raw()}, .nearest = output.vertex_label->raw()};
  const auto write = [&](const char* option, const OutputWriter& write_npy, const OutputWriter& write_csv) {
    write_own_file(run, option, [&](std::ostream& out) {
      const std::string extension = file_extension(*run.options().output.own.at(option));
      if (extension == "csv") return write_csv(out);
      const auto format = parse_output_format(extension);
      format ? write_mesh(out, output, *format) : write_npy(out);
    });
  };
  const auto write_labels = [&](const char* option, const std::vector<GeneratorId>& labels, const char* element) {
    write(
        option, [&](std::ostream& out) { write_labels_npy(out, labels); },
        [&](std::ostream& out) { write_labels_csv(out, labels, element); });
  };
  std::vector<FaceNumbers> levels;
  std::ranges::copy_if(*output.face_numbers, std::back_inserter(levels),
                       [](const FaceNumbers& n) { return n.name != kRegionName; });
  if (!levels.empty()) {
    write(
        "face_labels", [&](std::ostream& out) { write_levels_npy(out, levels); },
        [&](std::ostream& out) { write_levels_csv(out, levels); });
  } else {
    write_labels("face_labels", output.face_label->raw(), "face");
  }
  write_labels("vertex_labels", output.vertex_label->raw(), "vertex");
  write(
      "vertex_distances", [&](std::ostream& out) { write_distances_npy(out, distances); },
      [&](std::ostream& out) { write_distances_csv(out, distances); });
}

void write_files(Run& run, const SegmentOutcome& made) {
  const LabelledMesh output = made.labelled().value();
  write_arrays(run, output);
  write_output_files(run, made);
  write_view_file(run, "gvd-segment", [&] {
    std::vector<ViewScene> scenes = make_region_scenes(output);
    for (ViewScene& scene : scenes) scene.borders = made.borders();
    return scenes;
  });
  write_diagram_file(run, made.input().mesh, made.diagram->diagram());
}

/// Notes, only once for all inputs, that the page and a mesh of whole faces show different borders.
void note_whole_faces(Run& run, const SegmentCommandOptions& own) {
  const OutputOptions& output = run.options().output;
  const InputOptions& input = run.options().input;
  if (own.call.cut || run.options().given->has("labels") || output.view.empty() || input.path != input.paths.front())
    return;
  for (const std::string& file : output.files) {
    const Format* const format = find_output(format_of(output, file));
    if (format == nullptr || !has_any(format->carries, Content::surface)) continue;
    return run.note(fmt::format("{} shows the exact borders, and {} has whole faces; \1cut\2 splits them", output.view,
                                file == "-" ? "standard output" : file));
  }
}

void segment(Run& run, SegmentCommandOptions& own) {
  const MeshPtr input = load_input(run);
  check_material_files(run, input->appearance, own.call.uv.has_value());
  note_many_generators(run, input->mesh, own.call.generators.wanted().value_or(0), kGeneratorCost);
  const auto made = run_operation(run, input, own.call);
  const Diagram& diagram = made->of_surface();
  report_figures(run, *made);
  report_generators(run, input->mesh, diagram.generators, made->snap_distance);
  run.report().set_diagram(diagram);
  write_files(run, *made);
  note_whole_faces(run, own);
  write_own_file(run, "stats", [&](std::ostream& out) {
    const Charts* const charts = made->charts ? &*made->charts : nullptr;
    write_statistics_csv(out, compute_region_statistics(made->surface(), diagram), charts);
  });
  write_own_file(run, "adjacency", [&](std::ostream& out) {
    write_adjacency_graphml(out, made->surface(), diagram.generators,
                            compute_region_statistics(made->surface(), diagram));
  });
  finish_run(run, made->surface(), diagram);
}

}  // namespace

Command segment_command() {
  return make_command<SegmentCommandOptions>(
      {"gvd-segment",
       "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
       kExamples,
       {kFormats}},
      {describe_own, segment, complete});
}

}  // namespace gvd::app
