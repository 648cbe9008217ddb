#pragma once

#include <array>
#include <span>
#include <vector>

#include "diagram/crossings.hpp"
#include "diagram/face_diagram.hpp"

namespace gvd {

/// A part of a face between its arcs.
struct WorkingPiece {
  GeneratorId generator;
  std::vector<std::array<double, 3>> corners;  ///< barycentric in the working face, counter-clockwise
  std::vector<int> runs;  ///< the runs of the face's boundary that it touches: run i follows crossing i
};

/// The parts of a face with these boundary crossings (at least 2) and arcs (all of the face's).
std::vector<WorkingPiece> trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                                       const IdVector<BranchPointId, FaceBranch>& branches);

}  // namespace gvd
