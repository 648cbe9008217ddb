#pragma once

#include "gvd/diagram.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Parts regions that touch themselves at a vertex: round it, the faces of a label are not consecutive.
///
/// All but one of the sectors of a label give their corners at the vertex, a tiny part of their faces, to a region
/// beside them, or the region between two sectors gives its corner to these if they are not connected otherwise.
/// `cells` are those of the diagram: a corner goes to a cell only that has a bisector with its own. `tolerance`: see
/// position_tolerance. Faces that are cut stay in the order of their parents, with new vertices behind the others.
/// Regions still touch themselves where only labels without such a bisector surround them, or where two labels
/// alternate that both are connected already.
/// Cost: O(n) where no label changes four times round a vertex, otherwise O(n log n) for each of a few rounds.
void part_touching_regions(const IdVector<GeneratorId, Cell>& cells, double tolerance, CutMesh& cut);

}  // namespace gvd
