#pragma once

#include <vector>

#include "fit_vertices.hpp"
#include "gvd/mesh.hpp"
#include "move_guard.hpp"

namespace gvd {

/// The input of the search of raise_angles, besides the positions that it starts with. All of it must outlive the
/// search.
struct AngleSearch {
  const Mesh* mesh = nullptr;  ///< with the positions that the systems belong to
  const FaceSystems* systems = nullptr;
  const MoveGuard* guard = nullptr;
  const SpringPlan* plan = nullptr;  ///< its held vertices stay
  Progress progress = {};            ///< may be empty
};

/// The price of thin triangles, and of the lack of Q of any triangle, compared with square distances. The unit is that
/// of a cell: 1 is the square of its area.
struct AnglePrice {
  double angle = 0;   ///< triangles with a smaller one are thin; degrees, > 0
  double weight = 0;  ///< of thin triangles
  double shape = 0;   ///< of the lack of Q, 1 - Q; 0: vertices without thin triangles stay
};

/// The fraction of the price of Q that applies at creases and beside them. A fifth would raise mean Q slightly, but
/// make distances of models with creases larger by some percent (docs/notes/remesh-placement.md).
inline constexpr double kShapeAtCrease = 0.1;

/// Passes of raise_angles over the vertices, and places that a vertex tries in one.
inline constexpr int kAnglePasses = 6, kAngleTrials = 32;

/// Moves vertices, one after the other, so that the sum of the square distances and the price of their triangles falls.
///
/// A vertex tries eight directions along the surface, with steps that get shorter, and keeps the best place. At each
/// place it rises or falls to where the square distances are least. A vertex whose generator is on a crease moves only
/// along the crease, so that creases that generators follow (`--features`) stay. The price of a thin triangle grows
/// with the square of the missing angle, and an angle that the guard forbids costs more. At creases and beside them
/// only a fraction of the price of Q applies, because triangles have to meet the crease first. Deterministic. Cost of a
/// pass: O(n), and O(valence) for each of kAngleTrials places of a vertex. A vertex that has found no better place is
/// left out until something around it moves.
std::vector<Vec3> raise_angles(const AngleSearch& search, const AnglePrice& price, std::vector<Vec3> positions);

}  // namespace gvd
