#pragma once

#include <vector>

#include "comparator.hpp"
#include "pieces/piece_contacts.hpp"

namespace gvd::paper {

/// Fills the diagram and the faults of a comparison from the pieces that a comparator has made; adds to the faults that
/// it counted itself. A bisector runs wherever pieces of two generators have a contact, along an edge of the mesh too.
/// Nothing is repaired. Cost: O(n + k log k) for n pieces and k segments of bisectors.
void collect_pieces(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Pieces pieces,
                    Comparison& comparison);

/// Sum of the areas of the pieces, square mesh units: that of the mesh, if they cover it.
double sum_areas(const Mesh& mesh, const Pieces& pieces);

}  // namespace gvd::paper
