#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/options/options.hpp"
#include "gvd/lloyd.hpp"

namespace gvd::app {

/// The reason of a relaxation's end in one word, as reports and pages name it.
const char* name_of(LloydStop stop);

/// Adds the constraints to the member `options` of a report.
void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints);

}  // namespace gvd::app
