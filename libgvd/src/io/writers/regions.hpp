#pragma once

#include <string>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/io/mesh_writer.hpp"

namespace gvd::io {

/// The faces of one label.
struct Region {
  GeneratorId label;
  std::vector<FaceId> faces;  ///< ascending
};

/// The regions that own a face, by label; the faces without a label come last. Without labels one region of all faces.
/// Cost: O(n log r) for n faces and r regions.
std::vector<Region> collect_regions(const LabelledMesh& mesh);

/// The name of a region in formats that name groups or materials.
std::string region_name(GeneratorId label);

}  // namespace gvd::io
