#include "gvd/io/run_report.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gvd/error.hpp"
#include "io/writers/byte_writer.hpp"
#include "io/writers/json_text.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;
using io::ByteWriter;

/// A file name in the options may hold any bytes.
std::string to_text(const Json& value) { return value.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json parse_object(const std::string& text, const char* what) {
  Json value = Json::parse(text, nullptr, false);
  if (!value.is_object()) throw Error(ErrorCode::precondition, fmt::format("the report's {} are no JSON object", what));
  return value;
}

template <class Number>
Json to_object(const NamedNumbers<Number>& numbers) {
  Json object = Json::object();
  for (const auto& [name, number] : numbers) object[name] = number;
  return object;
}

Json input_json(const RunReport& report) {
  const MeshSummary& input = report.input;
  return {{"vertices", input.vertices},
          {"faces", input.faces},
          {"components", input.components},
          {"boundary_loops", input.boundary_loops},
          {"euler_characteristic", input.euler_characteristic},
          {"area", input.area},
          {"bbox_diagonal", input.bbox_diagonal},
          {"defects", to_object(report.defects)}};
}

Json verify_json(const std::optional<VerifyFigures>& verify) {
  if (!verify) return nullptr;
  // A diagram without bisectors has no error.
  const double mean = verify->length > 0 ? verify->error_integral / verify->length : 0;
  return {{"error_integral", verify->error_integral},
          {"error_mean", mean},
          {"error_max", verify->error_max},
          {"length", verify->length}};
}

Json diagram_json(const std::optional<DiagramFigures>& diagram) {
  if (!diagram) return nullptr;
  return {{"branch_points", diagram->branch_points},
          {"bisectors", diagram->bisectors},
          {"length", diagram->length},
          {"cells", diagram->cells},
          {"disc_cells", diagram->disc_cells},
          {"unresolved_ends", diagram->unresolved_ends},
          {"relabelled_vertices", diagram->relabelled_vertices},
          {"straightened_faces", diagram->straightened_faces},
          {"verify", verify_json(diagram->verify)}};
}

void print_generator(ByteWriter& out, const ReportedGenerator& generator) {
  out.text("{");
  io::print_point_members(out, generator.point, generator.position);
  if (generator.snap_distance) out.print(",\"snap_distance\":{}", io::json_number(*generator.snap_distance));
  out.text("}");
}

}  // namespace

DiagramFigures summarize_diagram(const Diagram& diagram) {
  DiagramFigures figures;
  figures.branch_points = static_cast<std::int64_t>(diagram.branch_points.size());
  figures.bisectors = static_cast<std::int64_t>(diagram.bisectors.size());
  figures.length = diagram.length;
  figures.cells = static_cast<std::int64_t>(diagram.cells.size());
  figures.disc_cells = std::count_if(diagram.cells.begin(), diagram.cells.end(), [](const Cell& cell) {
    return cell.components == 1 && cell.euler_characteristic == 1;
  });
  figures.unresolved_ends = diagram.report.unresolved_ends;
  figures.relabelled_vertices = diagram.report.relabelled_vertices;
  figures.straightened_faces = diagram.report.straightened_faces;
  return figures;
}

void write_run_report(std::ostream& stream, const RunReport& report) {
  ByteWriter out(stream);
  const auto member = [&out](const char* name, const Json& value) { out.print(",\n\"{}\":{}", name, to_text(value)); };
  out.text("{\"schema\":\"gvd-report/1\"");
  member("command", report.command);
  member("version", report.version);
  member("options", parse_object(report.options, "options"));
  member("seed", report.seed);
  member("input", input_json(report));
  out.text(",\n\"generators\":");
  io::print_lines(out, report.generators, [&](const ReportedGenerator& item) { print_generator(out, item); });
  member("diagram", diagram_json(report.diagram));
  member("timings_ms", to_object(report.timings_ms));
  member("peak_memory_bytes", report.peak_memory_bytes);
  member("results", parse_object(report.results, "results"));
  out.text("}\n");
  out.finish();
}

}  // namespace gvd
