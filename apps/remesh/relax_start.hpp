#pragma once

#include <optional>

#include "common/relaxation/constrain_start.hpp"
#include "common/run/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/soup.hpp"
#include "remesh/relax_options.hpp"

namespace gvd::app {

/// The generators that a remesh begins with.
struct RelaxedStart {
  ConstrainedStart constrained;
  std::optional<Diagram> diagram;  ///< of the points, where a relaxation has computed it
};

/// Makes the generators that the options ask for, relaxed as these say. Reports the options, the relaxation and the
/// generators.
/// Throws what make_start and relax_generators throw.
RelaxedStart make_relaxed_start(Run& run, const CheckedMesh& input, const RelaxOptions& options);

}  // namespace gvd::app
