// A remesh from its options: the start, the relaxation, the remesh, and the searches over several of them.
//
// Sampled generators are relaxed first; listed ones stay where they are. The diagram of the relaxation's last iteration
// is that of the remesh. An exact number of vertices or a bound on the distance takes a search, in which each trial is
// a whole remesh.

#include "gvd/remesh_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "gvd/error.hpp"
#include "gvd/sampling.hpp"

namespace gvd {
namespace {

/// With an exact number, the fraction of the generators that may be exchanged before a start with fewer generators is
/// tried.
constexpr double kFewExchanged = 0.03;

/// How much smaller that start is, as a fraction of the generators, if the exchange has not made enough room.
constexpr double kFewerStart = 0.2;

/// The size of the copies on which generators are relaxed, if a copy has at most half of the mesh's faces.
/// docs/notes/performance.md compares sizes (Remeshes relaxed on copies).
constexpr CopySize kRemeshCopySize{1'500, 20'000, 8};

/// Smaller meshes have no copy by default if generators follow curves: generators on creases do not move on a copy, and
/// the least angle of the remesh falls (docs/notes/performance.md).
constexpr std::int64_t kCurvesAbove = 300'000;

/// Generators on the boundary do not move on a copy. If more than this fraction of them is on the boundary, a copy
/// makes the result worse: with a tenth it does, with a twenty-fifth it does not (docs/notes/performance.md).
constexpr double kMostOnBoundary = 0.08;

/// Whether a larger fraction of `count` generators would move along the boundary if all are spread evenly. Three of
/// each loop are fixed.
bool has_long_boundary(const Mesh& mesh, std::int32_t count) {
  double length = 0;
  for (const EdgeId e : mesh.edges()) length += mesh.is_boundary(e) ? mesh.length(e) : 0;
  const double on_boundary = length / even_spacing(compute_area(mesh), count);
  return on_boundary - 3 * compute_mesh_summary(mesh).boundary_loops > kMostOnBoundary * count;
}

/// Whether generators are on creases inside the surface. They do not move on a copy.
bool follows_creases(const Mesh& mesh, const RelaxationStart& start) {
  for (std::size_t i = 0; i < start.freedom.size(); ++i) {
    if (start.freedom[i] == Freedom::on_crease && !is_on_boundary(mesh, start.points[i])) return true;
  }
  return false;
}

/// A needle is longer than kNeedle times its height. If needles are more than kNeedleShare of the faces, paths cross
/// many of them, and a diagram takes as long as twenty diagrams of ordinary meshes of that size. Then the relaxation
/// has kNeedleIterations, unless the caller asks for more. Meshes of fewer than kNeedleFaces take only seconds for all
/// iterations.
constexpr double kNeedle = 1000, kNeedleShare = 0.2;
constexpr std::int32_t kNeedleFaces = 4096;
constexpr std::int32_t kNeedleIterations = 3;

bool has_needles(const Mesh& mesh) {
  const auto needles = std::count_if(mesh.faces().begin(), mesh.faces().end(), [&](FaceId f) {
    const auto& [length, twice_area] = mesh.shape(f);
    const double longest = *std::max_element(length.begin(), length.end());
    return twice_area * kNeedle < longest * longest;
  });
  return mesh.face_count() >= kNeedleFaces && double(needles) > kNeedleShare * mesh.face_count();
}

/// One remesh by its options.
class SurfaceRemesher {
 public:
  SurfaceRemesher(const Mesh& mesh, const SurfaceRemeshOptions& options) : mesh_(mesh), options_(options) {}

  /// Makes start, relaxation and options of the remesh. Returns an error about the number of generators.
  std::optional<Error> prepare() {
    auto start = make_start();
    if (Error* const error = std::get_if<Error>(&start)) return std::move(*error);
    made_.start = std::get<RelaxationStart>(std::move(start));
    if (options_.iterations() > 0) relax();
    made_.options = remesh_options();
    return std::nullopt;
  }

