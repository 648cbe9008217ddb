#pragma once

#include <span>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/graph/crossings.hpp"
#include "diagram/graph/face_diagram.hpp"

namespace gvd {

/// A connected part of a face without its arcs.
struct WorkingPiece {
  GeneratorId generator;
  std::vector<Bary> corners;  ///< barycentric in the working face, counter-clockwise
};

/// All pieces of one face.
struct WorkingPieces {
  std::vector<WorkingPiece> pieces;
  /// For each label interval of the face's boundary the piece along it; interval i follows boundary crossing i.
  std::vector<int> piece_of_interval;
};

/// The pieces of a face with these boundary crossings (at least 2) and arcs (all of the face's, out of `diagram`).
/// `result` is overwritten; a loop over faces passes the same one again to save allocations.
/// Cost: O(k log k) for k crossings and arcs, and the number of their points.
void trace_pieces(const std::vector<BoundaryCrossing>& boundary, std::span<const FaceArc> arcs,
                  const FaceDiagram& diagram, WorkingPieces& result);

}  // namespace gvd
