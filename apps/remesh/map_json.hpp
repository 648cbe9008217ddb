#pragma once

#include <iosfwd>

#include "common/run/run.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/soup.hpp"

namespace gvd::app {

/// Writes `gvd-remesh-map/1`: for each vertex of the output its point of the input. For each vertex of the input file
/// it has the point of the output, null where the vertex was dropped. docs/guide/formats.md describes it. The stream is
/// flushed and checked. Throws Error{unwritable_output}. Cost: O(n).
void write_map_json(std::ostream& out, const CheckedMesh& input, const RemeshMap& map);

/// Sets `map` of the report's results, and notes whether the map is one-to-one, and how far vertices move.
void report_map(Run& run, const RemeshMap& map);

}  // namespace gvd::app
