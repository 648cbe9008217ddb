#pragma once

#include <string>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// One row of the table of figures beside the picture.
struct ViewFigure {
  std::string name;
  std::string value;
};

/// One picture of a page: a surface, and what lies on it. Positions and distances are in mesh units.
/// Everything but the mesh may be empty; what is empty is not offered to the reader of the page.
struct ViewScene {
  std::string name;                            ///< names the picture where a page has several
  const Mesh* mesh = nullptr;                  ///< not owned; must outlive the call that makes the page
  IdVector<FaceId, GeneratorId> face_label;    ///< invalid where the face is cut or nothing reaches it
  std::vector<FacePiece> pieces;               ///< of the cut faces; they take the face's place
  IdVector<VertexId, double> vertex_distance;  ///< infinity where no generator reaches
  std::vector<std::vector<Vec3>> bisectors;    ///< polylines; a closed one repeats its first point at its end
  std::vector<Vec3> generators;                ///< the given ones, in the order of their ids
  std::vector<Vec3> added_generators;          ///< those that a command added: drawn in a colour of their own
  std::vector<Vec3> branch_points;
  IdVector<GeneratorId, Cell> cells;  ///< what the page says about the region under the pointer
  std::vector<ViewFigure> figures;    ///< in the order in which they are shown
  bool wireframe = false;             ///< draw the mesh's edges from the start
  bool smooth = true;                 ///< interpolate normals across edges flatter than 40 degrees, from the start
};

/// Which axis points up from the start.
enum class UpAxis { y, z };

struct ViewOptions {
  std::string title = "Geodesic Voronoi diagram";  ///< UTF-8; what is not valid is replaced
  UpAxis up = UpAxis::y;
};

/// The picture of a diagram, with its figures: size, topology, length of the bisectors, and the Euler count, which
/// says how many of the meetings of cells that the topology demands are there (docs/guide/viewer.md).
/// Cost: O(n) time and memory.
ViewScene make_view_scene(std::string name, const Mesh& mesh, const Diagram& diagram);

/// Whether this library carries the page (CMake option GVD_WITH_VIEWER).
bool has_viewer();

/// A self-contained HTML page that shows the scenes: turn, zoom, hover a region for its figures, and a switch
/// between the scenes where there are several.
///
/// Properties: (1) the page needs no file and no network when it is opened; (2) the same input gives the same bytes;
/// (3) region borders run inside the cut faces, along the pieces; (4) an array that several scenes share is stored
/// once; (5) less than 40 bytes a face of a large mesh, beside the page's own 600 kB. Throws Error{invalid_option}
/// where the library was built without the viewer, and Error{precondition} where a scene has no mesh, an array has not
/// the mesh's size, or a face, label or coordinate is out of its range. Cost: O(n) time and memory.
std::string make_view_page(const std::vector<ViewScene>& scenes, const ViewOptions& options = {});

/// A page with one scene.
std::string make_view_page(const ViewScene& scene, const ViewOptions& options = {});

}  // namespace gvd
