#pragma once

#include <cstddef>
#include <iosfwd>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/segment.hpp"

// What gvd-segment tells of its regions: members of the report, notes, and the JSON of -o.
namespace gvd::app {

/// Adds moved, given and smoothed faces, and the generators without a face, to the member `results` of the report.
void report_segmentation(nlohmann::ordered_json& results, const Segmentation& segmentation);

/// Adds the length of the borders, and its ratio to that of the bisectors. Both in mesh units.
void report_borders(nlohmann::ordered_json& results, double border_length, double bisector_length);

/// Adds the number of faces, those that no generator reaches, and the size of each of `count` regions.
void report_regions(nlohmann::ordered_json& results, const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label,
                    std::size_t count);

/// The note on generators that own no face. It names a few of them; the report lists all.
std::string describe_without_face(const std::vector<GeneratorId>& without_face);

/// Faces that no generator reaches.
std::int64_t count_unreached(const IdVector<FaceId, GeneratorId>& label);

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
