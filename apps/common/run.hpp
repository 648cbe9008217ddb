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
  std::optional<double> snap_distance;  ///< distance from the given position, if there was one; mesh units
};

/// The document of `--report`, schema `gvd-report/2`. The body of the run fills it in, and it is written once, at the
/// end. docs/schema/README.md lists its members.
class RunReport {
 public:
  RunReport(const std::string& command, std::uint64_t seed);
  ~RunReport();
  RunReport(const RunReport&) = delete;
  RunReport& operator=(const RunReport&) = delete;

  /// A member of the document, such as `results`. `generators` is always null here.
  nlohmann::ordered_json& at(const char* member) const;
  /// The member `generators`: the generators that the run used or produced, in the order of their ids.
  std::vector<ReportedGenerator>& generators() { return generators_; }

  void set_input(const MeshSummary& mesh, const DefectReport& defects);
  /// Sets the figures of a diagram. Replaces the figures of an earlier diagram and its error measure. Cost: O(cells).
  void set_diagram(const Diagram& diagram);
  /// Sets the error of the diagram.
  void set_error_measure(const ErrorMeasure& error);

  /// Writes the document, and flushes and checks the stream. `parse_generators` can read its generators back. Numbers
  /// that are not finite become null; bytes that are not valid UTF-8 become U+FFFD. Throws Error{unwritable_output}.
  /// Cost: O(size).
  void write(std::ostream& out) const;

 private:
  std::unique_ptr<nlohmann::ordered_json> document_;  ///< all members in order; `generators` stays null
  std::vector<ReportedGenerator> generators_;         ///< not in the document, because there may be very many
};

/// A run of a command: its options, console and report. Only the body of the run uses it; steps take values and return
/// what the body reports.
class Run {
 public:
  Run(const std::string& command, Options options, Console& console)
      : options_(std::move(options)), console_(console), report_(command, seed_of(options_)) {}

  const Options& options() const { return live_ != nullptr ? *live_ : options_; }
  /// Uses `live` as options from now on, which the body of the run may complete. They must outlive the run.
  void follow(const Options& live) { live_ = &live; }
  Console& console() { return console_; }
  /// Replaces the placeholders of a text by options as the user writes them.
  std::string spelled(const std::string& text) const;
  /// Prints a note, which may contain placeholders.
  void note(const std::string& text) { console_.note(spelled(text)); }
  /// The document of `--report`.
  RunReport& report() { return report_; }
  /// The files written so far, in order; standard output does not count.
  const std::vector<std::string>& written() const { return written_; }
  void add_written(const std::string& file) { written_.push_back(file); }

  /// Draws the bar of a step. Returns false after a signal, when the work should end.
  bool advance(std::string_view step, double fraction);
  /// The same for the `progress` fields of the library. Valid as long as the run exists.
  Progress progress();

  /// Reports the wall time of a step, and prints it if verbose.
  void report_time(std::string_view step, double milliseconds);

  /// Runs `work` and reports its wall time under the name `step`.
  /// Throws Error{interrupted} if a signal came before.
  template <class Work>
  decltype(auto) timed(std::string_view step, Work&& work);

 private:
  Options options_;
  const Options* live_ = nullptr;
  Console& console_;
  RunReport report_;
  std::vector<std::string> written_;
};

/// Passes the messages of an operation to the console and the report of a run: bars, notes with options as the user
/// wrote them, and the time of each step. The time is reported when the step ends or, if the step begins again, as a
/// sum when this object is destroyed. Nothing is reported while an exception is propagating.
class RunObserver : public Observer {
 public:
  /// `run` must outlive this object.
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
    int times = 0;  ///< how many times the step has ended
  };
  void report(const Timed& timed);

  Run& run_;
  std::vector<Timed> steps_;          // in the order in which they first started
  std::vector<std::size_t> entered_;  // indices into `steps_`
};

template <class Work>
decltype(auto) Run::timed(std::string_view step, Work&& work) {
  RunObserver observer(*this);
  return as_step(observer, step, std::forward<Work>(work));
}

/// Runs an operation on INPUT, and returns its result. Options such as `auto` in `call` are replaced by the values
/// used.
template <class Call>
auto run_operation(Run& of, const MeshPtr& input, Call& call) {
  RunObserver observer(of);
  return run(input, call, observer);  // the function in the header of the call
}

}  // namespace gvd::app
