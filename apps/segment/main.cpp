// gvd-segment: labels the faces of a mesh, or cuts them along the bisectors.
//
// Whole faces get the label of the generator whose cell has them, so that borders run along edges; --cut splits the
// faces along the bisectors, and each new face knows its parent (gvd/segment.hpp). The report has the figures of the
// regions, and notes tell what users should not miss: generators that own no face, and faces that none reaches.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include "common/barriers.hpp"
#include "common/command.hpp"
#include "common/curves.hpp"
#include "common/options/shared_options.hpp"
#include "common/referred_files.hpp"
#include "common/run_parts.hpp"
#include "gvd/error.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/region_statistics.hpp"
#include "gvd/segment.hpp"
#include "gvd/segment_options.hpp"
#include "gvd/text.hpp"
#include "segment/charts.hpp"
#include "segment/parted_surface.hpp"
#include "segment/weights.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kExamples =
    "  gvd-segment bunny.obj -n 30 -o regions.ply\n"
    "  gvd-segment bunny.obj --generators samples.json -o regions.obj --view a.html\n"
    "  gvd-segment scan.stl --radius 2.5 --cut -o pieces.ply --report report.json\n"
    "  gvd-segment - --input-format ply --vertices 3,17,99 -o - < a.ply > b.ply\n"
    "  gvd-segment bunny.obj -n 350 --balance area --cut -o equal.ply\n"
    "  gvd-segment bunny.obj -n 20 --disc --uv flat -o charts.glb\n"
    "  gvd-segment scans/*.stl -n 30 --output-dir regions --output-format ply,json\n";

/// A note names this many generators.
constexpr std::size_t kNamed = 8;

/// Borders of a greater multiple of the bisectors' length get a note. Of 509 runs on 77 meshes with 50 or more faces
/// for each generator, 491 stay below it; with fewer the mesh is too coarse.
constexpr double kUsualBorderRatio = 1.14;

/// A million generators on 5,876 faces took 27 s of processor time and 3.6 GB.
constexpr GeneratorCost kGeneratorCost{27, 3.6};

const std::vector<std::string> kFormats{"ply",  "obj",      "off",       "coff",      "stl", "vtp",   "vtu", "glb",
                                        "json", "surf.gii", "label.gii", "shape.gii", "fs",  "annot", "curv"};

struct OwnOptions : Options {
  bool cut = false;
  SegmentOptions segmentation;
  RegionOptions regions;
  WeightOptions weights;
  ChartRequest charts;
  std::string face_labels, vertex_labels, vertex_distances, stats, adjacency;  ///< files; empty: none
};

void describe_targets(OptionList& list, OwnOptions& own) {
  const auto add = [&](const char* name, std::string& file, std::vector<std::string> extensions, Spec spec) {
    describe_target(list, own.output, name, file, extensions, std::move(spec));
  };
  add("face_labels", own.face_labels, {"npy", "csv"},
      {.help = "Write the label of each face, in the order of the faces in .ply (-1 for none)"});
  add("vertex_labels", own.vertex_labels, {"npy", "csv", "label.gii", "annot"},
      {.help = "Write the nearest generator of each vertex, in the order of the vertices in .ply (-1 for none)"});
  add("vertex_distances", own.vertex_distances, {"npy", "csv", "shape.gii", "curv"},
      {.help = "Write the distance of each vertex from its generator, in the order of the vertices in .ply",
       .more = "; .csv has the generators, too"});
  add("stats", own.stats, {"csv"},
      {.help = "Write the area, perimeter, radius and neighbours of each region (CSV)", .shown = Shown::main});
  add("adjacency", own.adjacency, {"graphml"},
      {.help = "Write the graph of the regions: their areas, and the length of each border (GraphML)"});
}

void describe_regions(OptionList& list, OwnOptions& own) {
  list.group("Regions");
  list.option("cut", Flag{&own.cut},
              {.help = "Split faces along the bisectors instead of labelling whole faces", .shown = Shown::main});
  describe(list, own.segmentation);
  list.option("region_materials", Flag{&own.output.region_materials},
              {.help = "Give each region a material of its own in .obj also where {option:input} has materials",
               .more = ", in place of these"});
  describe(list, own.regions);
  describe(list, own.weights, own.compute);
  describe(list, own.charts);
  describe_curves(list, own.generators);
  list.excludes("cut", {"labels"});
  list.excludes("curves", {"sampling", "seed", "merge_coincident", "within", "mask", "balance", "weights", "disc", "uv",
                           "verify"});
  list.rule({"curves", {"method"}, [&own](const Given&) -> std::string {
               return own.compute.diagram.method == Method::exact ? "" : "{option:curves} needs {option:method=exact}";
             }});
  list.rule({"labels", {"cut", "uv"}, [&own](const Given&) -> std::string {
               return own.cut || own.charts.uv ? "{option:labels}: no whole face is labelled; leave it out" : "";
             }});
  list.rule(
      format_rule(own.output, "region_materials", {"obj"},
                  "{option:region_materials}: only .obj names materials; write one, as in {option:output=FILE.obj}, "
                  "or leave it out"));
}

