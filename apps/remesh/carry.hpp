#pragma once

#include <vector>

#include "common/run/run.hpp"
#include "gvd/carry_properties.hpp"

namespace gvd::app {

/// For `--carry`. Throws Error{invalid_option} where no output is a PLY file, or the input is read from standard input.
void check_carry(const Run& run);

/// The properties of the input file on the remesh. Notes where there are none. Throws Error{unreadable_input}.
std::vector<MeshProperty> carry(Run& run, const CheckedMesh& input, const RemeshResult& result);

}  // namespace gvd::app
