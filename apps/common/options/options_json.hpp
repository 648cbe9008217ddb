#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/options/options.hpp"

namespace gvd::app {

/// The options as they were understood, defaults included; null for what was not given. For the report.
nlohmann::ordered_json to_json(const Options& options);

}  // namespace gvd::app
