// Relaxes generators by accelerated steps, or by Lloyd's steps if those fail.
//
// Lloyd's method (S. Lloyd, Least squares quantization in PCM, 1982) moves every generator to the centroid of its cell.
// Accelerated steps take the gradient of the energy from the vector to the centroid. A step is taken only if it lowers
// the energy, measured at the present level of precision, so the energies of the iterations decrease. At the first
// level, which ends sooner, cells are measured without diagrams; the last level uses the diagrams of the options.
// Energies of the two levels are not compared with each other, because they differ by the errors at the bisectors.
// docs/developer/lloyd.md derives what the steps compute.

#include "relaxer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

#include "accelerator.hpp"
#include "gvd/diagram_steps.hpp"
#include "gvd/error.hpp"
#include "iteration_record.hpp"

namespace gvd {
namespace {

/// Largest number of diagrams for Lloyd's step. For the first kOwnTrials of them, only generators that went too far
/// shorten their steps. After that all steps are halved each time, down to a thousandth.
constexpr int kLloydTrials = 16, kOwnTrials = 6;

/// The level without diagrams ends when iterations lower the energy by less than this fraction, because diagrams then
/// lower it more than further early iterations.
constexpr double kEarlyFall = 3e-5;

/// Number of accelerated iterations over which the fall of the energy is averaged.
constexpr int kStallWindow = 5;

/// Number of iterations that the default rule looks ahead.
constexpr int kIterationsAhead = 5;

/// After the first level has converged, exact cells may predict up to this many times the fall of the default rule
/// without a further iteration, which would cost a diagram for hardly any gain.
constexpr double kDoubt = 2;

/// The first level has certainly lowered the energy if it is below this fraction of the initial energy.
constexpr double kClearFall = 0.99;

/// Number of iterations between a relocation that failed and the next attempt.
constexpr std::size_t kRelocationPause = 10;

/// The fraction by which a relocation at the start must promise to lower the energy: about as much as the first step
/// does.
constexpr double kFirstRelocationGain = 0.05;

/// Largest number of diagrams for an accelerated step. After that, a Lloyd step is a better use of a diagram.
constexpr int kLineSearchTrials = 4;

/// The error of differences of energies measured without a diagram, as a fraction, because parts of needles come and
/// go.
constexpr double kSampledError = 0.003;

/// Bounds of the factor by which a generator shortens its own step.
constexpr double kLeastFactor = 0.1, kLargestFactor = 0.5;

/// Refuses an energy that is not finite. Such energies can't be compared, and all generators would seem to be at their
/// centroids.
void check_energy(double energy) {
  if (std::isfinite(energy)) return;
  throw Error(ErrorCode::precondition, "the energy is too large for a number; scale the density or the mesh down");
}

/// The fall of the energy if every generator moved to its centroid and all cells kept their borders.
double promised_fall(const RelaxationState& state) {
  double fall = 0;
  for (const GeneratorId g : state.moments.ids()) {
    fall += state.moments[g].mass * state.to_centroids[g.index()].squaredNorm();
  }
  return fall;
}

/// Shortens the steps of generators that went beyond the lowest point of their path, as far as the energy's slopes at
/// both ends of the path tell (the secant). `move` led from `before` to `after`, whose energy is too large; `scales`
/// are the factors of the steps. Returns whether there are such generators.
bool shorten_own_steps(const RelaxationState& before, const GeneratorMove& move, const RelaxationState& after,
                       std::vector<double>& scales) {
  const TangentField start = turned(move.turns, energy_gradient(before)), end = energy_gradient(after);
  bool is_any_shortened = false;
  for (std::size_t i = 0; i < scales.size(); ++i) {
    const double first = start[i].dot(move.step[i]), last = end[i].dot(move.step[i]);
    if (!(first < 0 && last > 0)) continue;
    scales[i] *= std::clamp(first / (first - last), kLeastFactor, kLargestFactor);
    is_any_shortened = true;
  }
  return is_any_shortened;
}

/// Measures how far a figure has come from its largest value to its tolerance, in orders of magnitude.
class Decline {
 public:
  /// `ratio`: the figure divided by its tolerance. It is not finite if the tolerance is 0, and is then ignored.
  void note(double ratio) {
    if (!std::isfinite(ratio)) return;
    largest_ = std::max(largest_, ratio);
    least_ = std::min(least_, std::max(1.0, ratio));
  }
  /// The share of the way, in [0, 1]; 0 as long as nothing is known.
  double share() const { return least_ < largest_ ? std::log(largest_ / least_) / std::log(largest_) : 0; }

