// Discs: generators are added until every cell is one, and then left out again as far as all cells stay discs.
//
// A disc needs less than the dual of a remesh: two cells round a loop may do, not three. What was added in vain is
// found by the search of a remesh, which counts the one property here: it tries changes on parts of the mesh, and
// decides by the diagram of the whole mesh. Where it ends depends on where it begins, so three ways to add generators
// are tried. On 24 tori and surfaces of genus 3, with one generator given, each way alone adds 146 or 147, the best
// of the three 126. A closed component takes two generators, a handle three: two cells meet in closed curves only, and
// leave annuli.
#include "gvd/disc_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/remesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/text.hpp"
#include "repair/repair_steps.hpp"

namespace gvd {
namespace {

bool is_disc(const Cell& cell) { return cell.components == 1 && cell.euler_characteristic == 1; }

class DiscMaker {
 public:
  /// All must outlive this.
  DiscMaker(const Mesh& mesh, const Diagram& given, const DiscOptions& options, DiscProposal way)
      : mesh_(mesh), options_(options), way_(way), given_(given.generators.size()) {
    max_added_ = options.max_added.value_or(default_max_added(compute_mesh_summary(mesh), given_));
    result_.diagram = given;
    events_ = given.report.propagation_events;
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

  void add_generators(const std::vector<GeneratorId>& cells) {
    const std::int64_t may_add = max_added_ - added();
    if (may_add <= 0 || result_.rounds >= kMaxRemeshRounds) {
      refuse(cells, fmt::format("{} added in {}", counted(added(), "generator was", "generators were"),
                                counted(result_.rounds, "round", "rounds")));
    }
    const auto points = propose_for_discs(mesh_, result_.diagram, cells, way_, std::size_t(may_add));
    if (points.empty()) refuse(cells, "every point for a new generator is too close to another one");
    std::vector<SurfacePoint> generators = result_.diagram.generators;
    generators.insert(generators.end(), points.begin(), points.end());
    result_.diagram = compute_diagram(mesh_, generators, options_.diagram);
    events_ += result_.diagram.report.propagation_events;
    ++result_.rounds;
  }

  [[noreturn]] void refuse(const std::vector<GeneratorId>& cells, const std::string& why) const {
    const Cell& cell = result_.diagram.cells[cells.front()];
    const Vec3 at = position(mesh_, result_.diagram.generators[cell.generator.index()]);
    throw Error(
        ErrorCode::no_valid_result,
        fmt::format("the cell of generator {} at ({:.6g}, {:.6g}, {:.6g}) is no disc (Euler characteristic {}){}: {}; "
                    "give more or other generators",
                    cell.generator.value(), at.x(), at.y(), at.z(), cell.euler_characteristic,
                    cells.size() > 1 ? fmt::format(", nor are {} more", cells.size() - 1) : "", why),
        cell.generator.value());
  }

  void search_fewer() {
    GeneratorSearch search;
    search.kept = given_;
    search.most_events = std::int64_t(kDiscSearch * double(events_));
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
  const DiscProposal way_;
  const std::size_t given_;
  std::int64_t max_added_ = 0;
  std::int64_t events_ = 0;  // windows propagated in all diagrams but those of the search
  DiscCells result_;
};

}  // namespace

std::vector<GeneratorId> find_non_discs(const Diagram& diagram) {
  std::vector<GeneratorId> cells;
  for (const Cell& cell : diagram.cells) {
    if (!is_disc(cell)) cells.push_back(cell.generator);
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
  std::optional<DiscCells> best;
  std::optional<Error> refused;
  for (const DiscProposal way : {DiscProposal::halves, DiscProposal::thirds, DiscProposal::farthest}) {
    if (best && best->added <= 1) break;
    try {
      DiscCells made = DiscMaker(mesh, diagram, options, way).run();
      if (!best || made.added < best->added) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() != ErrorCode::no_valid_result) throw;
      if (!refused) refused = error;
    }
  }
  if (!best) throw Error(*refused);
  return *std::move(best);
}

}  // namespace gvd
