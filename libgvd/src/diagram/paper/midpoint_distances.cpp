#include "diagram/paper/midpoint_distances.hpp"

#include <cstdint>

namespace gvd {

MidpointDistances::MidpointDistances(const GeneratorTable& table, std::int32_t face_count)
    : table_(table), of_entry_(table.entry_count()) {
  for (std::int32_t i = 0; i < face_count; ++i) {
    const FaceId f(i);
    table.for_each(f, [&](const TableEntry& entry) {
      const auto d = table.corner_distances(entry);
      of_entry_[table.find(f, entry.generator)] = {0.5 * (d[0] + d[1]), 0.5 * (d[1] + d[2]), 0.5 * (d[2] + d[0])};
    });
  }
}

std::optional<std::array<double, 3>> MidpointDistances::find(FaceId f, GeneratorId g) const {
  const std::int32_t entry = table_.find(f, g);
  if (entry < 0) return std::nullopt;
  return of_entry_[entry];
}

}  // namespace gvd
