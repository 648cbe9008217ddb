// Finds additive weights of the generators that give cells their shares.
//
// If the weight of a generator grows by a small step, the bisectors of its cell move inwards, and across each bisector
// the cell loses the step times the integral of density / |difference of the two gradients|. So the derivatives of the
// masses form a weighted graph of the neighbours, whose Laplacian gives Newton's step. A step is halved until the error
// falls, no cell vanishes, and no cell becomes much smaller than at the start or than its target.
//
// Masses jump when a bisector passes a vertex at which paths bend, because the surface behind it is equally far from
// both generators. The derivatives do not predict such a jump, so even a short step does not lower the error. Then the
// two cells that differ most from the prediction are tied: they share a common target, and the difference of their
// weights stays the same.
//
// Source: Kitagawa, Merigot and Thibert (2019). Tied cells are our addition; the costs of the paper have no ties of
// positive area.
// Invariant: the state always belongs to a computed diagram. The result does not depend on the number of threads.
#include "balance_search.hpp"

#include <fmt/format.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <utility>

#include "balance_rates.hpp"
#include "base/barycentric.hpp"
#include "base/parallel_chunks.hpp"
#include "base/union_find.hpp"
#include "diagram/cell_parts.hpp"
#include "gvd/error.hpp"

namespace gvd {
namespace {

/// A cell stays larger than this fraction of its target, or of the least share of a cell at the start (Kitagawa et al.,
/// algorithm 1).
constexpr double kLeastShare = 0.5;

/// A step must lower the error by at least this fraction of what its length promises.
constexpr double kEnoughDescent = 0.1;

/// If a step shorter than this fraction of Newton's step does not lower the error, there is a jump, which the
/// derivatives do not predict. A step by which a cell vanishes is halved a few times more.
constexpr double kShortStep = 0.05, kShortestStep = 0.01;

/// Added to the diagonal of the Laplacian, relative to its largest entry: weights are determined only up to a constant
/// in each component of the mesh.
constexpr double kShift = 1e-12;

/// A diagram with its masses and rates.
struct State {
  Diagram diagram;
  std::vector<double> masses;
  std::vector<double> rates;  // by bisector
};

/// The targets of the cells: the mass of each component of the mesh, divided by the shares of its generators.
std::vector<double> find_targets(const Mesh& mesh, const State& state, const std::vector<double>& shares) {
  const std::vector<SurfacePoint>& generators = state.diagram.generators;
  const IdVector<FaceId, std::int32_t> component = compute_face_components(mesh);
  std::vector<double> mass(mesh.face_count(), 0.0), share(mesh.face_count(), 0.0);  // of each component
  const auto own_share = [&](std::size_t g) { return shares.empty() ? 1 : shares[g]; };
  for (std::size_t g = 0; g < generators.size(); ++g) {
    mass[component[generators[g].face]] += state.masses[g];
    share[component[generators[g].face]] += own_share(g);
  }
  std::vector<double> targets;
  for (std::size_t g = 0; g < generators.size(); ++g) {
    const std::int32_t c = component[generators[g].face];
    targets.push_back(mass[c] * (own_share(g) / share[c]));
    if (targets.back() > 0 && std::isfinite(targets.back())) continue;
    throw Error(ErrorCode::precondition, fmt::format("generator {}: its component has no area", g), std::int64_t(g));
  }
  return targets;
}

/// The sets of cells that share a target. Initially, each cell is a set of its own.
class TiedCells {
 public:
  explicit TiedCells(std::size_t cells) : sets_(cells) {}

  /// The smallest member of a cell's set.
  std::size_t of(GeneratorId cell) { return static_cast<std::size_t>(sets_.find(cell.value())); }
  /// Ties two cells. Returns false if they are already tied.
  bool tie(GeneratorId a, GeneratorId b) {
    if (of(a) == of(b)) return false;
    sets_.unite(a.value(), b.value());
    return true;
  }
  /// The sums over the sets, each stored at the set's first member; 0 elsewhere.
  std::vector<double> sums(const std::vector<double>& values) {
    std::vector<double> sums(values.size(), 0.0);
    for (std::size_t i = 0; i < values.size(); ++i) sums[of(GeneratorId(i))] += values[i];
    return sums;
  }
  std::vector<std::vector<GeneratorId>> list() {
    std::vector<std::vector<GeneratorId>> members(sets_.size());
    for (std::size_t i = 0; i < members.size(); ++i) members[of(GeneratorId(i))].emplace_back(i);
    std::erase_if(members, [](const auto& set) { return set.size() < 2; });
    return members;
  }

