#include "common/steps/load_input.hpp"

#include <fmt/format.h>

#include <utility>

#include "common/options/file_extension.hpp"
#include "common/steps/standard_input.hpp"
#include "gvd/error.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

std::string name_of(const InputOptions& input) { return input.path == "-" ? kStandardInput : input.path; }

PolygonSoup read(const InputOptions& input, std::string* standard_input) {
  const auto format = format_from_extension(input.format);
  if (input.path != "-") return read_soup(input.path, format);
  std::string bytes = read_standard_input();
  PolygonSoup soup = parse_soup(bytes, *format, kStandardInput);
  if (standard_input != nullptr) *standard_input = std::move(bytes);
  return soup;
}

DefectPolicy policy(const std::string& name) {
  if (name == "error") return DefectPolicy::error;
  return name == "largest" ? DefectPolicy::largest : DefectPolicy::repair;
}

/// Adds the name of the input to the errors of build_mesh, which knows no file.
CheckedMesh check(const InputOptions& input, const PolygonSoup& soup) {
  try {
    return build_mesh(soup, policy(input.on_defect));
  } catch (const Error& error) {
    throw Error(error.code(), name_of(input) + ": " + error.what(), error.element());
  }
}

/// Refuses, before the work starts, formats that can't hold the result: it lies in the bounding box of the input.
void check_formats(const OutputOptions& output, const Mesh& mesh) {
  for (const std::string& file : output.files) {
    const auto format = parse_output_format(file == "-" ? stdout_format(output) : file_extension(file));
    if (format) check_format(mesh, *format);
  }
}

}  // namespace

CheckedMesh load_input(Run& run, std::string* standard_input) {
  const InputOptions& input = run.options().input;
  const PolygonSoup soup = run.timed("read", [&] { return read(input, standard_input); });
  CheckedMesh checked = run.timed("check", [&] { return check(input, soup); });
  for (const std::string& message : checked.defects.messages) run.console().note(name_of(input) + ": " + message);
  check_formats(run.options().output, checked.mesh);
  const MeshSummary summary = compute_mesh_summary(checked.mesh);
  run.report().set_input(summary, checked.defects);
  run.console().detail(fmt::format("{}, {}, {}, {}", counted(summary.vertices, "vertex", "vertices"),
                                   counted(summary.faces, "face", "faces"),
                                   counted(summary.components, "component", "components"),
                                   counted(summary.boundary_loops, "boundary loop", "boundary loops")));
  return checked;
}

}  // namespace gvd::app
