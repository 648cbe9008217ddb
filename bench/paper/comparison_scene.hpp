#pragma once

#include <string>
#include <vector>

#include "comparator.hpp"
#include "gvd/io/view.hpp"

namespace gvd::paper {

/// A scene of a comparator's diagram, which has no distances and no branch points: figures 10 and 11 as pictures. The
/// mesh must outlive the scene. Its figures are the length of the bisectors and the faults.
ViewScene make_comparison_scene(std::string name, const Mesh& mesh, const Comparison& comparison);

/// Gives each cell the neighbours that it has in any of the scenes, which have the same generators. Colours follow from
/// the neighbours, so that a cell has one colour in all scenes.
void share_neighbours(std::vector<ViewScene>& scenes);

}  // namespace gvd::paper