 private:
  UnionFind sets_;
};

/// The root mean square of mass / target - 1 over the sets of cells.
double find_variation(const std::vector<double>& masses, const std::vector<double>& targets, TiedCells& tied) {
  const std::vector<double> mass = tied.sums(masses), target = tied.sums(targets);
  double sum = 0;
  for (std::size_t i = 0; i < mass.size(); ++i) {
    const double error = target[i] > 0 ? mass[i] / target[i] - 1 : 0;
    sum += error * error;
  }
  return std::sqrt(sum / double(mass.size()));
}

class Balancer {
 public:
  Balancer(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const BalanceOptions& options)
      : mesh_(mesh),
        generators_(generators),
        options_(options),
        tied_(generators.size()),
        weights_(options.diagram.weights) {
    if (weights_.empty()) weights_.assign(generators.size(), 0);
  }

  /// Runs the search. Returns a generator without a cell if the initial weights leave one.
  std::variant<BalancedDiagram, HiddenGenerator> run() {
    auto start = compute(weights_);
    if (const auto* const hidden = std::get_if<HiddenGenerator>(&start)) return *hidden;
    state_ = std::get<State>(std::move(start));
    targets_ = find_targets(mesh_, state_, options_.shares);
    variation_ = find_variation(state_.masses, targets_, tied_);
    least_share_ = kLeastShare * std::min(1.0, least_share(state_));
    double length = 1;
    while (!converged() && diagrams_ < options_.max_diagrams) {
      const std::vector<double> step = newton_step();
      length = std::min(1.0, 2 * length);
      if (!search(step, length)) break;
    }
    return take_result();
  }

 private:
  bool converged() const { return variation_ <= options_.tolerance; }

  std::variant<State, HiddenGenerator> compute(const std::vector<double>& weights) {
    ++diagrams_;
    State state;
    DiagramOptions options = options_.diagram;
    options.weights = weights;
    const ParallelChunks parallel(options.threads, options.progress);
    const auto read = [&](const WorkingMesh& working, const WindowField& field, const Diagram& diagram) {
      state.rates = integrate_balance_rates(working, field, diagram, options_.density, parallel);
    };
    auto computed = try_to_compute_and_read(mesh_, generators_, options, KeepWindows::near_bisectors, read);
    if (const auto* const hidden = std::get_if<HiddenGenerator>(&computed)) return *hidden;
    state.diagram = std::get<Diagram>(std::move(computed));
    state.masses = compute_cell_masses(mesh_, state.diagram, options_.density);
    return state;
  }

  double least_share(const State& state) const {
    double least = kInfinity;
    for (std::size_t i = 0; i < targets_.size(); ++i) least = std::min(least, state.masses[i] / targets_[i]);
    return least;
  }

  /// The change of the weights after which the masses would equal their targets if the rates stayed the same.
  std::vector<double> newton_step() {
    using Matrix = Eigen::SparseMatrix<double>;
    std::vector<Eigen::Triplet<double>> entries;
    const auto add = [&](std::size_t i, std::size_t j, double value) { entries.emplace_back(int(i), int(j), value); };
    double largest = 0;
    for (const BisectorId id : state_.diagram.bisectors.ids()) {
      const Bisector& bisector = state_.diagram.bisectors[id];
      const std::size_t i = tied_.of(bisector.left), j = tied_.of(bisector.right);
      if (i == j) continue;
      const double rate = state_.rates[id.index()];
      add(i, i, rate), add(j, j, rate), add(i, j, -rate), add(j, i, -rate);
      largest = std::max(largest, rate);
    }
    const auto count = static_cast<Eigen::Index>(targets_.size());
    for (Eigen::Index i = 0; i < count; ++i) add(i, i, kShift * largest);
    Matrix laplacian(count, count);
    laplacian.setFromTriplets(entries.begin(), entries.end());
    const std::vector<double> masses = tied_.sums(state_.masses), targets = tied_.sums(targets_);
    Eigen::VectorXd excess(count);
    for (Eigen::Index i = 0; i < count; ++i) excess[i] = masses[i] - targets[i];
    const Eigen::VectorXd of_sets = Eigen::SimplicialLDLT<Matrix>(laplacian).solve(excess);
    std::vector<double> step;
    for (std::size_t i = 0; i < targets_.size(); ++i) step.push_back(of_sets[Eigen::Index(tied_.of(GeneratorId(i)))]);
    return step;
  }

  /// Takes as large a part of the step as lowers the error, at most `length`, and sets `length` to this part. If no
  /// length lowers the error, ties the two cells that prevent it; returns false if there are no such cells.
  bool search(const std::vector<double>& step, double& length) {
    const double longest = length;
    for (; diagrams_ < options_.max_diagrams; length /= 2) {
      std::vector<double> weights = weights_;
      for (std::size_t i = 0; i < weights.size(); ++i) weights[i] += length * step[i];
      auto computed = compute(weights);
      State* const next = std::get_if<State>(&computed);
      if (next && accepts(*next, length)) {
        weights_ = std::move(weights);
        state_ = std::move(*next);
        variation_ = find_variation(state_.masses, targets_, tied_);
        return true;
      }
      if (length > (next ? kShortStep : kShortestStep)) continue;
      length = longest;
      const auto [a, b] =
          next ? find_jump(*next, step, length) : find_neighbour(std::get<HiddenGenerator>(computed).generator, step);
      if (!tied_.tie(a, b)) return false;
      variation_ = find_variation(state_.masses, targets_, tied_);
      return true;
    }
    return true;
  }