void describe_own(OptionList& list, OwnOptions& own) {
  describe_input(list, own.input);
  describe_generators(list, own.generators, {"curves", "per_region", "levels"});
  describe_diagram(list, own.compute);
  describe_output(list, own.output, kFormats);
  describe_no_curves(list, own.output);
  describe_diagram_output(list, own.output);
  describe_targets(list, own);
  describe_regions(list, own);
}

/// The rest of the command knows one number of generators. Texture coordinates are those of cut faces.
void complete(OwnOptions& own, const Given&) {
  const std::vector<std::int32_t>& levels = own.regions.levels;
  own.generators.implied_count = levels.empty() ? own.regions.per_region : levels.back();
  own.cut = own.cut || own.charts.uv.has_value();
}

/// The note on generators that own no face. It names a few of them; the report lists all.
std::string describe_without_face(const std::vector<std::int32_t>& ids) {
  const auto named = ids.begin() + static_cast<std::ptrdiff_t>(std::min(kNamed, ids.size()));
  return fmt::format(
      "{} inside faces of other regions: {}{}",
      counted(std::ssize(ids), "generator owns no face, its cell lies", "generators own no face, their cells lie"),
      fmt::join(ids.begin(), named, ", "), named == ids.end() ? "" : ", ...");
}

/// A segmented mesh, whose faces are those of the input or pieces of them.
struct Segmented {
  const PartedSurface& surface;
  const Diagram& diagram;  ///< of the surface
  const Mesh& mesh;
  const IdVector<FaceId, GeneratorId>& label;
  const IdVector<FaceId, FaceId>* parent = nullptr;  ///< of pieces
};

/// Notes the faces that no generator reaches, and why. Returns their number.
std::int64_t note_unreached(Run& run, const Segmented& made) {
  const auto whole = [&](FaceId f) { return made.parent != nullptr ? (*made.parent)[f] : f; };
  std::vector<FaceId> reached, unreached;  // faces of the input
  for (const FaceId f : made.mesh.faces()) {
    if (!made.surface.is_left_out(whole(f))) (made.label[f].valid() ? reached : unreached).push_back(whole(f));
  }
  if (unreached.empty()) return 0;
  const Barriers barriers(made.surface.input());
  const Barriers::Origin origin = barriers.from(reached);
  BarrierCounts counts;
  for (const FaceId f : unreached) counts.add(barriers.between(origin, f));
  run.console().note(fmt::format("{} reached by no generator and {} label -1: {}",
                                 counted(std::ssize(unreached), "face is", "faces are"),
                                 unreached.size() == 1 ? "gets" : "get", counts.describe("in another region")));
  return std::ssize(unreached);
}

/// Reports the size of each region, and the faces that no generator reaches.
void report_regions(Run& run, const Segmented& made) {
  const std::int64_t unreached = note_unreached(run, made);
  Json& results = run.report().results();
  results["faces"] = made.mesh.face_count();
  results["unreached_faces"] = unreached;
  Json& regions = results["regions"] = Json::array();
  const std::vector<SurfacePoint>& generators = made.diagram.generators;
  const IdVector<GeneratorId, RegionSize> sizes = measure_regions(made.mesh, made.label, generators.size());
  for (const GeneratorId g : sizes.ids()) {
    Json& region = regions.emplace_back(Json{{"label", g.value()}});
    for (const FaceNumbers& n : made.surface.numbers()) region[n.name] = n.values[generators[g.index()].face];
    region["faces"] = sizes[g].faces;
    region["area"] = sizes[g].area;
  }
}

