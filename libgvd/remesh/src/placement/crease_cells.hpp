#pragma once

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"

namespace gvd {

/// An edge is sharp where the normals of its two faces differ by more than this, degrees.
inline constexpr double kSharpAngle = 40;

/// A cell has a crease if its sharp edges carry at least this share of its bending. Bending is the sum of lengths times
/// angles between normals, over the parts of edges in the cell. On creases of CAD models the share is nearly 1. Noise
/// and folds have sharp edges between others that bend as well.
inline constexpr double kLeastBendingShare = 0.7;

/// Creases go on: smaller groups of neighbouring cells with sharp edges are those of coarse, curved surfaces. Measured
/// with 2000 generators: at most 4 on the elephant and 2 on spot, and 391 on the fandisk. Of few generators an eighth
/// is enough.
inline constexpr std::int64_t kLeastCreaseCells = 12;

/// What the sharp edges and the boundary want from the vertex of a cell.
struct CreaseCell {
  bool is_creased = false;        ///< its triangles should meet a crease, or the boundary while the generator is off it
  Vec3 direction = Vec3::Zero();  ///< unit, along the crease; zero where there is none, or where several meet
};

/// Of all cells. `remesh`: has its vertices at the generators. Cost: O(n log n).
IdVector<GeneratorId, CreaseCell> find_crease_cells(const Mesh& surface, const Diagram& diagram, const Mesh& remesh);

}  // namespace gvd
