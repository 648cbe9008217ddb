#pragma once

#include "face_shares.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Shortens the borders between the regions of `result`. Only free faces (see FreeFaces) change their label, and only
/// to that of a cell with a share of the face.
///
/// The shortest borders are a minimum multiway cut of the faces that bisectors cross. BorderForest chooses many labels
/// at once; they are applied face by face, each only where the topology stays. Four times this is done, with trees that
/// begin elsewhere. Single faces follow, until none shortens a border.
///
/// Properties: (1) the border does not become longer; (2) the regions keep their topology (see keeps_topology).
/// Counts `smoothed_faces`. Cost: O(n + k) for k shares.
void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result);

}  // namespace gvd
