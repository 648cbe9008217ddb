#include "remesh/search_count.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlohmann/json.hpp>

#include "gvd/error.hpp"
#include "gvd/find_fewest.hpp"

namespace gvd::app {
namespace {

/// Most generators that are tried, for each vertex of the input.
constexpr std::int64_t kMostPerVertex = 4;
/// For meshes with few vertices.
constexpr std::int64_t kLeastMost = 2000;

double distance_of(const RemeshResult& result) {
  return std::max(result.input_to_output.hausdorff, result.output_to_input.hausdorff);
}

void report_trials(Run& run, double target, const Fewest& found) {
  nlohmann::ordered_json trials = nlohmann::ordered_json::array();
  for (const CountTrial& trial : found.trials) {
    const auto distance = std::isfinite(trial.error) ? nlohmann::ordered_json(trial.error) : nullptr;
    trials.push_back({{"n", trial.count}, {"hausdorff", distance}});
  }
  run.report().results()["search"] = {{"hausdorff", target}, {"trials", std::move(trials)}};
}

/// Distances of remeshes, infinite where a number of generators gives none.
class Trials {
 public:
  explicit Trials(const std::function<RemeshResult(Run& trial, std::int32_t count)>& remesh_with)
      : remesh_with_(remesh_with) {}

  /// The distance of the remesh with `count` generators. Infinite where these are fewer than fixed generators and
  /// features, or too few for a valid mesh while none may be added. Throws Error{no_valid_result} until a trial has
  /// given a mesh: larger trials of an input that has no remesh would take long.
  double distance(Run& run, std::int32_t count) {
    Console silent("", {}, true, false);
    Run trial("", run.options(), silent);
    try {
      const double distance = distance_of(remesh_with_(trial, count));
      has_result_ = true;
      return distance;
    } catch (const Error& error) {
      const bool too_few = error.code() == ErrorCode::no_valid_result && has_result_;
      if (error.code() != ErrorCode::precondition && !too_few) throw;
      last_failure_ = std::current_exception();
      return std::numeric_limits<double>::infinity();
    }
  }

  /// Only where a trial has failed.
  [[noreturn]] void rethrow_failure() const { std::rethrow_exception(last_failure_); }

 private:
  const std::function<RemeshResult(Run& trial, std::int32_t count)>& remesh_with_;
  bool has_result_ = false;
  std::exception_ptr last_failure_;
};

[[noreturn]] void refuse(double target, const Fewest& found, const Trials& trials) {
  const auto by_error = [](const CountTrial& a, const CountTrial& b) { return a.error < b.error; };
  const CountTrial& best = *std::min_element(found.trials.begin(), found.trials.end(), by_error);
  if (!std::isfinite(best.error)) trials.rethrow_failure();
  throw Error(
      ErrorCode::no_valid_result,
      fmt::format("--error: no mesh of up to {} generators is within {:.6g} mesh units of the input; the nearest "
                  "is within {:.6g}; ask for that or more",
                  found.trials.back().count, target, best.error));
}

}  // namespace

std::int32_t search_count(Run& run, const Mesh& mesh,
                          const std::function<RemeshResult(Run& trial, std::int32_t count)>& remesh_with) {
  const ErrorBound& bound = *run.options().generators.error;
  FewestOptions options;
  options.target = bound.value * (bound.in_diagonals ? mesh.bbox_diagonal() : 1);
  options.most =
      static_cast<std::int32_t>(std::clamp<std::int64_t>(kMostPerVertex * mesh.vertex_count(), kLeastMost, 1000000000));
  double done = 0;
  Trials trials(remesh_with);
  const Fewest found = run.timed("trials", [&] {
    return find_fewest(options, [&](std::int32_t count) {
      run.console().set_status(fmt::format("{} generators", count));
      report_progress(run.progress(), "search", done++ / options.max_trials);
      const double distance = trials.distance(run, count);
      run.console().detail(std::isfinite(distance)
                               ? fmt::format("{} generators: distance {:.6g} mesh units", count, distance)
                               : fmt::format("{} generators: no mesh", count));
      return distance;
    });
  });
  run.console().set_status("");
  report_trials(run, options.target, found);
  if (!found.count) refuse(options.target, found, trials);
  return *found.count;
}

}  // namespace gvd::app
