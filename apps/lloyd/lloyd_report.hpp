#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/constraint_options.hpp"
#include "gvd/diagram.hpp"
#include "gvd/io/view.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

// What gvd-lloyd tells of a relaxation: members of the report, notes, the table of --trace, and the scenes of --view.
namespace gvd::app {

/// The command's own options.
struct OwnOptions {
  LloydOptions relaxation;
  ConstraintOptions constraints;
  std::optional<double> time_limit;  ///< of the relaxation, seconds, >= 0
};

/// The values of --accelerate, which the report gives for each iteration too.
const std::vector<std::pair<std::string, Acceleration>>& acceleration_names();

/// Adds the command's own options to the member `options` of the report.
void report_own_options(nlohmann::ordered_json& options, const OwnOptions& own);

/// Adds the iterations, and why they ended, to the member `results` of the report.
void report_relaxation(nlohmann::ordered_json& results, const LloydResult& result);

/// One line each: iterations and energies, and how even the areas are.
std::vector<std::string> describe_relaxation(const LloydResult& result);

/// When the energy of each iteration was known, and the generators then. The library reads no clock.
class RelaxationTrace {
 public:
  /// Seconds since this was made.
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

  /// To be called from LloydOptions::on_iteration. Iterations that count as one with those before are forgotten.
  void note(std::int64_t iterations, const std::vector<SurfacePoint>& generators);

  /// The generators after so many iterations; 0: at the start.
  const std::vector<SurfacePoint>& generators(std::size_t iterations) const { return generators_[iterations]; }

  /// A table in CSV: a row for the start, and one for each iteration. `method`: of the run's diagrams.
  /// Of two runs only the last column, the seconds since the relaxation began, differs.
  void write(std::ostream& out, const LloydResult& result, const Method& method) const;

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  // Of the start, and of each iteration.
  std::vector<double> seconds_;
  std::vector<std::vector<SurfacePoint>> generators_;
};

/// The scenes of the page: the relaxed generators, the start, and iterations between them, evenly over the run, at most
/// twelve together. `options`: of their diagrams, which are computed but for the last.
std::vector<ViewScene> make_iteration_scenes(const Mesh& mesh, const LloydResult& relaxed, const RelaxationTrace& trace,
                                             const DiagramOptions& options);

}  // namespace gvd::app
