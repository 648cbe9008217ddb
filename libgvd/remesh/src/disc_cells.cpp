// Adds generators until every cell is a disc, and then removes generators again as far as all cells stay discs.
//
// Discs need fewer generators than the dual of a remesh: two cells around a loop may be enough, instead of three. But
// both have to reach equally far along a limb, or one of them surrounds the limb beyond the other. The point opposite
// the generator does that (opposite_points.cpp), and other points may leave fewer cells to divide elsewhere. A forecast
// by the labels of vertices (disc_forecast.cpp) ranks candidates in a fraction of the time of a diagram. If the mesh is
// too coarse for a forecast, as on a needle whose edges are longer than its girth, the opposite point comes first.
// After some rounds in vain, candidates are tried on the part of the mesh round the cell; with few given generators
// that part is the whole mesh, and each trial a diagram of it. The search of a remesh then finds what was added in
// vain; only the discs count for it. A closed component takes two generators, and a handle three, because two cells
// meet only in closed curves there and leave annuli.
#include "gvd/disc_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/least.hpp"
#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"
#include "repair/disc_forecast.hpp"
#include "repair/fewer_generators.hpp"
#include "repair/local_dual.hpp"
#include "repair/propose_generators.hpp"

namespace gvd {
namespace {

/// The largest number of candidates that are tried in one cell.
constexpr std::size_t kCandidates = 24;

/// The fraction of the remaining trials that may follow a success. Without any, three of 54 runs added one generator
/// more; with all of them, the first of several cells would use up all trials on a large mesh.
constexpr double kTrialsAfterSuccess = 1.0 / 8;

/// Cells that are divided in the same round have no common bisector: a change alters its neighbours.
constexpr int kRingsApart = 1;

/// The number of rounds without success after which forecasts are no longer trusted.
constexpr std::size_t kVainForecasts = 4;

/// The largest number of windows of all trials, and of the search. `events` is that of the given diagram.
double find_most_events(double events) {
  return std::clamp(kDiscSearchWindows, kDiscSearch * events, kMostDiscSearch * events);
}

class DiscMaker {
 public:
  /// All must outlive this.
  DiscMaker(const Mesh& mesh, const Diagram& given, const DiscOptions& options)
      : mesh_(mesh),
        options_(options),
        given_(given.generators.size()),
        max_added_(options.max_added.value_or(default_max_added(compute_mesh_summary(mesh), given_))),
        most_events_(find_most_events(double(given.report.propagation_events))) {
    result_.diagram = given;
  }

  DiscCells run() {
    for (auto cells = find_non_discs(result_.diagram); !cells.empty(); cells = find_non_discs(result_.diagram)) {
      add_generators(cells);
    }
    if (added() > 0) search_fewer();
    result_.added = added();
    return std::move(result_);
  }

 private:
  std::int64_t added() const { return std::int64_t(result_.diagram.generators.size() - given_); }

  /// Divides cells that are apart from each other.
  void add_generators(const std::vector<GeneratorId>& cells) {
    if (result_.rounds == 0) first_ = cells.size();
    if (added() >= max_added_ || result_.rounds >= kMaxRemeshRounds) refuse(cells, describe_limit(cells.size()));
    DiscCandidates candidates(mesh_, result_.diagram, kCandidates);
    if (!forecast_) forecast_.emplace(mesh_);
    forecast_->take(result_.diagram);
    std::vector<SurfacePoint> generators = result_.diagram.generators;
    CellFlags near_change(generators.size(), 0);
    for (const GeneratorId cell : cells) {
      if (std::int64_t(generators.size() - given_) >= max_added_) break;
      if (near_change[cell]) continue;
      std::vector<SurfacePoint> points = candidates.list(cell);
      if (points.empty()) continue;
      generators.push_back(choose_point(cell, std::move(points)));
      const CellFlags rings = grow_rings(result_.diagram, {cell}, kRingsApart);
      for (const GeneratorId g : rings.ids()) near_change[g] |= rings[g];
    }
    if (generators.size() == result_.diagram.generators.size()) {
      refuse(cells, "every point for a new generator is too close to another one; move or remove generators there");
    }
    const int before = count_all_defects();
    result_.diagram = compute_diagram(mesh_, generators, options_.diagram);
    ++result_.rounds;
    vain_rounds_ = count_all_defects() < before ? 0 : vain_rounds_ + 1;
  }

  int count_all_defects() const {
    int all = 0;
    for (const Cell& each : result_.diagram.cells) all += count_disc_defects(each);
    return all;
  }

  SurfacePoint choose_point(GeneratorId cell, std::vector<SurfacePoint> candidates) {
    const bool foretells = forecast_->tells(cell) && !is_coarse(cell, candidates.front());
    if (foretells && vain_rounds_ < kVainForecasts) return choose_by_forecast(cell, candidates);
    if (vain_rounds_ == 0) return candidates.front();
    const std::size_t first = vain_rounds_ % candidates.size();
    std::rotate(candidates.begin(), candidates.begin() + std::ptrdiff_t(first), candidates.end());
    return choose_by_trials(cell, candidates);
  }

  /// Whether edges at a generator are longer than the way to the point opposite it. Then the labels of vertices tell
  /// little.
  bool is_coarse(GeneratorId cell, const SurfacePoint& opposite) const {
    const SurfacePoint& generator = result_.diagram.generators[cell.index()];
    const double across = (position(mesh_, opposite) - position(mesh_, generator)).norm();
    return std::ranges::any_of(Mesh::halfedges(generator.face), [&](HalfedgeId h) { return mesh_.length(h) > across; });
  }