  /// Makes the mesh, with `vertex_count` vertices if that is given. Returns why there is none.
  std::optional<Error> remesh(std::optional<std::int64_t> vertex_count) {
    RemeshOptions& used = made_.options;
    if (vertex_count) used.vertex_count = vertex_count;
    used.earlier_diagrams = made_.relaxation ? made_.relaxation->diagrams : 0;
    auto result = made_.relaxation ? try_to_remesh(mesh_, std::move(made_.relaxation->diagram), used)
                                   : try_to_remesh(mesh_, made_.start.points, used);
    if (Error* const error = std::get_if<Error>(&result)) return std::move(*error);
    made_.result = std::get<RemeshResult>(std::move(result));
    used.max_added = made_.result.max_added;
    return std::nullopt;
  }

  /// The parts that have been made so far.
  SurfaceRemesh& made() { return made_; }

 private:
  void enter(std::string_view step) const {
    if (options_.on_step) options_.on_step(step);
  }

  bool is_listed() const { return !options_.start.listed.empty(); }

  RelaxationStartOptions start_options() const {
    RelaxationStartOptions asked = options_.start;
    // Most generators are added opposite others, and the relaxation moves these to gaps. With an exact number, there
    // are none.
    asked.constraints.leaves_room = options_.may_add() && options_.iterations() > 0 && !options_.exact_count;
    // A remesh that may add no generators can't follow creases that need more.
    if (!options_.may_add() && asked.constraints.prefers_creases) {
      asked.constraints.prefers_creases = false;
      asked.constraints.crease_angle.reset();
    }
    asked.copy.above = 0;
    asked.copy.size = kRemeshCopySize;
    if (options_.iterations() == 0) asked.copy.faces = 0;
    asked.threads = options_.remesh.diagram.threads;
    asked.progress = options_.remesh.diagram.progress;
    asked.on_step = options_.on_step;
    return asked;
  }

  OrError<RelaxationStart> make_start() const {
    RelaxationStartOptions asked = start_options();
    // By default small meshes have no copy where generators on curves need the mesh.
    const bool is_small = !asked.copy.faces && mesh_.face_count() <= kCurvesAbove;
    const bool has_count = !is_listed() && asked.sampling.kind != Sampling::covering_radius;
    const bool prefers_boundary = asked.constraints.prefers_boundary;
    if (is_small && prefers_boundary && has_count && has_long_boundary(mesh_, asked.sampling.count)) {
      asked.copy.faces = 0;
    }
    auto made = try_to_start_relaxation(mesh_, asked);
    auto* const start = std::get_if<RelaxationStart>(&made);
    if (start && is_small && follows_creases(mesh_, *start)) start->copy.reset();
    return made;
  }

  void relax() {
    enter("relaxation");
    LloydOptions options;
    const bool is_short = !options_.relaxation && has_needles(mesh_);
    options.max_iterations = is_short ? std::min(options_.iterations(), kNeedleIterations) : options_.iterations();
    made_.relaxation_ends_on_copy = !follows_creases(mesh_, made_.start);
    options.diagram = options_.remesh.diagram;
    options.progress = options_.remesh.diagram.progress;
    options.on_iteration = [this](std::int64_t iterations, double energy, const std::vector<SurfacePoint>&) {
      if (options_.on_iteration) options_.on_iteration(iterations, energy);
    };
    const LloydStages stages{.ends_on_copy = made_.relaxation_ends_on_copy, .keeps_extremities = !is_short};
    made_.relaxation = relax_generators(mesh_, made_.start, std::move(options), stages);
    made_.start.points = made_.relaxation->generators;
  }

  /// Fixes the vertices at the ends of thin limbs, which a fit would pull back or push too far out.
  std::vector<Freedom> freedom_of_vertices() const {
    std::vector<Freedom> freedom = made_.start.freedom;
    if (!made_.relaxation || made_.relaxation->extremities.empty()) return freedom;
    freedom.resize(made_.start.points.size(), Freedom::free);
    for (const GeneratorId g : made_.relaxation->extremities) freedom[g.index()] = Freedom::fixed;
    return freedom;
  }

