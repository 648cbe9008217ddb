#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/constrained_start.hpp"

namespace gvd {

/// Largest share of the generators on creases and boundaries, where corners and closed creases do not need more. A
/// closed surface with 27 small holes needs three generators on each. With .8, 80 of 100 were on holes, and the remesh
/// was 20.8 % of the diagonal away. Without any on holes it is 4.4 %, and with 150 generators 3.2 % (RMS .38) instead
/// of 3.7 % (RMS .78). With 200, 41 % of them suffice, and both are about as far away, with a seventh more vertices
/// where none is on a hole.
inline constexpr double kFeatureShare = 0.5;

inline bool exceeds_share(std::size_t placed, std::size_t asked) {
  return static_cast<double>(placed) > kFeatureShare * static_cast<double>(asked);
}

/// Largest share of generators that a remesh is expected to add opposite others, for creases to be followed by default.
/// With .116 (plate 2000, rotor less) following creases improves distances, the least angle, and the share of faces
/// with an angle below 30 degrees (6.1 to 1.2 %). With .124 (rotor 500) it improves the distances, but the mean Q falls
/// from .808 to .797, and that share rises from 9.6 to 14.4 %. With .23 (plate 500) Q falls from .835 to .77.
inline constexpr double kOppositeShare = 0.12;

/// Whether the generators that these creases have at least are too many. Creases may be longer than the spacing by many
/// orders of magnitude, so that their generators would not fit into memory.
bool surely_exceeds_share(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing, std::size_t asked);

/// Chooses the creases and the boundary loops that generators keep to, as far as the options ask for them, or prefer
/// them and it is possible (see constrain_start). Sets `creases` of a start that has all `points`, and what follows it.
/// Returns the spacing of evenly spread generators, mesh units.
double choose_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start);

}  // namespace gvd
