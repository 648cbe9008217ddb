#include "common/relaxation/relaxation_report.hpp"

#include <nlohmann/json.hpp>

namespace gvd::app {

const char* name_of(LloydStop stop) {
  switch (stop) {
    case LloydStop::centroids:
      return "centroids";
    case LloydStop::energy:
      return "energy";
    case LloydStop::no_descent:
      return "no descent";
    case LloydStop::max_iterations:
      return "iterations";
    case LloydStop::time_limit:
      return "time limit";
  }
  return "";
}

void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints) {
  using Json = nlohmann::ordered_json;
  options["fixed"] = constraints.fixed.empty() ? Json() : Json(constraints.fixed);
  options["features"] = constraints.features ? Json(*constraints.features) : Json();
  options["keep_boundary"] = constraints.keep_boundary;
  options["density"] = constraints.density.empty() ? Json() : Json(constraints.density);
  options["gradation"] = constraints.gradation;
}

}  // namespace gvd::app
