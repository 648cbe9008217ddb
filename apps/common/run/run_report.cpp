#include "common/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <ostream>

#include "common/options/options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t count_disc_cells(const Diagram& diagram) {
  return std::count_if(diagram.cells.begin(), diagram.cells.end(),
                       [](const Cell& cell) { return cell.components == 1 && cell.euler_characteristic == 1; });
}

/// Positions have the digits that bring the same double back, as in every list of generators.
std::string number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

void append_generator(std::string& text, const ReportedGenerator& generator) {
  const auto& [point, position, snap_distance] = generator;
  fmt::format_to(std::back_inserter(text), "{{\"face\":{},\"bary\":[{},{},{}],\"position\":[{},{},{}]",
                 point.face.value(), point.bary[0], point.bary[1], point.bary[2], number(position.x()),
                 number(position.y()), number(position.z()));
  if (snap_distance) text += ",\"snap_distance\":" + number(*snap_distance);
  text += '}';
}

/// One generator a line.
std::string list_generators(const std::vector<ReportedGenerator>& generators) {
  std::string text = "[";
  for (const ReportedGenerator& generator : generators) {
    text += text.size() == 1 ? "\n  " : ",\n  ";
    append_generator(text, generator);
  }
  return text + (generators.empty() ? "]" : "\n]");
}

}  // namespace

RunReport::RunReport(const std::string& command, const Options& options)
    : document_(std::make_unique<Json>(Json{{"schema", "gvd-report/1"},
                                            {"command", command},
                                            {"version", GVD_VERSION},
                                            {"options", to_json(options)},
                                            {"seed", options.generators.seed},
                                            {"input", nullptr},
                                            {"generators", nullptr},
                                            {"diagram", nullptr},
                                            {"timings_ms", Json::object()},
                                            {"peak_memory_bytes", 0},
                                            {"results", Json::object()}})) {}

RunReport::~RunReport() = default;

Json& RunReport::options() { return (*document_)["options"]; }

Json& RunReport::results() { return (*document_)["results"]; }

void RunReport::set_input(const MeshSummary& mesh, const DefectReport& defects) {
  Json counts = Json::object();
  for (const Defect& defect : defects.defects) counts[std::string(name_of(defect.kind))] = defect.count;
  (*document_)["input"] = {{"vertices", mesh.vertices},
                           {"faces", mesh.faces},
                           {"components", mesh.components},
                           {"boundary_loops", mesh.boundary_loops},
                           {"euler_characteristic", mesh.euler_characteristic},
                           {"area", mesh.area},
                           {"bbox_diagonal", mesh.bbox_diagonal},
                           {"defects", std::move(counts)}};
}

void RunReport::set_diagram(const Diagram& diagram) {
  (*document_)["diagram"] = {{"branch_points", diagram.branch_points.size()},
                             {"bisectors", diagram.bisectors.size()},
                             {"length", diagram.length},
                             {"cells", diagram.cells.size()},
                             {"disc_cells", count_disc_cells(diagram)},
                             {"trivial_faces", diagram.report.face_classes.trivial},
                             {"ordinary_faces", diagram.report.face_classes.ordinary},
                             {"branching_faces", diagram.report.face_classes.branching},
                             {"gaps", diagram.report.gaps},
                             {"gaps_grown", diagram.report.gaps_grown},
                             {"gaps_assembled", diagram.report.gaps_assembled},
                             {"unresolved_ends", diagram.report.unresolved_ends},
                             {"relabelled_vertices", diagram.report.relabelled_vertices},
                             {"straightened_faces", diagram.report.straightened_faces},
                             {"straightened_error", diagram.report.straightened_error},
                             {"verify", nullptr}};
}

void RunReport::set_error_measure(const ErrorMeasure& error) {
  (*document_)["diagram"]["verify"] = {{"error_integral", error.error_integral},
                                       {"error_mean", error.error_mean},
                                       {"error_max", error.error_max},
                                       {"length", error.length}};
}

void RunReport::set_time(std::string_view step, double milliseconds) {
  (*document_)["timings_ms"][std::string(step)] = milliseconds;
}

void RunReport::set_peak_memory(std::int64_t bytes) { (*document_)["peak_memory_bytes"] = bytes; }

void RunReport::write(std::ostream& out) const {
  const char* separator = "{";
  for (const auto& [name, value] : document_->items()) {
    const bool listed = name == "generators";
    out << separator << '"' << name << "\":"
        << (listed ? list_generators(generators_) : value.dump(-1, ' ', false, Json::error_handler_t::replace));
    separator = ",\n";
  }
  if (!(out << "}\n") || !out.flush()) throw Error(ErrorCode::unwritable_output, "the report could not be written");
}

}  // namespace gvd::app
