#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gvd/find_fewest.hpp"
#include "gvd/mesh.hpp"
#include "gvd/remesh.hpp"
#include "gvd/remesh_map.hpp"

// The result of gvd-remesh for its user: members of the report, and notes.
namespace gvd::app {

/// Adds the certificate and the quality of a remesh to the member `results` of the report.
void report_remesh(nlohmann::ordered_json& results, const Mesh& mesh, const RemeshResult& result);

/// Adds the trials of --error. `target`: the distance that it asks for, mesh units.
void report_trials(nlohmann::ordered_json& results, double target, const Fewest& found);

/// Adds how good the map of --map is. Returns the note on it: whether it is one-to-one, and how far vertices move.
std::string report_map(nlohmann::ordered_json& results, const RemeshMap& map);

/// The notes on a remesh, one line each. `options`: those that gave the result.
std::vector<std::string> describe_remesh(const RemeshResult& result, const RemeshOptions& options);

}  // namespace gvd::app
