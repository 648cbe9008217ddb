// Records the defects of a soup as they are found and repaired.
//
// Invariant: under DefectPolicy::error the first defect is refused before it is repaired.
#include "mesh/repair/defect_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace gvd {
namespace {

constexpr std::array<std::string_view, 12> kKindNames = {
    "unwelded_vertices", "zero_length_edges",        "degenerate_faces",  "duplicate_faces",
    "crossing_quads",    "inconsistent_orientation", "nonmanifold_edges", "nonmanifold_vertices",
    "unused_vertices",   "dropped_components",       "one_sided_edges",   "zero_area_components"};

}  // namespace

std::string_view name_of(DefectKind kind) { return kKindNames[static_cast<int>(kind)]; }

std::int64_t DefectReport::count(DefectKind kind) const {
  const auto found = std::ranges::find(defects, kind, &Defect::kind);
  return found == defects.end() ? 0 : found->count;
}

void DefectLog::add_asked(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& message) {
  if (count == 0) return;
  report_.defects.push_back({kind, count, first, message});
  report_.messages.push_back(message);
}

void DefectLog::add(DefectKind kind, std::int64_t count, std::int64_t first, const std::string& what,
                    const std::string& action) {
  if (count == 0) return;
  if (policy_ == DefectPolicy::error)
    refuse_soup(what + ": repair the mesh\1+, or allow its repair with |on_defect=repair\2", first);
  add_asked(kind, count, first, what + ": " + action);
}

}  // namespace gvd
