#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "apps/run_command.hpp"

// The beginning of most tests of gvd-remesh.
namespace gvd::test {

/// Runs gvd-remesh, which must end well. Gives what it said on standard error.
std::string run_remesh(const std::string& arguments);

/// The report of a quiet run, which must end well.
nlohmann::json report_of(const std::string& arguments);

}  // namespace gvd::test
