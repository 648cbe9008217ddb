#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "common/barriers.hpp"
#include "distance/measured_surface.hpp"
#include "gvd/io/distance_writer.hpp"

namespace gvd::app {

/// Tells why distances of a table are infinite.
class UnreachedPoints {
 public:
  /// `targets`: the places of the points of --to. `has_limit`: whether there is a --max-distance. All must outlive
  /// this.
  UnreachedPoints(const CheckedMesh& input, const MeasuredSurface& surface, const DistanceTable& table,
                  const PlacedPoints& targets, bool has_limit)
      : input_(input), surface_(surface), table_(table), targets_(targets), has_limit_(has_limit) {}

  /// What keeps the sources of a row from a point of the table that they do not reach. Cost: O(1), for each row in turn
  /// O(components), and once that of `Barriers`.
  Barrier find(std::size_t row, std::size_t point);

  /// Words for Barrier::inside.
  std::string inside() const;

 private:
  void find_faces();

  const CheckedMesh& input_;
  const MeasuredSurface& surface_;
  const DistanceTable& table_;
  const PlacedPoints& targets_;
  bool has_limit_;
  std::optional<Barriers> barriers_;
  std::vector<FaceId> face_;       // of each point of the table; invalid for a vertex in no face
  std::vector<char> is_left_out_;  // of each point of the table
  std::optional<std::size_t> row_;
  Barriers::Origin origin_;  // of that row
};

}  // namespace gvd::app