  RemeshOptions remesh_options() const {
    const RelaxationStart& start = made_.start;
    RemeshOptions options = options_.remesh;
    options.creases = trace_creases(mesh_, start.creases, start.corner_distance);
    options.placement.method = options_.chosen_placement();
    options.may_decimate = !is_listed() && options_.start.constraints.fixed.empty();
    const std::vector<Freedom> freedom = freedom_of_vertices();
    for (std::size_t i = 0; i < freedom.size(); ++i) {
      if (freedom[i] == Freedom::fixed) options.placement.fixed.emplace_back(i);
    }
    if (options_.exact_count && is_listed()) options.refine = false;
    if (options_.exact_count && !is_listed()) options.vertex_count = std::ssize(start.points);
    const auto is_free = [](Freedom kind) { return kind == Freedom::free; };
    options.kept = std::find_if(freedom.begin(), freedom.end(), is_free) - freedom.begin();
    options.on_stage = [this](RemeshStage stage) {
      constexpr std::array<const char*, 5> kNames{"diagram", "dual", "placement", "search", "distance"};
      const char* const name = kNames[static_cast<std::size_t>(stage)];
      enter(name);
      report_progress(options_.remesh.diagram.progress, name, 0);
    };
    return options;
  }

  const Mesh& mesh_;
  const SurfaceRemeshOptions& options_;
  SurfaceRemesh made_;
};

double rms(const RemeshResult& result) { return std::max(result.input_to_output.rms, result.output_to_input.rms); }

/// A remesh, or why there is none.
struct Attempt {
  std::optional<SurfaceRemesh> made;
  std::optional<std::int64_t> vertex_count;  ///< the exact number that was asked for
  std::optional<Error> failure;
};

/// `wanted`: the number of vertices, if it is not to be that of the generators.
Attempt attempt(const Mesh& mesh, const SurfaceRemeshOptions& options, std::optional<std::int64_t> wanted = {}) {
  SurfaceRemesher remesher(mesh, options);
  Attempt attempt;
  attempt.failure = remesher.prepare();
  if (attempt.failure) return attempt;
  attempt.vertex_count = wanted ? wanted : remesher.made().options.vertex_count;
  attempt.failure = remesher.remesh(wanted);
  if (!attempt.failure) attempt.made = std::move(remesher.made());
  return attempt;
}

/// A remesh of the exact number of vertices from fewer generators, if many have to make room for added ones: then all
/// but the added ones are spread evenly. Empty if the first attempt needs no other.
Attempt attempt_with_fewer(const Mesh& mesh, const SurfaceRemeshOptions& options, const Attempt& first) {
  if (!first.vertex_count) return {};
  const auto wanted = static_cast<double>(*first.vertex_count);
  const double exchanged = first.made ? static_cast<double>(first.made->result.left_out) : kFewerStart * wanted;
  const auto fewer = static_cast<std::int32_t>(wanted - exchanged);
  if (exchanged <= kFewExchanged * wanted || fewer < 1) return {};
  SurfaceRemeshOptions other = options;
  other.start.sampling.count = fewer;
  if (other.start.sampling.kind == Sampling::covering_radius) other.start.sampling.kind = Sampling::farthest;
  other.on_step = {};
  if (options.on_step) options.on_step("other start");
  return attempt(mesh, other, first.vertex_count);
}

/// The better one of the attempts with all generators and with fewer.
Attempt attempt_both(const Mesh& mesh, const SurfaceRemeshOptions& options) {
  Attempt first = attempt(mesh, options);
  Attempt second = attempt_with_fewer(mesh, options, first);
  const bool is_better = second.made && (!first.made || rms(second.made->result) < rms(first.made->result));
  return is_better ? std::move(second) : std::move(first);
}

/// How many numbers of vertices are tried in place of one that has failed. Each costs up to three remeshes.
constexpr int kTriedCounts = 3;

/// Finds a number of vertices that works as an exact number, by trying the number that the mesh gets without that
/// option. Nothing if none of a few numbers works.
std::optional<std::int32_t> find_exact_count(const Mesh& mesh, const SurfaceRemeshOptions& options) {
  if (options.start.sampling.kind == Sampling::covering_radius) return std::nullopt;
  SurfaceRemeshOptions tried = options;
  tried.on_step = {};
  tried.on_iteration = {};
  for (int i = 0; i < kTriedCounts; ++i) {
    tried.exact_count = false;
    const Attempt any = attempt(mesh, tried);
    if (!any.made) throw *any.failure;
    if (any.made->result.decimated.components > 0) return std::nullopt;
    tried.start.sampling.count = any.made->result.mesh.vertex_count();
    tried.exact_count = true;
    if (attempt_both(mesh, tried).made) return tried.start.sampling.count;
  }
  return std::nullopt;
}

[[noreturn]] void refuse(const Mesh& mesh, const SurfaceRemeshOptions& options, const Attempt& failed) {
  const Error& error = *failed.failure;
  const bool is_sampled = options.start.listed.empty();
  if (!options.exact_count || !is_sampled || error.code() != ErrorCode::no_valid_result) throw error;
  const auto count = find_exact_count(mesh, options);
  const std::string advice =
      count ? fmt::format("; {} would do", *count) : "; leave \1exact_count\2 out, and there are as many as it takes";
  throw Error(error.code(), error.text() + advice, error.element());
}

/// Throws where no number of generators gives a mesh.
void check_remeshable(const Mesh& mesh, const SurfaceRemeshOptions& options) {
  if (options.iterations() < 0) {
    throw Error(ErrorCode::invalid_option, "the number of iterations must not be negative", options.iterations());
  }
  if (!(compute_area(mesh) > 0)) {
    throw Error(ErrorCode::precondition,
                "no triangle has an area, so there is nothing to remesh; give a surface with area");
  }
}

/// Tries numbers of generators for a bound on the distance.
class CountSearch {
 public:
  CountSearch(const Mesh& mesh, const SurfaceRemeshOptions& options, double distance) : mesh_(mesh), options_(options) {
    search_.target = distance;
    search_.most = static_cast<std::int32_t>(std::clamp<std::int64_t>(4LL * mesh.vertex_count(), 2000, 1000000000));
    options_.on_step = {};
    options_.on_iteration = {};
    options_.remesh.diagram.progress = [this, shown = options.remesh.diagram.progress](std::string_view, double) {
      return !shown || shown("search", static_cast<double>(done_) / search_.max_trials);
    };
  }

