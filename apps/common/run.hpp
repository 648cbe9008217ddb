#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "common/console.hpp"
#include "common/options/options.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/mesh.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/observer.hpp"
#include "gvd/progress.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd::app {

/// A generator as the report lists it.
struct ReportedGenerator {
  SurfacePoint point;
  Vec3 position = Vec3::Zero();         ///< mesh units
  std::optional<double> snap_distance;  ///< mesh units; from the given position, where one was given
};

/// The record of a run: the document of `--report`, schema `gvd-report/2`. The body of the run fills it in, and it is
/// written once, at the end. docs/guide/formats.md lists its members.
class RunReport {
 public:
  RunReport(const std::string& command, std::uint64_t seed);
  ~RunReport();
  RunReport(const RunReport&) = delete;
  RunReport& operator=(const RunReport&) = delete;

  /// A member of the document, such as `results`; `generators` is null here.
  nlohmann::ordered_json& at(const char* member) const;
  /// Member `generators`: those that the run used or leaves, in the order of their ids.
  std::vector<ReportedGenerator>& generators() { return generators_; }

  void set_input(const MeshSummary& mesh, const DefectReport& defects);
  /// The figures of a diagram. Replaces those of an earlier one and its error measure. Cost: O(cells).
  void set_diagram(const Diagram& diagram);
  /// The error of the diagram that was set.
  void set_error_measure(const ErrorMeasure& error);

  /// Writes the document; the stream is flushed and checked. `parse_generators` reads its generators back.
  /// Numbers that are not finite become null; bytes that are no UTF-8 become U+FFFD.
  /// Throws Error{unwritable_output}. Cost: O(size).
  void write(std::ostream& out) const;

 private:
  std::unique_ptr<nlohmann::ordered_json> document_;  ///< all members in their order; `generators` is left null
  std::vector<ReportedGenerator> generators_;         ///< not in the document: a run may have very many
};

/// One run of a command: its options, console and report. Only the body of the run holds it. Steps take values and
/// return what the body reports.
class Run {
 public:
  Run(const std::string& command, Options options, Console& console)
      : options_(std::move(options)), console_(console), report_(command, seed_of(options_)) {}

  const Options& options() const { return live_ != nullptr ? *live_ : options_; }
  /// From now on the options are these, which the body of the run may complete. They must outlive the run.
  void follow(const Options& live) { live_ = &live; }
  Console& console() { return console_; }
  /// A text with its placeholders as the user writes options.
  std::string spelled(const std::string& text) const;
  /// A note on the console, which may have placeholders.
  void note(const std::string& text) { console_.note(spelled(text)); }
  /// The document of `--report`.
  RunReport& report() { return report_; }
  /// The files that are written so far, in their order; standard output is none.
  const std::vector<std::string>& written() const { return written_; }
  void add_written(const std::string& file) { written_.push_back(file); }

  /// Draws the bar of a step. False after a signal: the work is to end.
  bool advance(std::string_view step, double fraction);
  /// The same for the `progress` fields of the library. Valid while the run lives.
  Progress progress();

  /// Reports and, where verbose, prints the wall time of a step.
  void report_time(std::string_view step, double milliseconds);

  /// Runs `work` and reports its wall time under the name `step`.
  /// Throws Error{interrupted} where a signal came before.
  template <class Work>
  decltype(auto) timed(std::string_view step, Work&& work);

 private:
  Options options_;
  const Options* live_ = nullptr;
  Console& console_;
  RunReport report_;
  std::vector<std::string> written_;
};

/// What an operation tells, for the console and the report of a run: bars, notes with the options as the user wrote
/// them, and the time of each step. It is reported when the step ends, and in all when this ends, where the step began
/// again. Nothing is reported while an exception is on its way.
class RunObserver : public Observer {
 public:
  /// `run` must outlive it.
  explicit RunObserver(Run& run);
  ~RunObserver() override;
  RunObserver(const RunObserver&) = delete;
  RunObserver& operator=(const RunObserver&) = delete;

  bool progress(std::string_view step, double fraction) override;
  void enter(std::string_view step) override;
  void leave() override;
  void note(const std::string& text) override;
  void detail(const std::string& text) override;
  void status(const std::string& text) override;

 private:
  using Clock = std::chrono::steady_clock;
  struct Timed {
    std::string step;
    Clock::duration sum{};
    Clock::time_point started{};
    int times = 0;  ///< that it ended
  };
  void report(const Timed& timed);

  Run& run_;
  std::vector<Timed> steps_;          // in the order of their first starts
  std::vector<std::size_t> entered_;  // of `steps_`
};

template <class Work>
decltype(auto) Run::timed(std::string_view step, Work&& work) {
  RunObserver observer(*this);
  return as_step(observer, step, std::forward<Work>(work));
}

/// The result of an operation on INPUT with its options, which become what they stand for.
template <class Call>
auto run_operation(Run& of, const MeshPtr& input, Call& call) {
  RunObserver observer(of);
  return run(input, call, observer);  // that of the call's header
}

}  // namespace gvd::app
