#include "io/writers/regions.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <map>
#include <utility>

namespace gvd::io {

std::vector<Region> collect_regions(const LabelledMesh& mesh) {
  // As an unsigned number the invalid label -1 is the largest: it comes last.
  std::map<std::uint32_t, Region> regions;
  for (int f = 0; f < mesh.mesh.face_count(); ++f) {
    const GeneratorId label = mesh.face_label != nullptr ? (*mesh.face_label)[FaceId(f)] : GeneratorId();
    Region& region = regions[static_cast<std::uint32_t>(label.value())];
    region.label = label;
    region.faces.push_back(FaceId(f));
  }
  std::vector<Region> result;
  for (auto& [label, region] : regions) result.push_back(std::move(region));
  return result;
}

std::string region_name(GeneratorId label) {
  return label.valid() ? fmt::format("region_{}", label.value()) : "unlabelled";
}

}  // namespace gvd::io
