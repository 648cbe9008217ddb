#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "gvd/appearance.hpp"
#include "gvd/diagram.hpp"
#include "gvd/distance_samples.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/io/distance_writer.hpp"
#include "gvd/io/label_color.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/mesh.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// One row of the table beside the picture.
struct ViewFigure {
  std::string name;
  std::string value;
};

/// The distances of a scene's surface from another surface. None of the scene's faces may be cut.
struct ViewSurfaceDistance {
  std::string other;        ///< what the distances are measured from, such as "the input"
  DistanceSamples samples;  ///< finite and >= 0, mesh units
  double reference = 0;     ///< > 0, mesh units; the page also shows distances in percent of it
  double scale_end = 0;     ///< > 0, mesh units; the colour scale ends here, and larger distances have its last colour
};

/// Another surface, drawn translucent over the surface of a scene.
struct ViewOverlay {
  std::string name;
  const Mesh* mesh = nullptr;  ///< not owned; must outlive the call that makes the page
};

/// Shortest paths from vertices. When its reader clicks on the surface, the page shows the path from the nearest of
/// them.
struct ViewVertexPaths {
  std::vector<VertexId> vertices;         ///< ascending
  std::vector<std::vector<Vec3>> points;  ///< for each vertex, the points from there to its generator
};

/// One picture of a page: a surface, and what lies on it. Positions and distances are in mesh units.
/// Everything but the mesh may be empty; the page has no switch for empty parts.
struct ViewScene {
  std::string name;  ///< for the switch of a page with several scenes; if empty, only the slider chooses the scene
  const Mesh* mesh = nullptr;                ///< not owned; must outlive the call that makes the page
  IdVector<FaceId, GeneratorId> face_label;  ///< invalid where the face is cut or no generator reaches it
  std::vector<FacePiece> pieces;             ///< pieces of the cut faces, drawn in place of these faces
  std::vector<Rgb> region_color;  ///< colour of each label; if empty, colours are chosen so that neighbours differ
  IdVector<VertexId, double> vertex_distance;  ///< infinity where no generator reaches
  std::vector<std::vector<Vec3>> bisectors;    ///< polylines; a closed bisector repeats its first point at its end
  std::vector<std::vector<Vec3>> borders;      ///< borders of given regions, which no cell crosses
  std::vector<std::vector<Vec3>> isolines;     ///< curves of equal distance; a closed isoline repeats its first point
  std::vector<std::vector<Vec3>> paths;        ///< shortest paths
  ViewVertexPaths vertex_paths;                ///< for clicks; needs distances
  std::vector<Vec3> generators;                ///< the given generators, in the order of their ids
  std::vector<Vec3> added_generators;          ///< generators that a command added, drawn in a different colour
  std::vector<Vec3> branch_points;
  std::vector<Uv> texture;  ///< texture coordinates of corners, for a checkerboard; not finite for a corner without
  IdVector<GeneratorId, Cell> cells;          ///< for the figures of regions and, if faces are cut, their colours
  IdVector<GeneratorId, double> cell_energy;  ///< integral of the squared distance per cell, mesh units to the fourth
  std::optional<ViewSurfaceDistance> surface_distance;
  std::optional<ViewOverlay> overlay;
  std::vector<Vec3> vertex_generators;    ///< for a remesh: the generators that its vertices stand for
  std::vector<ViewFigure> figures;        ///< in the order of the table
  std::optional<std::int64_t> iteration;  ///< >= 0, for the slider of a page with scenes of several iterations
  bool wireframe = false;                 ///< draw the edges of the mesh at the start
  bool smooth = true;                     ///< interpolate normals across edges flatter than 40 degrees at the start
};

/// The axis that points up at the start.
enum class UpAxis { x, y, z, minus_x, minus_y, minus_z };
inline const Choices<UpAxis> kUpAxisNames{{"x", UpAxis::x},        {"y", UpAxis::y},        {"z", UpAxis::z},
                                          {"-x", UpAxis::minus_x}, {"-y", UpAxis::minus_y}, {"-z", UpAxis::minus_z}};

struct ViewOptions {
  std::string title = "Geodesic Voronoi diagram";  ///< UTF-8; invalid bytes are replaced
  UpAxis up = UpAxis::y;
  Progress progress = {};  ///< may be empty
};

/// Makes the scene of a diagram, with figures: size, topology, length of the bisectors, and the Euler count, which
/// compares the number of branch points with the number that the topology demands (docs/guide/viewer.md).
/// Cost: O(n) time and memory.
ViewScene make_view_scene(std::string name, const Mesh& mesh, const Diagram& diagram);

/// Makes the scene of a mesh with labels, as its files hold it: whole faces with their labels, or the mesh that was cut
/// along the bisectors. The figures count the faces and vertices of this mesh and, if it was cut, the faces before the
/// cut. All other figures are those of the diagram.
/// Throws Error{precondition} if `shown` has no diagram, no labels of faces or no distances. Cost: O(n) time and
/// memory.
ViewScene make_view_scene(std::string name, const LabelledMesh& shown);

/// Makes the scenes of labelled regions. If whole faces have labels, a scene with the cells of the diagram comes first,
/// in the same colours, because whole faces can't show where bisectors run through them. Errors and cost are those of
/// make_view_scene.
std::vector<ViewScene> make_region_scenes(const LabelledMesh& shown);

/// The largest number of points that the paths of `make_distance_scene` for clicks have together. They take 2 MB of the
/// page.
inline constexpr std::size_t kMostPathPoints = 300'000;

/// Makes the scene of distances from the nearest of several sources: the distances of the vertices, the table's
/// sources, paths and isolines, and exact shortest paths of vertices for clicks. There is a path for every vertex or,
/// if these have more than about kMostPathPoints points, for every second, third, ... vertex.
/// Cost: O(vertices), and O(faces crossed) for each path.
ViewScene make_distance_scene(std::string name, const Mesh& mesh, const ExactField& field, const DistanceTable& table);

/// Whether this library was built with the viewer (CMake option GVD_WITH_VIEWER).
bool has_viewer();

/// Makes a self-contained HTML page that shows the scenes. Its reader can turn and zoom, colour the surface by region,
/// area, distance, energy, quality or angle, see the figures of each region or, if there are none, of faces and
/// vertices, and switch between scenes.
///
/// Properties: (1) the page needs no file and no network when it is opened; (2) the same input gives the same bytes;
/// (3) the borders of regions follow the pieces inside the cut faces; (4) an array that several scenes share is stored
/// once; (5) a large mesh takes less than 25 bytes a face, beside 250 kB for the page itself; (6) regions with a common
/// border differ by at least 14 in CIEDE2000, for the colour-blind too, on surfaces of genus 3 and less;
/// (7) from one iteration of the slider to the next, regions keep their colours as far as that allows.
/// Throws Error{invalid_option} if the library was built without the viewer; Error{interrupted} if the progress
/// callback cancels; Error{precondition} if a scene has no mesh, the size of an array doesn't match the mesh, or a
/// value is out of its range.
/// Cost: O(n) time and memory.
std::string make_view_page(const std::vector<ViewScene>& scenes, const ViewOptions& options = {});

/// The same for a single scene.
std::string make_view_page(const ViewScene& scene, const ViewOptions& options = {});

}  // namespace gvd
