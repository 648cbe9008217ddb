#pragma once

#include <optional>
#include <string>

#include "gvd/mesh.hpp"

namespace gvd::bench {

struct RemeshRequest {
  std::string path;                ///< of the input
  int vertices = 500;              ///< n
  std::optional<double> features;  ///< angle of --features, degrees
};

/// What one run of gvd-remesh gives. Distances are the larger of the two directions, in percent of the diagonal.
struct RemeshFigures {
  bool right_topology = false;  ///< Euler characteristic, components and boundary loops are the input's
  double inflation = 0;         ///< vertices / n
  double hausdorff = 0, rms = 0;
  double q = 0;             ///< mean
  double angle = 0;         ///< median of the triangles' smallest angles, degrees
  double kept = 0;          ///< percent_of_creases_kept
  double rounds = 0;        ///< diagrams of the repair
  double seconds = 0;       ///< processor time of the whole command
  double made_seconds = 0;  ///< of that: relaxation, diagrams, duals, placement and searches
  double diagrams = 0;      ///< percent of made_seconds in diagrams, but for those of searches
};

/// Runs the command on one thread, in a scratch folder that it removes. Nothing if the command fails.
///
/// The command reports wall-clock times of its steps. The processor time is divided in their proportions, so that other
/// processes hardly distort it. Not reentrant: processor times of other child processes would count, too.
std::optional<RemeshFigures> run_remesh(const Mesh& input, const RemeshRequest& request);

}  // namespace gvd::bench
