#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "gvd/barriers.hpp"
#include "gvd/distances_operation.hpp"
#include "gvd/io/distance_writer.hpp"

namespace gvd {

/// Tells why distances of a table are infinite.
class UnreachedPoints {
 public:
  /// The distances must outlive this.
  explicit UnreachedPoints(const DistancesOutcome& of)
      : input_(*of.input), parted_(of.parted), table_(of.table), targets_(of.targets), has_limit_(of.has_limit) {}

  /// What keeps the sources of a row from a point of the table that they do not reach. Cost: O(1), for each row in turn
  /// O(components), and once that of `Barriers`.
  Barrier find(std::size_t row, std::size_t point);

  /// Words for Barrier::inside.
  std::string inside() const;

 private:
  void find_faces();

  const CheckedMesh& input_;
  const PartedMesh& parted_;
  const DistanceTable& table_;
  const PlacedPoints& targets_;
  bool has_limit_;
  std::optional<Barriers> barriers_;
  std::vector<FaceId> face_;       // of each point of the table; invalid for a vertex in no face
  std::vector<char> is_left_out_;  // of each point of the table
  std::optional<std::size_t> row_;
  Barriers::Origin origin_;  // of that row
};

}  // namespace gvd
