// gvd-remesh: builds the coarse mesh that is dual to a diagram.
//
// The library makes the mesh (gvd/remesh_operation.hpp). This file has the outputs, and the properties of INPUT that
// are carried over.

#include <fmt/format.h>

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "common/command.hpp"
#include "common/load_input.hpp"
#include "common/options/options.hpp"
#include "common/options/shared_options.hpp"
#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/mesh_property.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/remesh_operation.hpp"
#include "gvd/remesh_scenes.hpp"

namespace gvd::app {
namespace {

constexpr const char* kExamples =
    "  gvd-remesh bunny.obj -n 2000 -o coarse.obj\n"
    "  gvd-remesh part.stl --features 40 --error 0.5% -o coarse.obj\n"
    "  gvd-remesh bunny.obj -n 2000 --relax 40 --density curvature -o coarse.ply\n"
    "  gvd-remesh bunny.obj --generators samples.json -o coarse.ply\n"
    "  gvd-remesh bunny.obj -n 500 --view coarse.html --report report.json\n"
    "  gvd-remesh bunny.obj -n 500 --no-refine -o coarse.off\n"
    "  gvd-remesh scans/*.stl -n 500 --output-dir coarse --output-format obj\n";

/// 30,000 generators on 5,876 faces took 14 s of processor time and 0.44 GB.
constexpr GeneratorCost kGeneratorCost{460, 14.7};

const std::vector<std::string> kFormats = output_extensions(RemeshOutcome::kContent);

struct RemeshCommandOptions : Options {
  RemeshCall call;
  std::string map;  ///< the file of --map; empty: none
};

void describe_own(OptionList& list, RemeshCommandOptions& own) {
  describe_input(list, own.input);
  describe(list, own.call);
  describe_generators_format(list, own.input);
  list.group("Remesh");
  list.option("carry", Flag{&own.call.carry},
              {.help = "Carry over the colours and other properties of a PLY input to " +
                       list_extensions(output_extensions(Content::properties), "and"),
               .more = fmt::format(", texture coordinates to {}, and materials to {}",
                                   list_extensions(output_extensions(Content::texture), "and"),
                                   list_extensions(output_extensions(Content::materials), "and"))});
  list.rule(format_rule(own.output, "carry", output_extensions(RemeshOutcome::kCarried),
                        fmt::format("\1carry\2: {} what is carried over; write one, such as "
                                    "\1output=FILE.ply\2",
                                    only_formats(RemeshOutcome::kCarried))));
  describe_resources(list, own.compute);
  describe_verify(list, own.compute);
  describe_output(list, own.output, kFormats, "ply");
  describe_diagram_output(list, own.output);
  describe_target(list, own.output, "map", own.map, {"json"},
                  {.help = "Write the point of \1input\2 for each output vertex, and the point of the output for "
                           "each input vertex"});
}

void complete(RemeshCommandOptions& own, const Given&) { own.call.map = !own.map.empty(); }

std::vector<MeshProperty> read_properties(const InputOptions& input, const PipedInput& piped) {
  if (piped.bytes.empty()) return read_mesh_properties(input.path, input.format);
  return parse_mesh_properties(piped.bytes, piped.format, input.path == "-" ? kStandardInput : input.path);
}

/// Notes if there was nothing to carry over, and which carried properties no output holds.
void note_carried(Run& run, const RemeshOutcome& made) {
  if (made.properties.empty() && made.appearance.empty()) {
    note_on_input(run, "no properties, texture coordinates or materials to carry over");
  } else if (!made.properties.empty() && !writes(run.options().output, Content::properties)) {
    run.note(fmt::format("\1carry\2: {} properties; write one, such as \1output=FILE.ply\2",
                         only_formats(Content::properties)));
  }
}

void write_view(Run& run, const Mesh& mesh, const RemeshResult& result) {
  Mesh unplaced;  // the scenes refer to this mesh
  write_view_file(run, "gvd-remesh", [&] {
    unplaced = make_unplaced(mesh, result);
    return make_remesh_scenes(mesh, result, unplaced, run.options().compute.threads, run.progress());
  });
}

void run_remesh(Run& run, RemeshCommandOptions& own) {
  PipedInput piped;
  const bool carries = own.call.carry;
  const MeshPtr input = load_input(run, carries ? &piped : nullptr);
  note_many_generators(run, input->mesh, own.call.generators.wanted().value_or(0), kGeneratorCost);
  if (!carries && !input->appearance.empty() && !run.options().output.files.empty()) {
    note_on_input(run, fmt::format("texture coordinates and materials are left out; \1carry\2 keeps them in {}",
                                   list_extensions(output_extensions(Content::texture | Content::materials), "and")));
  }
  if (carries) own.call.properties = read_properties(run.options().input, piped);
  const auto made = run_operation(run, input, own.call);
  const RemeshResult& result = made->result();
  report_figures(run, *made);
  run.report().set_diagram(result.diagram);
  report_generators(run, input->mesh, result.generators, made->snap_distance);
  if (carries) note_carried(run, *made);
  write_output_files(run, *made);
  write_diagram_file(run, input->mesh, result.diagram);
  write_part_file(run, "map", *made);
  write_view(run, input->mesh, result);
  finish_run(run, input->mesh, result.diagram);
}

}  // namespace

Command remesh_command() {
  return make_command<RemeshCommandOptions>(
      {"gvd-remesh",
       "Builds a coarse mesh: a vertex for each generator, a triangle for each branch point.",
       kExamples,
       {kFormats, false}},  // the coarse mesh has no labels
      {describe_own, run_remesh, complete});
}

}  // namespace gvd::app