/// The labels of the faces and vertices, and the distances of the vertices: each as an array, as a table, or in a
/// format of meshes that holds nothing else. With levels, each face has the labels of all.
void write_arrays(Run& run, const LabelledMesh& output) {
  const DistanceTable distances{.rows = {output.vertex_distance->raw()}, .nearest = output.vertex_label->raw()};
  const auto write = [&](const char* option, const OutputWriter& write_npy, const OutputWriter& write_csv) {
    write_own_file(run, option, [&](std::ostream& out) {
      const std::string extension = file_extension(*run.options().output.own.at(option));
      if (extension == "csv") return write_csv(out);
      if (!contains({"label.gii", "annot", "shape.gii", "curv"}, extension)) return write_npy(out);
      write_mesh(out, output, *parse_output_format(extension));
    });
  };
  const auto write_labels = [&](const char* option, const std::vector<GeneratorId>& labels, const char* element) {
    write(
        option, [&](std::ostream& out) { write_labels_npy(out, labels); },
        [&](std::ostream& out) { write_labels_csv(out, labels, element); });
  };
  if (const auto levels = levels_of(*output.face_numbers); !levels.empty()) {
    write(
        "--face-labels", [&](std::ostream& out) { write_levels_npy(out, levels); },
        [&](std::ostream& out) { write_levels_csv(out, levels); });
  } else {
    write_labels("--face-labels", output.face_label->raw(), "face");
  }
  write_labels("--vertex-labels", output.vertex_label->raw(), "vertex");
  write(
      "--vertex-distances", [&](std::ostream& out) { write_distances_npy(out, distances); },
      [&](std::ostream& out) { write_distances_csv(out, distances); });
}

void write_files(Run& run, const PartedSurface& surface, const LabelledMesh& output, const OutputWriter& write_json) {
  write_arrays(run, output);
  write_output_files(run, output, {{"json", write_json}});
  write_view_file(run, "gvd-segment", [&] {
    std::vector<ViewScene> scenes = make_region_scenes(output);
    for (ViewScene& scene : scenes) scene.borders = surface.borders();
    return scenes;
  });
}

/// Lengths are in mesh units. Returns the length of the borders by that of the bisectors, where these have a length.
std::optional<double> report_segmentation(Run& run, const Mesh& mesh, const Diagram& diagram,
                                          const Segmentation& segmentation) {
  const double borders = compute_border_length(mesh, segmentation.face_label), bisectors = diagram.length;
  std::vector<std::int32_t> without_face;
  for (const GeneratorId id : segmentation.without_face) without_face.push_back(id.value());
  if (!without_face.empty()) run.console().note(describe_without_face(without_face));
  if (bisectors > 0) {
    run.console().detail(
        fmt::format("borders of length {:.6g}, {:.3f} times that of the bisectors", borders, borders / bisectors));
  }
  Json& results = run.report().results();
  results["generators_without_face"] = std::move(without_face);
  results["moved_faces"] = segmentation.moved_faces;
  results["given_faces"] = segmentation.given_faces;
  results["smoothed_faces"] = segmentation.smoothed_faces;
  results["border_length"] = borders;
  const std::optional<double> ratio = bisectors > 0 ? std::optional(borders / bisectors) : std::nullopt;
  results["border_ratio"] = or_null(ratio);
  return ratio;
}

/// Notes smooth borders that are longer than usual. `ratio`: to the bisectors, if these have a length.
void note_long_borders(Run& run, std::optional<double> ratio) {
  if (!ratio || *ratio <= kUsualBorderRatio) return;
  run.console().note(
      fmt::format("borders are {:.2f} times as long as the bisectors (usually at most {}): no shorter ones were found "
                  "along edges near these; --cut follows the bisectors",
                  *ratio, kUsualBorderRatio));
}

/// Labels the faces of the diagram's surface, which are those of the input. Files have the input's vertices, on which
/// borders of regions are not doubled; bisectors are read from the surface.
void write_whole_faces(Run& run, const PartedSurface& surface, const CheckedMesh& checked, const Diagram& diagram,
                       const OwnOptions& own) {
  const SegmentOptions options{own.segmentation.labels, run.progress()};
  const Mesh &mesh = surface.mesh(), &input = checked.mesh;
  const Segmentation segmentation = run.timed("segment", [&] { return segment_faces(mesh, diagram, options); });
  const std::optional<double> ratio = report_segmentation(run, mesh, diagram, segmentation);
  report_regions(run, {surface, diagram, input, segmentation.face_label});
  if (options.labels == FaceLabels::smooth) note_long_borders(run, ratio);
  if (own.charts.disc) {
    note_non_discs(run, input, segmentation.face_label, "whole faces join or touch there; --cut follows the cells");
  }
  Diagram restricted;
  const Diagram& written = surface.restrict(diagram, restricted);
  std::vector<FaceNumbers> numbers = surface.numbers();
  surface.add_labels(segmentation.face_label, numbers);
  LabelledMesh output = label_mesh(input, written, segmentation.face_label);
  output.diagram = &diagram;
  output.diagram_mesh = &mesh;
  output.face_numbers = &numbers;
  output.appearance = &checked.appearance;
  write_files(run, surface, output,
              [&](std::ostream& out) { write_segmentation_json(out, input, written, segmentation, numbers); });
  write_diagram_file(run, input, written);
}

