#include "common/steps/write_outputs.hpp"

#include <algorithm>
#include <filesystem>
#include <ostream>

#include "common/options/options.hpp"
#include "common/run/standard_output.hpp"
#include "gvd/error.hpp"
#include "gvd/io/atomic_file.hpp"
#include "gvd/io/diagram_json.hpp"

namespace gvd::app {
namespace {

/// The mesh as the options want it in one format. JSON is the diagram itself, and keeps its bisectors.
LabelledMesh choose_content(const OutputOptions& output, LabelledMesh mesh, OutputFormat format) {
  if (output.no_curves && format != OutputFormat::json) mesh.diagram = nullptr;
  mesh.ascii_ply = output.ascii_ply;
  return mesh;
}

void write_one(Run& run, const std::string& path, const LabelledMesh& mesh,
               const std::map<std::string, OutputWriter>& own_formats) {
  const bool standard = path == "-";
  const std::string format = standard ? stdout_format(run.options().output) : file_extension(path);
  const auto own = own_formats.find(format);
  if (own != own_formats.end()) {
    if (standard) return write_standard_output(own->second);
    return write_file(path, own->second, run.progress());
  }
  const auto known = parse_output_format(format);
  if (!known) throw Error(ErrorCode::invalid_option, "-o " + path + ": this command does not write ." + format);
  const LabelledMesh chosen = choose_content(run.options().output, mesh, *known);
  if (standard) return write_standard_output([&](std::ostream& out) { write_mesh(out, chosen, *known); });
  write_mesh(path, chosen, run.progress());
}

}  // namespace

void write_output_files(Run& run, const LabelledMesh& mesh, const std::map<std::string, OutputWriter>& own_formats) {
  const OutputOptions& output = run.options().output;
  const bool has_own =
      std::any_of(output.own.begin(), output.own.end(), [](const auto& own) { return !own.second.empty(); });
  if (output.files.empty() && output.report.empty() && output.diagram.empty() && output.view.empty() && !has_own) {
    run.console().note("no file is written; name one with -o, --report, --diagram or --view");
  }
  if (output.files.empty()) return;
  run.timed("write", [&] {
    for (const std::string& file : output.files) write_one(run, file, mesh, own_formats);
  });
}

void write_diagram_file(Run& run, const Mesh& mesh, const Diagram& diagram) {
  const std::string& path = run.options().output.diagram;
  if (path.empty()) return;
  const auto write = [&](std::ostream& out) { write_diagram_json(out, mesh, diagram); };
  run.timed("write diagram", [&] { write_file(path, write, run.progress()); });
}

void write_own_file(Run& run, const std::string& option, const OutputWriter& write) {
  const auto& own = run.options().output.own;
  const auto target = own.find(option);
  if (target == own.end() || target->second.empty()) return;
  run.timed("write " + option.substr(2), [&] { write_file(target->second, write, run.progress()); });
}

void write_view_file(Run& run, const std::string& title, const std::function<std::vector<ViewScene>()>& make_scenes) {
  const std::string& path = run.options().output.view;
  if (path.empty()) return;
  ViewOptions options;
  options.up = run.options().output.up.value_or(options.up);
  const std::string& input = run.options().input.path;
  options.title = input == "-" ? title : title + ": " + std::filesystem::path(input).filename().string();
  run.timed("write view", [&] {
    const std::string page = make_view_page(make_scenes(), options);
    write_file(
        path, [&](std::ostream& out) { out << page; }, run.progress());
  });
}

void write_report_file(Run& run) {
  const std::string& path = run.options().output.report;
  if (path.empty()) return;
  check_interrupt();
  run.report().set_peak_memory(peak_memory_bytes());
  write_file(path, [&](std::ostream& out) { run.report().write(out); });
}

}  // namespace gvd::app