 private:
  double largest_ = 1, least_ = std::numeric_limits<double>::max();
};

/// Iterates: decides which steps to try, which to take, and when to end.
class Relaxer {
 public:
  /// All arguments must outlive this object.
  Relaxer(const Mesh& mesh, const std::vector<SurfacePoint>& start, const LloydOptions& options,
          const RelaxerRules& rules)
      : mesh_(mesh),
        options_(options),
        least_promise_(rules.least_promise),
        start_(start),
        constraints_(mesh, options.freedom, options.creases),
        precision_{options.diagram, false, options.move_tolerance},
        accelerator_(mesh, constraints_, options.acceleration) {
    precision_.skips_diagram = rules.starts_by_faces && max_iterations(options) > 0 &&
                               options.acceleration != Acceleration::none && options.diagram.method == Method::exact;
    is_last_level_ = !precision_.skips_diagram || rules.ends_by_faces;
    precision_.diagram.progress = [this](std::string_view step, double fraction) {
      const auto begun = std::find(steps::kAll.begin(), steps::kAll.end(), step) - steps::kAll.begin();
      report((double(begun) + fraction) / double(steps::kAll.size()));
      return true;
    };
  }

  LloydResult run() {
    report();
    constraints_.check(start_);
    RelaxationState state = evaluate(start_);
    check_energy(state.energy);
    record_.initial_energy = state.energy;
    report_iteration(state);
    LloydResult result;
    result.stop = iterate(state);
    if (!is_last_level_) state = raise_level(state);
    result.initial_energy = record_.initial_energy;
    result.iterations = std::move(record_.iterations);
    result.diagrams = diagrams_;
    result.generators = std::move(state.generators);
    result.diagram = std::move(state.diagram);
    result.moments = std::move(state.moments);
    result.final_energy = state.energy;
    result.residual = state.residual;
    result.mean_cell_radius = state.mean_cell_radius;
    return result;
  }

 private:
  /// Iterates until a rule ends the last level, or until the iterations or the time are used up. When a rule ends an
  /// earlier level, the next level follows.
  LloydStop iterate(RelaxationState& state) {
    while (true) {
      const std::optional<LloydStop> stop = advance(state);
      if (!stop) continue;
      const bool is_used_up = *stop == LloydStop::max_iterations || *stop == LloydStop::time_limit;
      if (is_used_up || is_last_level_) return *stop;
      state = raise_level(state);
    }
  }

  /// Does an iteration. Returns a reason to end after it or instead of it, if there is one.
  std::optional<LloydStop> advance(RelaxationState& state) {
    if (is_at_centroids(state)) return LloydStop::centroids;
    if (std::ssize(record_.falls) >= max_iterations(options_)) return LloydStop::max_iterations;
    if (options_.is_time_over && options_.is_time_over()) return LloydStop::time_limit;
    if (promised_fall(state) < least_promise_ * state.energy) return LloydStop::prediction;
    if (relocate(state)) return std::nullopt;
    report();
    const std::optional<ProposedSteps> proposed = accelerator_.propose(state);
    if (proposed && is_settled(state, *proposed)) return LloydStop::prediction;
    if (!(proposed && descend_accelerated(state, *proposed))) {
      if (!is_last_level_ || !descend(state)) return LloydStop::no_descent;
    }
    const double tolerance = energy_tolerance(options_).value_or(0);
    const double least = std::max(is_last_level_ ? 0 : kEarlyFall, tolerance);
    const int window = options_.acceleration == Acceleration::none ? 1 : kStallWindow;
    const std::optional<double> fall = record_.sum_falls(window);
    if (fall) energy_decline_.note(*fall / (window * tolerance));
    if (!fall || *fall >= least * window) return std::nullopt;
    return is_at_centroids(state) ? LloydStop::centroids : LloydStop::energy;
  }

  /// Whether the default rule ends the relaxation, because the proposed steps and the last two iterations show that it
  /// has converged.
  bool is_settled(const RelaxationState& state, const ProposedSteps& proposed) {
    if (energy_tolerance(options_)) return false;
    const double ahead = kIterationsAhead * std::max(proposed.prediction / state.energy, record_.largest_fall(2));
    energy_decline_.note(ahead / kSettledFall);
    return ahead < (is_first_level_ ? 1 : kDoubt) * kSettledFall;
  }

