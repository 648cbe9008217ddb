// Makes the scene of distances from sources: colours, curves, and the shortest paths of vertices, which the page shows
// on a click.
//
// The page can't compute an exact path, because descending along the vertices' distances gives another curve. So the
// scene stores exact paths of vertices. A path crosses hundreds of faces, and the paths of all vertices of a large mesh
// would make the page too large. In that case only every second, third, ... vertex has a path; the stride follows from
// the mean number of points in a sample of paths.
// Invariant: a stored path is the exact path of its vertex, which the page names.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gvd/io/view.hpp"

namespace gvd {
namespace {

/// Number of paths traced to estimate the mean number of points of a path.
constexpr std::size_t kSamplePaths = 200;

/// Number of paths whose lengths the page lists; the files have them all.
constexpr std::size_t kListedPaths = 12;

std::vector<Vec3> positions(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::vector<Vec3> result;
  for (const SurfacePoint& point : points) result.push_back(position(mesh, point));
  return result;
}

/// The paths of every `stride`-th vertex that a source reaches.
ViewVertexPaths collect_paths(const Mesh& mesh, const ExactField& field, std::size_t stride) {
  ViewVertexPaths paths;
  for (std::size_t i = 0; i < std::size_t(mesh.vertex_count()); i += stride) {
    const GeodesicPath path = field.path(vertex_point(mesh, VertexId(i)));
    if (!path.complete) continue;
    paths.vertices.emplace_back(i);
    paths.points.push_back(positions(mesh, path.points));
  }
  return paths;
}

std::size_t count_points(const ViewVertexPaths& paths) {
  std::size_t points = 0;
  for (const auto& path : paths.points) points += path.size();
  return points;
}

std::vector<ViewFigure> make_figures(const Mesh& mesh, const ViewScene& scene, const DistanceTable& table) {
  double largest = 0;
  std::int64_t unreached = 0;
  for (const double d : scene.vertex_distance) {
    unreached += !std::isfinite(d);
    if (std::isfinite(d)) largest = std::max(largest, d);
  }
  std::vector<ViewFigure> figures{{"Faces", fmt::format("{}", mesh.face_count())},
                                  {"Vertices", fmt::format("{}", mesh.vertex_count())},
                                  {"Sources", fmt::format("{}", table.sources.size())},
                                  {"Largest distance of a vertex", fmt::format("{:.6g}", largest)}};
  if (unreached > 0) figures.push_back({"Unreached vertices", fmt::format("{}", unreached)});
  for (std::size_t i = 0; i < std::min(table.paths.size(), kListedPaths); ++i) {
    const TargetPath& path = table.paths[i];
    figures.push_back(
        {fmt::format("Path from {} to {}", table.target_name(std::size_t(path.target)), table.source_name(path.source)),
         fmt::format("{:.6g}", path.path.length)});
  }
  figures.push_back({"Vertices with a path for clicks",
                     fmt::format("{} of {}", scene.vertex_paths.vertices.size(), mesh.vertex_count())});
  return figures;
}

}  // namespace

ViewScene make_distance_scene(std::string name, const Mesh& mesh, const ExactField& field, const DistanceTable& table) {
  ViewScene scene;
  scene.name = std::move(name);
  scene.mesh = &mesh;
  for (const VertexId v : mesh.vertices()) scene.vertex_distance.push_back(field.distance(v));
  scene.generators = positions(mesh, table.sources);
  for (const TargetPath& path : table.paths) scene.paths.push_back(path.positions);
  for (const Isoline& line : table.isolines) {
    scene.isolines.push_back(positions(mesh, line.points));
    if (line.closed) scene.isolines.back().push_back(scene.isolines.back().front());
  }
  const std::size_t vertices = mesh.vertex_count(), apart = std::max<std::size_t>(1, vertices / kSamplePaths);
  const ViewVertexPaths sample = collect_paths(mesh, field, apart);
  const double points = double(count_points(sample)) * double(apart);
  const double stride = std::ceil(points / double(kMostPathPoints));
  scene.vertex_paths = collect_paths(mesh, field, std::max<std::size_t>(1, static_cast<std::size_t>(stride)));
  scene.figures = make_figures(mesh, scene, table);
  return scene;
}

}  // namespace gvd
