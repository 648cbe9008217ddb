#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/options/options.hpp"
#include "common/run.hpp"
#include "gvd/coarse_copy.hpp"
#include "gvd/constrained_start.hpp"
#include "gvd/density.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The start of a relaxation, the relaxation, and words of its report, for gvd-lloyd and gvd-remesh.
namespace gvd::app {

/// Generators to begin with, what they may do, the weight of the surface, and a copy to relax on first, if any.
struct WeightedStart : ConstrainedStart {
  Density density;
  std::optional<CoarseCopy> copy;
};

/// Chooses the generators of the run, or as many as `count`, and makes the start that the constraints ask for. Notes
/// how many are fixed, on creases and free. Throws what make_generators, constrain_start, read_density and
/// read_generators throw, and Error{unreadable_input} where --density names neither a file nor a property.
WeightedStart start_relaxation(Run& run, const CheckedMesh& input, std::optional<std::int32_t> count,
                               const ConstraintOptions& constraints);

/// Relaxes with these options, those of the start and those of the run, and reports the time. The bar shows iteration
/// and energy.
LloydResult run_relaxation(Run& run, const Mesh& mesh, const WeightedStart& start, LloydOptions options);

/// The reason of a relaxation's end in one word, as reports and pages name it.
const char* name_of(LloydStop stop);

/// The part of a relaxation on a copy of the mesh, for reports; null where there was none.
nlohmann::ordered_json describe_copy(const CoarseRelaxation& copy);

/// Adds the constraints to the member `options` of a report.
void report_constraints(nlohmann::ordered_json& options, const ConstraintOptions& constraints);

}  // namespace gvd::app
