#pragma once

#include <optional>
#include <string>

#include "gvd/mesh.hpp"

namespace gvd::bench {

/// When an edge of the input is kept by an edge of the remesh.
struct KeptCreaseOptions {
  double angle = 40;        ///< degrees between the normals of two faces: sharper edges are creases, of both meshes
  double distance = 0.005;  ///< of the input's midpoint from the remesh's edge, as a fraction of the input's diagonal
  double direction = 20;    ///< degrees between the two edges
};

/// The length of the input's creases that creases of the remesh keep, in percent of all; 100 without creases.
/// An edge counts by its midpoint. Cost: O(n m) for n and m crease edges.
double percent_of_creases_kept(const Mesh& input, const Mesh& remesh, const KeptCreaseOptions& options = {});

struct RemeshRequest {
  std::string path;                ///< of the input
  int vertices = 500;              ///< n
  std::optional<double> features;  ///< angle of --features, degrees
};

/// What a remesh is measured by. Distances are the larger of the two directions, in percent of the diagonal.
struct RemeshQuality {
  bool right_topology = false;  ///< Euler characteristic, components and boundary loops are the input's
  double inflation = 0;         ///< vertices / n
  double hausdorff = 0, rms = 0;
  double q = 0;                        ///< mean
  double least_angle = 0;              ///< of all triangles, degrees
  double below_30 = 0;                 ///< percent of the triangles with an angle below 30 degrees
  double intersections = 0;            ///< pairs of triangles that intersect
  double seconds = 0;                  ///< processor time of the whole command
  std::optional<double> creases_kept;  ///< percent_of_creases_kept
};

/// What one run of gvd-remesh gives.
struct RemeshFigures : RemeshQuality {
  double angle = 0;         ///< median of the triangles' smallest angles, degrees
  double rounds = 0;        ///< diagrams of the repair
  double made_seconds = 0;  ///< of that: relaxation, diagrams, duals, placement and searches
  double diagrams = 0;      ///< percent of made_seconds in diagrams, but for those of searches
};

/// Runs the command on one thread, in a scratch folder that it removes. Nothing if the command fails.
///
/// The command reports wall-clock times of its steps. The processor time is divided in their proportions, so that other
/// processes hardly distort it. Not reentrant: processor times of other child processes would count, too.
std::optional<RemeshFigures> run_remesh(const Mesh& input, const RemeshRequest& request);

}  // namespace gvd::bench
