#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "gvd/constrained_start.hpp"

namespace gvd {

/// The largest share of the generators on creases and boundaries, unless corners and closed creases need more. A
/// surface with many small holes would need three generators on each, and needs the rest for its shape.
inline constexpr double kFeatureShare = 0.5;

inline bool exceeds_share(std::size_t placed, std::size_t asked) {
  return static_cast<double>(placed) > kFeatureShare * static_cast<double>(asked);
}

/// Creases are followed by default only if a remesh is expected to add at most this share of generators opposite
/// others. With more, distances improve but the triangles become worse.
inline constexpr double kOppositeShare = 0.12;

/// Whether even a lower bound for the number of generators on these creases is above `most`. Creases may be many orders
/// of magnitude longer than the spacing, and their generators too many for memory.
bool surely_exceeds(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing, double most);

/// Chooses the creases and boundary loops that generators follow: those that the options demand, and those that they
/// prefer as far as possible (see `constrain_start`). `start` must have all its `points`; sets its `creases` and the
/// fields after it. Returns the spacing of evenly spread generators, mesh units.
double choose_curves(const Mesh& mesh, const StartOptions& options, ConstrainedStart& start);

}  // namespace gvd
