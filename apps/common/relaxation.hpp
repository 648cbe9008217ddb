#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "common/options/options.hpp"
#include "gvd/density.hpp"
#include "gvd/features.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The start of a relaxation, and words of its report, for gvd-lloyd and gvd-remesh.
namespace gvd::app {

/// Generators to begin with, and what they may do.
struct ConstrainedStart {
  std::vector<SurfacePoint> points;
  std::vector<Freedom> freedom;  ///< of the points; empty if all are free
  std::vector<EdgeId> creases;
  double corner_distance = 0;  ///< of the creases (place_on_creases), mesh units
  Density density;
};

/// The start that the constraints ask for, out of the generators of the run. Sampled ones make room, each the nearest
/// one, for those that are fixed or lie on features, so that their number stays. Listed ones stay, and those on creases
/// are kept there. Those on features are at most four fifths of all, as far as corners and closed creases do not need
/// more. Throws Error{precondition} where there are fewer generators than places on features.
ConstrainedStart constrain_start(const CheckedMesh& input, std::vector<SurfacePoint> points,
                                 const ConstraintOptions& options, const Options& run);

/// How many generators are fixed, on creases and free.
std::string describe_freedom(const std::vector<Freedom>& freedom);

/// `options`, for the relaxation of this start.
LloydOptions make_lloyd_options(LloydOptions options, const ConstrainedStart& start, const ComputeOptions& compute);

/// The reason of a relaxation's end in one word, as reports and pages name it.
const char* name_of(LloydStop stop);

/// Adds the constraints to the member `options` of a report.
void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints);

}  // namespace gvd::app
