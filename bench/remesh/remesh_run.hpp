#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

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

/// The programs whose figures are known, in the order of PeerRow::values.
inline constexpr std::array<const char*, 3> kPeers{"ACVD", "ACVDQ", "Geogram"};

/// One row of figures of the peers, for one number of vertices.
struct PeerRow {
  const char* figure;
  bool smaller_is_better;
  std::array<std::optional<double>, 3> values;  ///< of kPeers
};

/// Measured once on spot, elephant, armadillo, bunny, fandisk, rotor, plate, knot and kitten: ACVD with `-m 1`.
/// Empty where the peers were not measured with so many vertices.
std::vector<PeerRow> peer_figures(int vertices);

/// "ahead by X", "level" or "behind NAME by X": of `ours` beside the best of the peers. Empty without peers.
std::string compare_with_best(double ours, const PeerRow& peers);

}  // namespace gvd::bench