  bool accepts(const State& next, double length) {
    return find_variation(next.masses, targets_, tied_) < (1 - kEnoughDescent * length) * variation_ &&
           least_share(next) >= least_share_;
  }

  /// The two cells whose masses differ most from those that the rates predict for the step.
  std::pair<GeneratorId, GeneratorId> find_jump(const State& next, const std::vector<double>& step,
                                                double length) const {
    std::vector<double> surplus = next.masses;
    for (std::size_t i = 0; i < surplus.size(); ++i) surplus[i] -= state_.masses[i];
    for (const BisectorId id : state_.diagram.bisectors.ids()) {
      const std::size_t left = state_.diagram.bisectors[id].left.index(),
                        right = state_.diagram.bisectors[id].right.index();
      const double passed = length * state_.rates[id.index()] * (step[left] - step[right]);
      surplus[left] += passed;
      surplus[right] -= passed;
    }
    const auto [least, most] = std::ranges::minmax_element(surplus);
    return {GeneratorId(least - surplus.begin()), GeneratorId(most - surplus.begin())};
  }

  /// Pairs a vanishing cell with the neighbour relative to which its weight grows most.
  std::pair<GeneratorId, GeneratorId> find_neighbour(GeneratorId cell, const std::vector<double>& step) const {
    const auto& neighbours = state_.diagram.cells[cell].neighbours;
    const auto least = std::ranges::min_element(neighbours, {}, [&](GeneratorId g) { return step[g.index()]; });
    return {cell, least == neighbours.end() ? cell : *least};
  }

  BalancedDiagram take_result() {
    BalancedDiagram result;
    result.converged = converged();
    result.tied = tied_.list();
    result.diagrams = diagrams_;
    TiedCells alone(targets_.size());
    result.variation = find_variation(state_.masses, targets_, alone);
    result.diagram = std::move(state_.diagram);
    result.masses = std::move(state_.masses);
    result.targets = std::move(targets_);
    return result;
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  const BalanceOptions& options_;
  TiedCells tied_;
  State state_;
  std::vector<double> weights_, targets_;
  double variation_ = 0;  // over the sets
  double least_share_ = 0;
  int diagrams_ = 0;
};

void check_options(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const BalanceOptions& options) {
  check_density(mesh, options.density);
  const auto refuse = [](const std::string& message) { throw Error(ErrorCode::invalid_option, message); };
  if (!(options.tolerance > 0)) refuse("the tolerance of balancing must be above 0");
  if (options.max_diagrams < 1) refuse("balancing needs at least one diagram");
  if (options.diagram.method != Method::exact) refuse("weights need the exact method; choose it, or leave them out");
  if (!options.shares.empty() && options.shares.size() != generators.size()) {
    refuse(fmt::format("there are {} shares for {} generators; give one for each", options.shares.size(),
                       generators.size()));
  }
  for (std::size_t i = 0; i < options.shares.size(); ++i) {
    if (options.shares[i] > 0 && std::isfinite(options.shares[i])) continue;
    refuse(fmt::format("share {} is {}; give finite numbers above 0", i, options.shares[i]));
  }
}

}  // namespace

std::vector<double> compute_cell_masses(const Mesh& mesh, const Diagram& diagram, const Density& density) {
  std::vector<double> masses(diagram.cells.size(), 0.0);
  if (density.is_uniform()) {
    for (const Cell& cell : diagram.cells) masses[cell.generator.index()] = cell.area;
    return masses;
  }
  for_each_cell_part(diagram, [&](const FacePart& part) {
    const FaceId f = part.face;
    // Triangles are signed, so that the sum is also right for a part that is not convex.
    for (std::size_t k = 1; k + 1 < part.corners.size(); ++k) {
      const Bary &a = part.corners[0], &b = part.corners[k], &c = part.corners[k + 1];
      const double share = twice_signed_area(affine_point(a), affine_point(b), affine_point(c));
      const double mean = (density.at(f, a) + density.at(f, b) + density.at(f, c)) / 3;
      masses[part.generator.index()] += mesh.area(f) * share * mean;
    }
  });
  return masses;
}

BalancedDiagram balance_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                              const BalanceOptions& options) {
  auto balanced = try_to_balance(mesh, generators, options);
  if (const auto* const hidden = std::get_if<HiddenGenerator>(&balanced)) throw hidden->error();
  return std::get<BalancedDiagram>(std::move(balanced));
}

std::variant<BalancedDiagram, HiddenGenerator> try_to_balance(const Mesh& mesh,
                                                              const std::vector<SurfacePoint>& generators,
                                                              const BalanceOptions& options) {
  check_options(mesh, generators, options);
  return Balancer(mesh, generators, options).run();
}

}  // namespace gvd
