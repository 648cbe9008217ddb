#pragma once

#include "gvd/diagram.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Separates regions that touch themselves at a vertex, around which the faces of their label are not consecutive.
///
/// All but one of the sectors of a label give their corners at the vertex, a tiny part of their faces, to a region
/// beside them. If two sectors are not connected otherwise, the region between them gives its corner to them. `cells`
/// are the cells of the diagram: a corner goes only to a cell that has a bisector with its own. `tolerance`: see
/// `position_tolerance`. Cut faces stay in the order of their parents, and new vertices are appended. Regions still
/// touch themselves where only labels without such a bisector surround them, or where two labels alternate that are
/// both already connected.
/// Cost: O(n) if labels change fewer than four times around each vertex, otherwise O(n log n) for each of a few rounds.
void part_touching_regions(const IdVector<GeneratorId, Cell>& cells, double tolerance, CutMesh& cut);

}  // namespace gvd
