// Keeps the report, the times and the progress of a command's run.
//
// The report is a JSON document (gvd-report/2), which the body of the run fills in and writes at its end. Members are
// in the order of the contract, each on a line of its own. The generators are stored separately, because a run may have
// a million, and are written one on each line in the form that `parse_generators` reads. The library reads no clock and
// prints nothing. The time of a step is reported when it ends. The progress callback draws the bar, and cancels the
// library's work after a signal.

#include "common/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlohmann/json.hpp>
#include <ostream>

#include "common/options/spelling.hpp"
#include "common/process.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/operation_json.hpp"
#include "gvd/version.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

/// The fewest digits that read back to the same double; null for infinity and NaN.
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

Json& RunReport::at(const char* member) const { return document_->at(member); }

void RunReport::set_input(const MeshSummary& mesh, const DefectReport& defects) {
  Json counts = Json::object();
  for (const Defect& defect : defects.defects) counts[std::string(name_of(defect.kind))] = defect.count;
  Json& input = at("input") = Json::parse(figures_json([&](ObjectVisitor& visitor) { visit_summary(visitor, mesh); }));
  input["bbox_diagonal"] = mesh.bbox_diagonal;
  input["defects"] = std::move(counts);
}

void RunReport::set_diagram(const Diagram& diagram) {
  const auto visit = [&](ObjectVisitor& visitor) { visit_figures(visitor, diagram); };
  at("diagram") = Json::parse(figures_json(visit));
  at("diagram")["verify"] = nullptr;
}

void RunReport::set_error_measure(const ErrorMeasure& error) {
  at("diagram")["verify"] = {{"error_integral", error.error_integral},
                             {"error_mean", error.error_mean},
                             {"error_max", error.error_max},
                             {"length", error.length},
                             {"corrected", error.corrected}};
}

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

std::string Run::spelled(const std::string& text) const { return spell(*options().list, *options().given, text); }

bool Run::advance(std::string_view step, double fraction) {
  console_.bar(step, fraction);
  return !interrupt_requested();
}

Progress Run::progress() {
  return [this](std::string_view step, double fraction) { return advance(step, fraction); };
}

void Run::report_time(std::string_view step, double milliseconds) {
  console_.clear_bar();
  console_.detail(fmt::format("{}: {:.1f} ms", step, milliseconds));
  report_.at("timings_ms")[std::string(step)] = milliseconds;
}

RunObserver::RunObserver(Run& run) : run_(run) { threads = run.options().compute.threads; }

// Nothing is reported while an exception is propagating, because there may be no memory for it.
RunObserver::~RunObserver() {
  if (std::uncaught_exceptions() > 0) return;
  for (const Timed& timed : steps_) {
    if (timed.times > 1) report(timed);
  }
}

void RunObserver::report(const Timed& timed) {
  run_.report_time(timed.step, std::chrono::duration<double, std::milli>(timed.sum).count());
}

bool RunObserver::progress(std::string_view step, double fraction) { return run_.advance(step, fraction); }

void RunObserver::enter(std::string_view step) {
  check_interrupt();
  release_freed_memory();
  const auto found = std::ranges::find(steps_, step, &Timed::step);
  entered_.push_back(std::size_t(found - steps_.begin()));
  if (found == steps_.end()) steps_.push_back({std::string(step)});
  steps_[entered_.back()].started = Clock::now();
}

void RunObserver::leave() {
  Timed& left = steps_[entered_.back()];
  left.sum += Clock::now() - left.started;
  entered_.pop_back();
  if (std::uncaught_exceptions() == 0 && ++left.times == 1) report(left);
}

void RunObserver::note(const std::string& text) { run_.note(text); }

void RunObserver::detail(const std::string& text) { run_.console().detail(run_.spelled(text)); }

void RunObserver::status(const std::string& text) { run_.console().set_status(text); }

}  // namespace gvd::app
