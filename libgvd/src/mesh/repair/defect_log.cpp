#include "mesh/repair/defect_log.hpp"

#include <array>

namespace gvd {
namespace {

constexpr std::array<std::string_view, 10> kKindNames = {
    "unwelded_vertices",        "zero_length_edges", "degenerate_faces",     "duplicate_faces", "crossing_quads",
    "inconsistent_orientation", "nonmanifold_edges", "nonmanifold_vertices", "unused_vertices", "dropped_components"};

}  // namespace

std::string_view name_of(DefectKind kind) { return kKindNames[static_cast<std::size_t>(kind)]; }

std::int64_t DefectReport::count(DefectKind kind) const {
  for (const Defect& defect : defects) {
    if (defect.kind == kind) return defect.count;
  }
  return 0;
}

void DefectLog::add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what,
                    const std::string& action) {
  if (count == 0) return;
  if (policy_ == DefectPolicy::error) refuse_soup(what + ": repair the mesh, or allow its repair", first);
  const std::string message = what + ": " + action;
  report_.defects.push_back({kind, count, first, message});
  report_.messages.push_back(message);
}

}  // namespace gvd
