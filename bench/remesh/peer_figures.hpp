#pragma once

#include <optional>
#include <string>
#include <vector>

#include "remesh_run.hpp"

namespace gvd::bench {

/// A remesh of another program.
struct PeerRun {
  int vertices = 0;  ///< n
  std::string model, program;
  RemeshQuality quality;  ///< `seconds` are those of another machine
};

/// The lines of a table of remeshes (peers.tsv). Throws Error{unreadable_input} where a line has not its 13 fields.
std::vector<PeerRun> read_peer_runs(const std::string& path);

/// The runs on a mesh with n vertices. The mesh is that of the model whose name begins the mesh's, up to a dot or an
/// underscore.
std::vector<PeerRun> runs_on(const std::vector<PeerRun>& runs, const std::string& mesh, int vertices);

/// A figure by which remeshes are compared.
struct ComparedFigure {
  std::string name;
  bool smaller_is_better = true;
  int digits = 3;             ///< after the point
  bool is_comparable = true;  ///< not where it was measured on different machines
};

/// What a program reaches on one mesh or on several, in the order of the compared figures; empty where it is unknown.
using FigureValues = std::vector<std::optional<double>>;

/// Of one remesh: vertices / n, distances, Q, angles, intersections.
const std::vector<ComparedFigure>& compared_figures();
FigureValues values_of(const RemeshQuality& quality);

/// Of several remeshes: number with the right topology, worst and mean figures, and the sum of the times.
const std::vector<ComparedFigure>& compared_totals();
FigureValues totals_of(const std::vector<RemeshQuality>& remeshes);

struct PeerValues {
  std::string program;
  FigureValues values;
};

/// "ahead by X", "level" or "behind PROGRAM by X": of `ours` beside the best of the peers, figure `index` of each.
/// Empty where no peer has the figure, or it can't be compared.
std::string compare_with_best(double ours, const std::vector<PeerValues>& peers, std::size_t index,
                              const ComparedFigure& figure);

}  // namespace gvd::bench
