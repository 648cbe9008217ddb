#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/run.hpp"
#include "gvd/remesh.hpp"
#include "gvd/soup.hpp"
#include "remesh/relax_options.hpp"

namespace gvd::app {

/// The options of gvd-remesh alone.
struct Settings {
  RemeshOptions remesh;
  RelaxOptions relaxation;
  std::optional<Placement> place;  ///< as given
  bool no_refine = false;
  bool carry = false;
};

/// The values of --place.
const std::vector<std::pair<std::string, Placement>>& placement_names();

/// The computing part of a run: chooses generators, relaxes them, and remeshes; with --error, as many generators as it
/// takes. Notes and reports all of it. Throws Error{no_valid_result} where no number of generators that was tried is
/// enough for --error, and what constrain_start, relax_generators and remesh throw.
RemeshResult make_remesh(Run& run, const CheckedMesh& input, const Settings& settings);

}  // namespace gvd::app
