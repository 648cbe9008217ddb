#pragma once

#include <vector>

#include "common/options/options.hpp"
#include "common/run/run.hpp"
#include "gvd/density.hpp"
#include "gvd/features.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::app {

/// Generators to begin with, and what they may do.
struct ConstrainedStart {
  std::vector<SurfacePoint> points;
  std::vector<Freedom> freedom;  ///< of the points; empty if all are free
  std::vector<EdgeId> creases;
  double corner_distance = 0;  ///< of the creases (place_on_creases), mesh units
  Density density;
};

/// The density and the generators that the options ask for. Sampled ones make room, each the nearest one, for those
/// that are fixed or lie on features, so that their number stays. Listed ones stay, and those on creases are kept
/// there. Those on features are at most four fifths of all, as far as corners and closed creases do not need more.
/// Throws Error{precondition} where there are fewer generators than places on features.
ConstrainedStart make_start(Run& run, const CheckedMesh& input, const ConstraintOptions& options);

}  // namespace gvd::app
