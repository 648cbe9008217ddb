#pragma once

#include <ostream>

#include "gvd/diagram.hpp"
#include "gvd/segment.hpp"

namespace gvd::app {

/// Writes the diagram as `gvd-diagram/1` with one more member, `"face_labels"`: the label of each face, -1 for none.
void write_segmentation_json(std::ostream& out, const Mesh& mesh, const Diagram& diagram,
                             const Segmentation& segmentation);

/// A mesh, its diagram, and the mesh cut along the diagram's bisectors. It owns nothing.
struct CutOutput {
  const Mesh& mesh;
  const Diagram& diagram;
  const CutMesh& cut;
  const CutVertices& vertices;
};

/// The same with the member `"cut_mesh"`: `{"vertices":[[x,y,z]],"faces":[[a,b,c]],"labels":[],"parents":[],
/// "vertex_labels":[],"vertex_distances":[]}`: labels and parents are those of the faces; a distance is null for none.
void write_cut_json(std::ostream& out, const CutOutput& output);

}  // namespace gvd::app
