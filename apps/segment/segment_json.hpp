#pragma once

#include <ostream>

#include "gvd/diagram.hpp"
#include "gvd/segment.hpp"

namespace gvd::app {

/// Writes the diagram as `gvd-diagram/1` with one more member, `"face_labels"`: the label of each face, -1 for none.
void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation);

/// The same with the member `"cut_mesh"`: `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"labels":[],"parents":[]}`, the last
/// two one for each face.
void write_cut_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram, const CutMesh& cut);

}  // namespace gvd::app