  bool is_at_centroids(const RelaxationState& state) {
    const double limit = options_.move_tolerance * state.mean_cell_radius;
    // The first level does not end the relaxation, so its distance to the centroids counts as at least twice the
    // tolerance.
    way_decline_.note(std::max(state.residual / limit, is_last_level_ ? 1.0 : 2.0));
    return state.residual <= limit;
  }

  /// Evaluates the same generators with better diagrams, and measures the energy of the last iteration again.
  RelaxationState raise_level(const RelaxationState& early) {
    const bool has_moved = early.generators != start_;
    const bool has_fallen = early.energy < kClearFall * record_.initial_energy;
    is_first_level_ = false;
    is_last_level_ = true;
    precision_.skips_diagram = false;
    RelaxationState state = evaluate(early.generators);
    if (has_moved && (!has_fallen || !(state.energy < record_.initial_energy))) {
      state = lower_of(std::move(state), evaluate(start_));
    }
    record_.restate(state.energy, precision_);
    report_iteration(state);
    return state;
  }

  /// Returns `state`, or `start` if that has no more energy. The early iterations are merged into one or none.
  RelaxationState lower_of(RelaxationState state, RelaxationState start) {
    record_.initial_energy = start.energy;
    record_.merge_all();
    if (state.energy < start.energy) return state;
    record_.iterations.clear();
    accelerator_.forget();
    return start;
  }

  RelaxationState evaluate(const std::vector<SurfacePoint>& generators) {
    ++diagrams_;
    RelaxationState state = evaluate_generators(mesh_, generators, precision_, options_.density, constraints_);
    state.rest = refused_rests_.allowed(record_.falls.size(), std::move(state.rest));
    return state;
  }

  /// Does an iteration that relocates generators, if it promises more than the last iteration gave. As long as the
  /// energy does not fall, drops the less valuable half of the relocations. Returns false if none is left; the next
  /// attempt then comes some iterations later.
  bool relocate(RelaxationState& state) {
    if (!relocates(options_) || record_.iterations.size() < next_relocation_) return false;
    report();  // with a million generators, each of the next steps takes seconds
    const std::vector<Relocation> plan = plan_relocations(mesh_, options_.density, state, constraints_);
    if (!(total_gain(plan) > (record_.falls.empty() ? kFirstRelocationGain : record_.falls.back()) * state.energy))
      return false;
    for (std::size_t count = plan.size(); count > plan.size() / 8; count /= 2) {
      if (!take_if_below(state.energy, state, state.rest, relocate_generators(mesh_, state, plan, count))) return true;
    }
    next_relocation_ = record_.iterations.size() + kRelocationPause;
    return false;
  }

  /// Does an iteration by the accelerator's steps. Until the energy falls enough, shortens them or minimises the model
  /// of the energy for shorter ones. Returns false if the energy never falls enough; the accelerator then forgets its
  /// history.
  bool descend_accelerated(RelaxationState& state, ProposedSteps proposed) {
    double scale = 1;
    for (int trial = 0; trial < kLineSearchTrials; ++trial) {
      report();
      Rests rests = refused_rests_.allowed(record_.falls.size(), proposed.rest);
      GeneratorMove next = move_generators(mesh_, state, scaled(proposed.steps, scale), constraints_, rests);
      next.scale = scale;
      next.prediction = proposed.prediction;
      next.by = options_.acceleration;
      const double before = state.energy, limit = before + kSufficientFall * scale * proposed.slope;
      const std::optional<RelaxationState> rejected = take_if_below(limit, state, rests, next);
      if (!rejected) return true;
      const bool is_any_refused = refused_rests_.note(record_.falls.size(), *rejected, rests);
      if (is_any_refused && rise_by_slopes(state, next, *rejected) < limit - before) continue;
      const double shorter = shorter_scale(scale, proposed.slope, rejected->energy - before);
      if (proposed.is_of_model) {
        accelerator_.shorten(*std::max_element(next.length.begin(), next.length.end()), shorter, state);
        std::optional<ProposedSteps> again = accelerator_.propose(state);
        if (!again) break;
        proposed = std::move(*again);
      } else {
        accelerator_.distrust();
        scale = shorter;
      }
    }
    accelerator_.forget();
    return false;
  }

