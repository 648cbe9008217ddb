#include "state_evaluator.hpp"

#include <algorithm>
#include <string_view>

#include "gvd/diagram_steps.hpp"
#include "precision_levels.hpp"

namespace gvd {

StateEvaluator::StateEvaluator(const Mesh& mesh, const LloydOptions& options, const GeneratorConstraints& constraints,
                               std::size_t generators)
    : mesh_(mesh),
      options_(options),
      constraints_(constraints),
      integrals_(mesh, options.density),
      levels_(make_precision_levels(mesh, generators, options)) {}

RelaxationState StateEvaluator::evaluate(const std::vector<SurfacePoint>& generators,
                                         const std::function<void(double)>& report) {
  DiagramOptions diagram_options = levels_[level_];
  diagram_options.progress = [&report](std::string_view step, double fraction) {
    const auto begun = std::find(steps::kAll.begin(), steps::kAll.end(), step) - steps::kAll.begin();
    report((static_cast<double>(begun) + fraction) / static_cast<double>(steps::kAll.size()));
    return true;
  };
  ++diagrams_;
  RelaxationState state = evaluate_generators(mesh_, generators, diagram_options, integrals_, constraints_);
  if (finds_rests()) mark_rests(mesh_, rest_radius(state), integrals_, state);
  return state;
}

std::vector<Rest> StateEvaluator::find_rests(const RelaxationState& state) {
  if (!finds_rests()) return {};
  std::vector<Rest> rests = gvd::find_rests(mesh_, state, rest_radius(state), integrals_);
  std::erase_if(rests, [&](const Rest& rest) { return !constraints_.is_free(rest.generator); });
  return rests;
}

}  // namespace gvd
