#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/options/options.hpp"

namespace gvd::app {

/// The name of a method that has one, as on the command line.
const char* method_name(const Method& method);

/// The options as they were understood, defaults included; null for what was not given. For the report.
nlohmann::ordered_json to_json(const Options& options);

}  // namespace gvd::app
