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

/// Distances of a scene's surface, none of whose faces is cut, from another one.
struct ViewSurfaceDistance {
  std::string other;        ///< "the input": what the distances are from
  DistanceSamples samples;  ///< finite and >= 0, mesh units
  double reference = 0;     ///< > 0, mesh units: the page shows distances in percent of it, too
  double scale_end = 0;     ///< > 0, mesh units: larger distances have the last colour, too
};

/// Another surface, drawn translucent with that of a scene.
struct ViewOverlay {
  std::string name;
  const Mesh* mesh = nullptr;  ///< not owned; must outlive the call that makes the page
};

/// Shortest paths of vertices, of which the page shows that of the one nearest to where its reader clicks.
struct ViewVertexPaths {
  std::vector<VertexId> vertices;         ///< ascending
  std::vector<std::vector<Vec3>> points;  ///< of each: from the vertex to its generator
};

/// One picture of a page: a surface, and what lies on it. Positions and distances are in mesh units.
/// Everything but the mesh may be empty; the page has no switch for what is empty.
struct ViewScene {
  std::string name;  ///< for the switch of a page with several scenes; without one, the slider alone chooses it
  const Mesh* mesh = nullptr;                  ///< not owned; must outlive the call that makes the page
  IdVector<FaceId, GeneratorId> face_label;    ///< invalid where the face is cut or no generator reaches it
  std::vector<FacePiece> pieces;               ///< of the cut faces, drawn in place of the faces
  std::vector<Rgb> region_color;               ///< of each label; empty: chosen so that neighbours differ
  IdVector<VertexId, double> vertex_distance;  ///< infinity where no generator reaches
  std::vector<std::vector<Vec3>> bisectors;    ///< polylines; a closed one repeats its first point at its end
  std::vector<std::vector<Vec3>> borders;      ///< of given regions, that the cells keep to
  std::vector<std::vector<Vec3>> isolines;     ///< curves of equal distance; a closed one repeats its first point
  std::vector<std::vector<Vec3>> paths;        ///< shortest paths
  ViewVertexPaths vertex_paths;                ///< for clicks; needs distances
  std::vector<Vec3> generators;                ///< the given ones, in the order of their ids
  std::vector<Vec3> added_generators;          ///< added by a command; drawn in a colour of their own
  std::vector<Vec3> branch_points;
  std::vector<Uv> texture;  ///< coordinates of the faces' corners, for a checkerboard; not finite where there are none
  IdVector<GeneratorId, Cell> cells;          ///< for the figures of regions and, where faces are cut, their colours
  IdVector<GeneratorId, double> cell_energy;  ///< integral of the squared distance per cell, mesh units to the fourth
  std::optional<ViewSurfaceDistance> surface_distance;
  std::optional<ViewOverlay> overlay;
  std::vector<Vec3> vertex_generators;    ///< of a remesh: the generators that its vertices stand for
  std::vector<ViewFigure> figures;        ///< in the order of the table
  std::optional<std::int64_t> iteration;  ///< >= 0; for the slider of a page with scenes of several iterations
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

/// The scene of a diagram, with its figures: size, topology, length of the bisectors, and the Euler count, which
/// compares the branch points with those that the topology demands (docs/guide/viewer.md).
/// Cost: O(n) time and memory.
ViewScene make_view_scene(std::string name, const Mesh& mesh, const Diagram& diagram);

/// The scene of a mesh with labels, as its files hold it: whole faces with their labels, or the mesh that was cut along
/// the bisectors. Faces and vertices in the figures are those of this mesh; where it was cut, the faces before the cut
/// follow. All other figures are the diagram's.
/// Throws Error{precondition} where it has no diagram, labels of faces or distances. Cost: O(n) time and memory.
ViewScene make_view_scene(std::string name, const LabelledMesh& shown);

/// The scenes of labelled regions: where whole faces have labels, the cells of the diagram come first, in the same
/// colours, since whole faces lie on both sides of bisectors. Throws and costs as make_view_scene.
std::vector<ViewScene> make_region_scenes(const LabelledMesh& shown);

/// The points of all paths that `make_distance_scene` takes for clicks: 2 MB of the page.
inline constexpr std::size_t kMostPathPoints = 300'000;

/// The scene of distances from the nearest of several sources: the distances of the vertices, the table's sources,
/// paths and isolines, and shortest paths of vertices. These are the exact ones of all vertices or, where they have
/// more than about kMostPathPoints points, of every second, third, ... vertex.
/// Cost: O(vertices), and O(faces crossed) for each path.
ViewScene make_distance_scene(std::string name, const Mesh& mesh, const ExactField& field, const DistanceTable& table);

/// Whether this library carries the page (CMake option GVD_WITH_VIEWER).
bool has_viewer();

/// A self-contained HTML page that shows the scenes. Its reader can turn and zoom, colour the surface by region, area,
/// distance, energy, quality or angle, see the figures of each region or, where there are none, of faces and vertices,
/// and switch between scenes.
///
/// Properties: (1) the page needs no file and no network when it is opened; (2) the same input gives the same bytes;
/// (3) the borders of regions follow the pieces inside the cut faces; (4) an array that several scenes share is stored
/// once; (5) a large mesh takes less than 25 bytes a face, beside 250 kB for the page itself; (6) regions with a common
/// border differ by at least 14 in CIEDE2000, for the colour-blind too, on surfaces of genus 3 and less;
/// (7) from one iteration of the slider to the next, regions keep their colours as far as that allows.
/// Throws Error{invalid_option} where the library was built without the viewer; Error{interrupted} if the progress
/// callback cancels; Error{precondition} where a scene has no mesh, an array has not the size of the mesh, or a value
/// is out of its range.
/// Cost: O(n) time and memory.
std::string make_view_page(const std::vector<ViewScene>& scenes, const ViewOptions& options = {});

/// A page with one scene.
std::string make_view_page(const ViewScene& scene, const ViewOptions& options = {});

}  // namespace gvd
