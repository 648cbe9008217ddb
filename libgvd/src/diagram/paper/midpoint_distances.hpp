#pragma once

#include <array>
#include <optional>
#include <vector>

#include "geodesic/generator_table.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// The auxiliary points of section 4.1: for each face and each generator in its table, distances at the three edge
/// midpoints, mesh units. The field of a generator is linear in a face, so that each is the mean of two corners'.
class MidpointDistances {
 public:
  /// Memory: 24 bytes an entry of the tables. Cost: O(entries).
  MidpointDistances(const GeneratorTable& table, std::int32_t face_count);

  /// Those of generator g in face f; item i belongs to the edge from corner i to the next. Nothing where g does not
  /// reach f. Cost: O(entries of the face).
  std::optional<std::array<double, 3>> find(FaceId f, GeneratorId g) const;

 private:
  const GeneratorTable& table_;
  std::vector<std::array<double, 3>> of_entry_;
};

}  // namespace gvd