  /// Does an iteration by Lloyd's steps, and shortens steps that went too far until the energy falls. Returns false if
  /// it never does.
  bool descend(RelaxationState& state) {
    std::vector<double> scales(state.generators.size(), 1);
    const Rests rests = refused_rests_.allowed(record_.falls.size(), state.rest);
    for (int trial = 0; trial < kLloydTrials; ++trial) {
      GeneratorMove next =
          move_generators(mesh_, state, scaled(state.to_centroids, scales), constraints_, trial == 0 ? rests : Rests());
      next.scale = *std::max_element(scales.begin(), scales.end());
      const std::optional<RelaxationState> rejected = take_if_below(state.energy, state, rests, next);
      if (!rejected) return true;
      const bool is_any_shortened = shorten_own_steps(state, next, *rejected, scales);
      if (is_any_shortened && trial < kOwnTrials) continue;
      for (double& scale : scales) scale *= 0.5;
    }
    return false;
  }

  /// Whether the energy is below the limit after a move. Near the end, energies differ by less than their error. Then
  /// the slopes at both ends of the paths, which are more accurate, decide, unless the energy exceeds the initial
  /// energy.
  /// Source: the approximate Wolfe conditions of Hager and Zhang, A new conjugate gradient method with guaranteed descent
  /// and an efficient line search, 2005.
  bool is_better(double limit, const RelaxationState& state, const GeneratorMove& next,
                 const RelaxationState& moved) const {
    if (moved.energy < limit) return true;
    const double error = precision_.skips_diagram ? kSampledError : kEnergyError;
    if (next.relocated > 0 || moved.energy > std::min(record_.initial_energy, state.energy * (1 + error))) return false;
    return rise_by_slopes(state, next, moved) < limit - state.energy;
  }

  /// Moves the generators if their energy is then below the limit. Otherwise returns the state that they would have, or
  /// a copy of `state` if none moves. `rests`: where generators would rest, whether or not they go there now.
  std::optional<RelaxationState> take_if_below(double limit, RelaxationState& state, Rests rests,
                                               const GeneratorMove& next) {
    if (next.to == state.generators) return state;
    RelaxationState moved = evaluate(next.to);
    if (!is_better(limit, state, next, moved)) return moved;
    refused_rests_.note(record_.falls.size(), moved, rests);
    record_.add(next, state.energy, moved.energy, precision_);
    record_.restate(moved.energy, precision_);
    report_iteration(moved);
    if (next.relocated > 0) {
      accelerator_.forget();
    } else {
      accelerator_.learn(state, rests, next, moved);
    }
    state = std::move(moved);
    return std::nullopt;
  }

  /// Reports progress. `share`: the part of the next iteration that is done, if its first step is taken. Most
  /// relaxations end by a tolerance long before the last iteration, so the progress is also measured by the orders of
  /// magnitude by which the falls of the energy or the distances to the centroids have approached their tolerance. The
  /// largest measure counts.
  void report(double share = 0) const {
    const double done = double(record_.iterations.size()) + std::min(share, 1.0);
    const double by_count = done / std::max(1.0, double(max_iterations(options_)));
    report_progress(options_.progress, "relaxation",
                    std::min(1.0, std::max({by_count, energy_decline_.share(), way_decline_.share()})));
  }

  void report_iteration(const RelaxationState& state) const {
    if (options_.on_iteration) options_.on_iteration(std::ssize(record_.iterations), state.energy, state.generators);
  }

  const Mesh& mesh_;
  const LloydOptions& options_;
  const double least_promise_;
  const std::vector<SurfacePoint>& start_;
  const GeneratorConstraints constraints_;
  Precision precision_;         // the present level
  bool is_first_level_ = true;  // there are one or two levels
  bool is_last_level_ = true;
  std::int64_t diagrams_ = 0;  // number of computed states
  RefusedRests refused_rests_;
  Accelerator accelerator_;
  IterationRecord record_;
  std::size_t next_relocation_ = 0;  // number of iterations before the next attempt
  Decline energy_decline_, way_decline_;
};

}  // namespace

LloydResult relax_on_mesh(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const LloydOptions& options,
                          const RelaxerRules& rules) {
  return Relaxer(mesh, generators, options, rules).run();
}

}  // namespace gvd
