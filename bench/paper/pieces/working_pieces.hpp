#pragma once

#include "mesh/working_mesh.hpp"
#include "pieces/piece_contacts.hpp"

namespace gvd::paper {

/// The pieces of a working mesh as pieces of its input, ascending by face. A face that generators have split is cut
/// into pieces of its own, even if they have one label.
Pieces take_to_input(const WorkingMesh& working, Pieces pieces);

}  // namespace gvd::paper
