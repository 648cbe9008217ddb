#include "state_evaluator.hpp"

#include <algorithm>
#include <string_view>

#include "gvd/diagram_steps.hpp"
#include "precision_levels.hpp"

namespace gvd {

StateEvaluator::StateEvaluator(const Mesh& mesh, const LloydOptions& options, const GeneratorConstraints& constraints)
    : mesh_(mesh), options_(options), constraints_(constraints), levels_(make_precision_levels(options)) {}

RelaxationState StateEvaluator::evaluate(const std::vector<SurfacePoint>& generators,
                                         const std::function<void(double)>& report) {
  Precision precision = levels_[level_];
  precision.rest_tolerance = options_.move_tolerance;
  precision.diagram.progress = [&report](std::string_view step, double fraction) {
    const auto begun = std::find(steps::kAll.begin(), steps::kAll.end(), step) - steps::kAll.begin();
    report((static_cast<double>(begun) + fraction) / static_cast<double>(steps::kAll.size()));
    return true;
  };
  ++diagrams_;
  return evaluate_generators(mesh_, generators, precision, options_.density, constraints_);
}

}  // namespace gvd
