#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/constrained_start.hpp"

namespace gvd {

/// Largest share of the generators on creases and boundaries, where corners and closed creases do not need more: a
/// closed surface with many small holes needs three generators on each, and the others for its shape.
inline constexpr double kFeatureShare = 0.5;

inline bool exceeds_share(std::size_t placed, std::size_t asked) {
  return static_cast<double>(placed) > kFeatureShare * static_cast<double>(asked);
}

/// Largest share of generators that a remesh is expected to add opposite others, for creases to be followed by default.
/// With more, distances improve and the triangles become worse.
inline constexpr double kOppositeShare = 0.12;

/// Whether the generators that these creases have at least are more than `most`. Creases may be longer than the spacing
/// by many orders of magnitude, so that their generators would not fit into memory.
bool surely_exceeds(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing, double most);

/// Chooses the creases and the boundary loops that generators keep to, as far as the options ask for them, or prefer
/// them and it is possible (see constrain_start). Sets `creases` of a start that has all `points`, and what follows it.
/// Returns the spacing of evenly spread generators, mesh units.
double choose_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start);

}  // namespace gvd
