#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace gvd::bench {

/// The programs whose figures are known, in the order of PeerRow::values.
inline constexpr std::array<const char*, 3> kPeers{"ACVD", "ACVDQ", "Geogram"};

/// One row of figures of the peers, for one number of vertices.
struct PeerRow {
  const char* figure;
  bool smaller_is_better;
  std::array<std::optional<double>, 3> values;  ///< of kPeers
};

/// Measured once on spot, elephant, armadillo, bunny, fandisk, rotor, plate, knot and kitten: ACVD with `-m 1`.
/// Empty where the peers were not measured with so many vertices.
std::vector<PeerRow> peer_figures(int vertices);

/// "ahead by X", "level" or "behind NAME by X": of `ours` beside the best of the peers. Empty without peers.
std::string compare_with_best(double ours, const PeerRow& peers);

}  // namespace gvd::bench