/// Cuts the input and not the diagram's surface: both sides of a border keep their vertices in common. Returns the
/// charts, if they are asked for.
std::optional<Charts> write_cut_faces(Run& run, const PartedSurface& surface, const CheckedMesh& checked,
                                      const Diagram& diagram, const ChartRequest& charts) {
  const Mesh& input = checked.mesh;
  CutMesh cut = run.timed("cut", [&] { return cut_faces(input, diagram, run.progress()); });
  const CutVertices vertices = carry_to_cut_vertices(surface.mesh(), diagram, cut);
  cut.numbers = carry_to_cut_faces(surface.numbers(), cut);
  Appearance appearance = carry_to_cut_faces(input, checked.appearance, cut);
  surface.add_labels(cut.label, cut.numbers);
  if (cut.uncut_faces > 0) {
    run.console().note(fmt::format("{} could not be cut", counted(cut.uncut_faces, "face", "faces")));
  }
  run.report().results()["uncut_faces"] = cut.uncut_faces;
  report_regions(run, {surface, diagram, cut.mesh, cut.label, &cut.parent});
  if (charts.disc) note_non_discs(run, cut.mesh, cut.label, "the given regions touch themselves there");
  LabelledMesh output{cut.mesh,           &cut.label, &cut.parent,    &vertices.label,
                      &vertices.distance, &diagram,   &surface.mesh()};
  output.face_numbers = &cut.numbers;
  std::optional<Charts> made;
  if (charts.uv) {
    made = chart_regions(run, surface.mesh(), diagram, cut, charts);
    replace_texture(std::move(made->texture), appearance);
  }
  output.appearance = &appearance;
  Diagram restricted;
  const Diagram& written = surface.restrict(diagram, restricted);
  write_files(run, surface, output, [&](std::ostream& out) { write_cut_json(out, input, written, cut, vertices); });
  write_diagram_file(run, input, written);
  return made;
}

/// Notes, once for all inputs, that the page and a mesh of whole faces show different borders.
void note_whole_faces(Run& run, const OwnOptions& own) {
  static const std::vector<std::string> kMeshes{"ply", "obj", "off", "coff",     "stl",
                                                "vtp", "vtu", "glb", "surf.gii", "fs"};
  const OutputOptions& output = run.options().output;
  const InputOptions& input = run.options().input;
  if (own.cut || run.options().given->has("labels") || output.view.empty() || input.path != input.paths.front()) return;
  for (const std::string& file : output.files) {
    if (!contains(kMeshes, format_of(output, file))) continue;
    return run.console().note(fmt::format("{} shows the exact borders, and {} has whole faces; --cut splits them",
                                          output.view, file == "-" ? "standard output" : file));
  }
}

void segment(Run& run, OwnOptions& own) {
  const SegmentOptions options{own.segmentation.labels, run.progress()};
  const CheckedMesh input = load_input(run);
  check_material_files(run, input.appearance, own.charts.uv.has_value());
  note_many_generators(run, input.mesh, kGeneratorCost);
  const PartedSurface surface(run, input, own.regions, options);
  const Mesh& mesh = surface.mesh();
  Diagram diagram = run.options().generators.curves.empty()
                        ? build_weighted_diagram(run, {input, mesh}, surface.make_generators(run), own.weights)
                        : build_curve_diagram(run, mesh, load_curves(run, input));
  if (own.charts.disc) {
    diagram = make_cells_discs(run, mesh, diagram);
    run.report().set_generators(input.mesh, diagram.generators);
  }
  std::optional<Charts> charts;
  if (own.cut) {
    charts = write_cut_faces(run, surface, input, diagram, own.charts);
  } else {
    write_whole_faces(run, surface, input, diagram, own);
    note_whole_faces(run, own);
  }
  write_own_file(run, "--stats", [&](std::ostream& out) {
    write_statistics_csv(out, compute_region_statistics(mesh, diagram), charts ? &*charts : nullptr);
  });
  write_own_file(run, "--adjacency", [&](std::ostream& out) {
    write_adjacency_graphml(out, mesh, diagram.generators, compute_region_statistics(mesh, diagram));
  });
  finish_run(run, mesh, diagram);
}

}  // namespace

Command segment_command() {
  return make_command<OwnOptions>(
      {"gvd-segment",
       "Labels every face of a triangle mesh with the region of the geodesically nearest generator.",
       kExamples,
       {kFormats}},
      {describe_own, segment, complete});
}

}  // namespace gvd::app
