#pragma once

#include <cstdint>
#include <vector>

#include "face_shares.hpp"
#include "gvd/segment.hpp"
#include "region_topology.hpp"

namespace gvd {

/// The edge-connected components of the faces of each label.
struct LabelComponents {
  struct Component {
    GeneratorId label;
    double area = 0;  ///< square mesh units
  };
  std::vector<Component> components;         ///< in the order of their first faces
  IdVector<FaceId, std::int32_t> component;  ///< for every face; -1 for a face without a label
};

/// Finds the components. Cost: O(n).
LabelComponents find_label_components(const Mesh& mesh, const FaceLabelling& label);

/// Gives a face to each generator that owns none, in the order of the generators.
///
/// Candidates are the faces that contain the generator, then the other faces in which its cell has a share, both in
/// descending order of the share. The generator gets the first candidate without which the candidate's present label
/// still has a face and stays connected. Counts `given_faces`, and lists generators without such a candidate in
/// `without_face`.
/// Cost: O(n), and for each such generator a search through the region that may lose a face.
void assign_missing_faces(const Mesh& mesh, const Diagram& diagram, const FaceShares& shares, Segmentation& result,
                          const Progress& progress = {});

}  // namespace gvd
