// A run of a command: its report, times and progress.
//
// The report is one JSON document (gvd-report/2), which the body of the run fills in and writes at its end. Members
// stand in the order of the contract, each on a line of its own. The generators are kept apart, since a run may have a
// million, and written one a line, in the form in which `parse_generators` reads them. The library reads no clock and
// prints nothing. A step's time is reported when its StepTimes ends, after an exception too. The progress callback
// draws the bar and cancels the library's work once a signal has come.

#include "common/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <ostream>

#include "common/options/spelling.hpp"
#include "common/process.hpp"
#include "gvd/error.hpp"
#include "gvd/version.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

std::int64_t count_disc_cells(const Diagram& diagram) { return std::ranges::count_if(diagram.cells, &Cell::is_disc); }

/// The shortest digits that bring the same double back.
std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

std::string format_generator(const ReportedGenerator& generator) {
  const auto& [point, at, snap_distance] = generator;
  const auto& [u, v, w] = point.bary;
  return fmt::format("{{\"face\":{},\"bary\":[{},{},{}],\"position\":[{},{},{}]{}}}", point.face.value(), u, v, w,
                     json_number(at.x()), json_number(at.y()), json_number(at.z()),
                     snap_distance ? ",\"snap_distance\":" + json_number(*snap_distance) : "");
}

void write_generators(std::ostream& out, const std::vector<ReportedGenerator>& generators) {
  const char* before = "[\n  ";
  for (const ReportedGenerator& generator : generators) {
    out << before << format_generator(generator);
    before = ",\n  ";
  }
  out << (generators.empty() ? "[]" : "\n]");
}

}  // namespace

Json to_json(const MeshSummary& mesh) {
  return {{"vertices", mesh.vertices},
          {"faces", mesh.faces},
          {"components", mesh.components},
          {"boundary_loops", mesh.boundary_loops},
          {"euler_characteristic", mesh.euler_characteristic},
          {"area", mesh.area}};
}

RunReport::RunReport(const std::string& command, std::uint64_t seed)
    : document_(std::make_unique<Json>(Json{{"schema", "gvd-report/2"},
                                            {"command", command},
                                            {"version", version()},
                                            {"options", Json::object()},
                                            {"seed", seed},
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
  Json& input = (*document_)["input"] = to_json(mesh);
  input["bbox_diagonal"] = mesh.bbox_diagonal;
  input["defects"] = std::move(counts);
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
    out << separator << '"' << name << "\":";
    if (name == "generators") {
      write_generators(out, generators_);
    } else {
      out << value.dump(-1, ' ', false, Json::error_handler_t::replace);
    }
    separator = ",\n";
  }
  out << "}\n";
  if (!out.flush()) throw Error(ErrorCode::unwritable_output, "the output stream could not be written");
}

StepTimes::StepTimes(Run& run) : run_(run) { check_interrupt(); }

StepTimes::~StepTimes() {
  stop();
  for (const auto& [step, sum] : sums_) run_.report_time(step, std::chrono::duration<double, std::milli>(sum).count());
}

void StepTimes::start(std::string_view step) {
  stop();
  release_freed_memory();
  const auto found = std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == step; });
  current_ = found - sums_.begin();
  if (found == sums_.end()) sums_.emplace_back(step, Clock::duration::zero());
  started_ = Clock::now();
}

void StepTimes::stop() {
  if (!sums_.empty()) sums_[current_].second += Clock::now() - started_;
}

std::string Run::spelled(const std::string& text) const {
  const Options& options = this->options();
  return options.list == nullptr ? text : spell(*options.list, *options.given, text);
}

Progress Run::progress() {
  return [this](std::string_view step, double fraction) {
    console_.bar(step, fraction);
    return !interrupt_requested();
  };
}

void Run::report_time(std::string_view step, double milliseconds) {
  console_.clear_bar();
  console_.detail(fmt::format("{}: {:.1f} ms", step, milliseconds));
  report_.set_time(step, milliseconds);
}

}  // namespace gvd::app
