#pragma once

#include <vector>

#include "fit_vertices.hpp"
#include "gvd/mesh.hpp"
#include "move_guard.hpp"

namespace gvd {

/// The search of raise_angles, beside the positions that it starts with. All of it must outlive the search.
struct AngleSearch {
  const Mesh* mesh = nullptr;  ///< with the positions that the systems belong to
  const FaceSystems* systems = nullptr;
  const MoveGuard* guard = nullptr;
  const SpringPlan* plan = nullptr;  ///< its held vertices stay
  Progress progress = {};            ///< may be empty
};

/// The price of thin triangles, and of what any triangle lacks of an equilateral one, against square distances. Each is
/// in units of a cell's: 1 is the square of its area.
struct AnglePrice {
  double angle = 0;   ///< triangles with a smaller one are thin; degrees, > 0
  double weight = 0;  ///< of thin triangles
  double shape = 0;   ///< of the lack of Q, 1 - Q; 0: vertices without thin triangles stay
};

/// The share of the price of Q at creases and beside them. With a fifth, RMS of fandisk, rotor and plate with 500
/// vertices grows by 8 %, for a mean Q that is .005 larger.
inline constexpr double kShapeAtCrease = 0.1;

/// Passes of raise_angles over the vertices, and places that a vertex tries in one.
inline constexpr int kAnglePasses = 6, kAngleTrials = 32;

/// Moves vertices, one after the other, to where the sum of square distances and the price of their triangles is
/// smaller.
///
/// A vertex tries eight directions along the surface with steps that get shorter, and keeps the best place. At each it
/// rises or falls to where the square distances are least. A vertex whose generator is on a crease goes along it alone:
/// creases that generators follow (`--features`) stay. The price of a thin triangle grows with the square of the angle
/// that it lacks. An angle that the guard forbids costs more. Q costs a part at creases and beside them: there,
/// triangles have to meet the crease first. Deterministic.
/// Cost: O(n), and O(valence) for each of kAngleTrials places of a vertex, a pass. A vertex is left out while nothing
/// around it has moved since it has found no better place.
std::vector<Vec3> raise_angles(const AngleSearch& search, const AnglePrice& price, std::vector<Vec3> positions);

}  // namespace gvd