  Fewest run(const std::function<void(const CountTrial&)>& on_trial) {
    Fewest found = find_fewest(search_, [&](std::int32_t count) {
      const double error = try_count(count);
      ++done_;
      if (on_trial) on_trial({count, error});
      return error;
    });
    if (!found.count) refuse_distance(found);
    return found;
  }

 private:
  double try_count(std::int32_t count) {
    options_.start.sampling.count = count;
    const Attempt tried = attempt_both(mesh_, options_);
    if (tried.made) {
      has_result_ = true;
      const RemeshResult& result = tried.made->result;
      return std::max(result.input_to_output.hausdorff_bound, result.output_to_input.hausdorff_bound);
    }
    // If no number has given a mesh so far, larger ones would only take longer. A number out of range does not count.
    if (tried.failure->code() == ErrorCode::no_valid_result && !has_result_) refuse(mesh_, options_, tried);
    last_failure_ = tried.failure;
    return std::numeric_limits<double>::infinity();
  }

  [[noreturn]] void refuse_distance(const Fewest& found) const {
    const auto by_error = [](const CountTrial& a, const CountTrial& b) { return a.error < b.error; };
    const CountTrial& best = *std::min_element(found.trials.begin(), found.trials.end(), by_error);
    if (!std::isfinite(best.error)) throw *last_failure_;
    throw Error(ErrorCode::no_valid_result,
                fmt::format("no mesh of up to {} generators is within {:.6g} mesh units of the input; the nearest is "
                            "within {:.6g}; ask for that or more",
                            found.trials.back().count, search_.target, best.error));
  }

  const Mesh& mesh_;
  SurfaceRemeshOptions options_;
  FewestOptions search_;
  int done_ = 0;
  bool has_result_ = false;
  std::optional<Error> last_failure_;
};

}  // namespace

RelaxationStartOptions SurfaceRemeshOptions::default_start() {
  RelaxationStartOptions start;
  start.constraints.prefers_boundary = true;
  start.constraints.prefers_creases = true;
  start.constraints.crease_angle = kUsualCreaseAngle;
  return start;
}

SurfaceRemesh remesh_surface(const Mesh& mesh, const SurfaceRemeshOptions& options) {
  check_remeshable(mesh, options);
  Attempt best = attempt_both(mesh, options);
  if (!best.made) refuse(mesh, options, best);
  return std::move(*best.made);
}

Fewest find_remesh_count(const Mesh& mesh, const SurfaceRemeshOptions& options, double distance,
                         const std::function<void(const CountTrial&)>& on_trial) {
  check_remeshable(mesh, options);
  return CountSearch(mesh, options, distance).run(on_trial);
}

}  // namespace gvd
