#pragma once

#include <cstdint>
#include <vector>

#include "face_shares.hpp"
#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

// The steps of `segment_faces`, in their order. Smoothing is in smooth_borders.cpp, all others are in
// segment_faces.cpp.

namespace gvd {

/// Calls visit(g) for every face g that shares an edge with f; twice for one that shares two edges.
template <class Visit>
void for_each_adjacent_face(const Mesh& mesh, FaceId f, Visit visit) {
  for (int corner = 0; corner < 3; ++corner) {
    const HalfedgeId twin = mesh.twin(Mesh::halfedge(f, corner));
    if (twin.valid()) visit(Mesh::face(twin));
  }
}

/// The edge-connected components of the faces of each label.
struct LabelComponents {
  struct Component {
    GeneratorId label;
    double area = 0;  ///< square mesh units
  };
  std::vector<Component> components;         ///< in the order of their first face
  IdVector<FaceId, std::int32_t> component;  ///< of every face; -1 for a face without a label
};

/// Finds the components. Cost: O(n).
LabelComponents find_label_components(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label);

/// Gives a face to each generator whose label no face has, in the order of the generators.
///
/// Candidates are the faces that contain the generator, then the other faces with a share of its cell. Both groups are
/// in descending order of the share. The first candidate is taken whose label keeps another face and stays connected
/// without this one. Counts `given_faces`, and lists in `without_face` the generators without such a candidate.
/// Cost: O(n), and for each such generator a search through the region that may lose a face.
void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result);

/// Whether face f can pass from its label to `to` without a change of topology.
///
/// If so: (1) the faces of both labels stay connected, and neither label vanishes; (2) the Euler characteristics of
/// both open regions stay, so discs stay discs; (3) no region touches itself at a vertex where it did not before.
/// The answer is no where a vertex that decides has more than 256 faces. Cost: O(1).
bool keeps_topology(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, FaceId f, GeneratorId to);

/// Shortens the borders between the regions of `result`. Only free faces (see FreeFaces) change their label, and only
/// to that of a cell with a share of the face.
///
/// Properties: (1) the border does not become longer; (2) the regions keep their topology (see keeps_topology).
/// Counts `smoothed_faces`. Cost: O(n + k) for k shares.
void smooth_borders(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result);

}  // namespace gvd
