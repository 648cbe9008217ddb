#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/parse_lists.hpp"

// Parses lists from JSON. `name` is how messages call the list.
namespace gvd::detail {

/// Parses a JSON document. Throws Error{unreadable_input} with name and line.
nlohmann::json parse_document(std::string_view content, const std::string& name);

/// Reads the entry of a JSON object: a face with coordinates, a vertex or a position.
GeneratorEntry read_object(const nlohmann::json& object, const ListLocation& location);

/// Parses the array `generators` of a JSON object, which may be a diagram or a report.
/// Throws Error{unreadable_input} with name and line. Cost: O(length).
std::vector<GeneratorEntry> parse_json(std::string_view content, const std::string& name);

}  // namespace gvd::detail
