#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/run/run.hpp"
#include "gvd/carry_properties.hpp"

namespace gvd::app {

/// For `--carry`. Throws Error{invalid_option} where no output is a PLY or OBJ file.
void check_carry(const Run& run);

/// What the input file holds, on the remesh.
struct Carried {
  std::vector<MeshProperty> properties;
  std::vector<std::array<double, 2>> texture;  ///< of the corners of faces; empty where the file has none
};

/// Reads the properties and the texture of the input file, and carries them over. Notes where there is nothing to carry
/// over, and what no output holds. `standard_input`: the text that standard input held, if INPUT is `-`. Throws
/// Error{unreadable_input}.
Carried carry(Run& run, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map,
              const std::string& standard_input);

}  // namespace gvd::app
