#pragma once

#include <compare>
#include <vector>

#include "dual/placed_faces.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/remesh_certificate.hpp"

namespace gvd {

/// The pairs of faces that have a common point outside of the vertex or edge that they share, ascending.
///
/// Faces that only touch intersect, too. Properties: (1) exact, unless products of three coordinates underflow; (2)
/// empty if and only if the mesh is embedded, provided that no face is degenerate; (3) the result does not depend on
/// `threads` (0: one for each core). Throws Error{interrupted} if `progress` cancels. Cost: O(n log n) if the box of a
/// face overlaps a bounded number of others.
std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads = 0, const Progress& progress = {});

/// The same for a mesh whose vertices have moved. A pair is looked for if `counts` is set for one of its faces; if
/// `counts` is empty, all pairs are.
std::vector<FacePair> find_self_intersections(const PlacedFaces& faces, int threads, const Progress& progress = {},
                                              const std::vector<char>& counts = {});

/// Two cells of a diagram, or one cell twice: first <= second.
struct CellPair {
  GeneratorId first, second;
  auto operator<=>(const CellPair&) const = default;
};

/// The pairs of cells in which a surface intersects itself, ascending.
///
/// `given` are the pairs of faces that intersect on the surface (find_self_intersections). A piece of a face is its
/// part in one cell (FacePart), or the face itself. Cells a and b intersect if, for one of these pairs of faces, a
/// piece of one face in a and a piece of the other face in b have overlapping bounding boxes. So a large face counts
/// only with its cells near the other face. Cost: O(k) for the k pieces of `given`, and O(1) for each comparison of a
/// piece of the first face near the second with a piece of the second face near the first. Throws Error{interrupted} if
/// `progress` cancels.
std::vector<CellPair> find_intersecting_cells(const Mesh& surface, const Diagram& diagram,
                                              const std::vector<FacePair>& given, const Progress& progress = {});

/// The pairs of faces of a remesh under which the surface intersects itself, ascending. Only such pairs can be
/// inherited (find_inherited_pairs).
///
/// The part of the surface under a face of the remesh consists of the cells of its three corners; vertex i stands for
/// cell i. The surface intersects itself between two parts if a cell of one face and a cell of the other one are among
/// `cells`, the pairs of find_intersecting_cells. Distances in space play no part. A one-to-one map of the surface
/// (map_to_remesh) makes each face the image of a piece of each of its three cells. Whole cells count all the same,
/// because a coarse mesh moves a curve of intersection aside: judged by the pieces alone, a face near the end of
/// another one at the curve could be on its wrong side, however fine the mesh is. `pairs` is the result of
/// find_self_intersections for the remesh. Cost: O(p log q) for p pairs and q pairs of cells.
std::vector<FacePair> find_inherited(const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     const std::vector<CellPair>& cells);

}  // namespace gvd