  SurfacePoint choose_by_forecast(GeneratorId cell, const std::vector<SurfacePoint>& candidates) {
    Least<SurfacePoint, DiscForecast::Outcome> best{candidates.front(), DiscForecast::kWorst};
    for (const SurfacePoint& point : candidates) best.offer(forecast_->find(point, cell), point);
    return best.value;
  }

  /// The candidate that removes the most defects, as far as trials are allowed. Once a candidate removes all defects of
  /// the cell, few more are tried, because one of them may mend other cells as well.
  SurfacePoint choose_by_trials(GeneratorId cell, const std::vector<SurfacePoint>& candidates) {
    const LocalDual local(mesh_, result_.diagram, {cell}, {}, options_.diagram);
    const int own = count_disc_defects(result_.diagram.cells[cell]);
    const int all = count_all_defects();
    Least<SurfacePoint, int> best{candidates.front(), std::numeric_limits<int>::max()};
    const double few = events_ + (most_events_ - events_) * kTrialsAfterSuccess;
    for (std::size_t i = 0; i < candidates.size() && best.rank > -all; ++i) {
      if (events_ >= (best.rank > -own ? most_events_ : few)) break;
      if (const auto change = try_point(local, candidates[i])) best.offer(*change, candidates[i]);
    }
    return best.value;
  }

  /// The change in the number of defects with one more generator. Nothing if the part can't tell.
  std::optional<int> try_point(const LocalDual& local, const SurfacePoint& point) {
    const auto with = local.compute({point});
    events_ += double(with ? with->diagram.report.propagation_events : 0);
    if (!with) return std::nullopt;
    int change = 0;
    for (const Cell& cell : with->diagram.cells) {
      if (!with->inner[cell.generator]) continue;
      const std::size_t i = cell.generator.index();
      const bool is_new = i >= local.kept().size();
      change += count_disc_defects(cell) - (is_new ? 0 : count_disc_defects(result_.diagram.cells[local.kept()[i]]));
    }
    return change;
  }

  /// The end of a message: how the rounds went, and advice. More generators help, because a cell that is no longer than
  /// the surface is thick is a disc.
  std::string describe_limit(std::size_t left) const {
    const std::string added_so_far = fmt::format("{} added in {}", counted(added(), "generator was", "generators were"),
                                                 counted(result_.rounds, "round", "rounds"));
    const std::string advice = options_.max_added ? "\1+, or raise |max_added\2" : "";
    return fmt::format(
        "{}, and {} became {}; give so many generators that they are closer to each other than the way "
        "round the surface there{}",
        added_so_far, counted(std::int64_t(first_), "such cell", "such cells"), left, advice);
  }

  [[noreturn]] void refuse(const std::vector<GeneratorId>& cells, const std::string& why) const {
    const Cell& cell = result_.diagram.cells[cells.front()];
    const Vec3 at = position(mesh_, result_.diagram.generators[cell.generator.index()]);
    throw Error(
        ErrorCode::no_valid_result,
        fmt::format("the cell of generator {} at ({:.6g}, {:.6g}, {:.6g}) is no disc (Euler characteristic {}){}: {}",
                    cell.generator.value(), at.x(), at.y(), at.z(), cell.euler_characteristic,
                    cells.size() > 1 ? fmt::format(", nor are {} more", cells.size() - 1) : "", why),
        cell.generator.value());
  }

  void search_fewer() {
    GeneratorSearch search;
    search.kept = given_;
    search.least = given_ + 1;  // the given cells alone are not all discs
    search.most_events = std::int64_t(most_events_);
    search.diagram = options_.diagram;
    search.only = DualProperty::cell_is_disc;
    search.accept = [this](const std::vector<SurfacePoint>& generators) { return take_if_discs(generators); };
    result_.search_cut_short = !search_fewer_generators(mesh_, result_.diagram, search);
  }

  bool take_if_discs(const std::vector<SurfacePoint>& generators) {
    Diagram diagram = compute_diagram(mesh_, generators, options_.diagram);
    if (!find_non_discs(diagram).empty()) return false;
    result_.diagram = std::move(diagram);
    return true;
  }

  const Mesh& mesh_;
  const DiscOptions& options_;
  const std::size_t given_;
  const std::int64_t max_added_;
  const double most_events_;              // windows propagated in trials, and in the search
  double events_ = 0;                     // of trials
  std::optional<DiscForecast> forecast_;  // set once a cell is not a disc
  /// Consecutive rounds that removed no defect. After each, another candidate comes first, which is taken if none is
  /// better: the point opposite a generator divides a straight limb, but creeps along a bent one.
  std::size_t vain_rounds_ = 0;
  std::size_t first_ = 0;  // number of cells of the given generators that are not discs
  DiscCells result_;
};

}  // namespace

std::vector<GeneratorId> find_non_discs(const Diagram& diagram) {
  std::vector<GeneratorId> cells;
  for (const Cell& cell : diagram.cells) {
    if (!cell.is_disc()) cells.push_back(cell.generator);
  }
  return cells;
}

DiscCells make_discs(const Mesh& mesh, const Diagram& diagram, const DiscOptions& options) {
  if (options.max_added && *options.max_added < 0) {
    throw Error(ErrorCode::invalid_option, "max_added must not be negative", *options.max_added);
  }
  if (!options.diagram.weights.empty() || !diagram.weights.empty()) {
    throw Error(ErrorCode::invalid_option, "generators can't be added to those with weights; make discs first");
  }
  return DiscMaker(mesh, diagram, options).run();
}

}  // namespace gvd
