#pragma once

#include "face_shares.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

namespace gvd {

/// Gives a face to each generator whose label no face has, in the order of the generators.
///
/// Candidates are the faces that contain the generator, then the other faces with a share of its cell. Both groups are
/// in descending order of the share. The first candidate is taken whose label keeps another face and stays connected
/// without this one. Counts `given_faces`, and lists in `without_face` the generators without such a candidate.
/// Cost: O(n), and for each such generator a search through the region that may lose a face.
void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result);

}  // namespace gvd
