#include "shortest_paths.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gvd/error.hpp"

namespace gvd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
using Vertex = SurfaceMesh::Vertex_index;
using Face = SurfaceMesh::Face_index;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vertex vertex_of(int index) { return Vertex(static_cast<SurfaceMesh::size_type>(index)); }

SurfaceMesh build_surface(const Reach& reach) {
  SurfaceMesh surface;
  for (const Vec3& p : reach.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : reach.faces) {
    const Face f = surface.add_face(vertex_of(a), vertex_of(b), vertex_of(c));
    if (f == SurfaceMesh::null_face()) throw Error(ErrorCode::no_valid_result, "CGAL refuses the surface");
    // CGAL counts barycentric coordinates from the source of the face's halfedge.
    const auto h = surface.halfedge(vertex_of(a), vertex_of(b));
    surface.set_halfedge(f, h);
  }
  return surface;
}

/// CGAL's distance, with its sign for "no path" (and whatever an area of zero made of it) turned into infinity.
double checked(double distance) { return distance >= 0 ? distance : kInfinity; }

/// The least of what CGAL finds in the target's face and of the ways through its corners. The corners close the gap
/// of a path that grazes one: by rounding it can miss both windows beside the corner.
double solve_target(ShortestPath& paths, const Reach& reach, const Reach::Target& target) {
  const Face f(static_cast<SurfaceMesh::size_type>(target.face));
  const std::array<int, 3>& corners = reach.faces[static_cast<std::size_t>(target.face)];
  Vec3 at = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) at += target.bary[i] * reach.positions[static_cast<std::size_t>(corners[i])];
  double best = checked(paths.shortest_distance_to_source_points(f, target.bary).first);
  for (const int corner : corners) {
    const double to_corner = checked(paths.shortest_distance_to_source_points(vertex_of(corner)).first);
    best = std::min(best, to_corner + (reach.positions[static_cast<std::size_t>(corner)] - at).norm());
  }
  return best;
}

void ignore(const char*, const char*, const char*, int, const char*) {}

}  // namespace

std::vector<double> solve_shortest_paths(const Reach& reach) {
  try {
    const SurfaceMesh surface = build_surface(reach);
    ShortestPath paths(surface);
    paths.add_source_point(vertex_of(reach.source));
    paths.build_sequence_tree();
    std::vector<double> distances;
    distances.reserve(reach.targets.size());
    for (const Reach::Target& target : reach.targets) distances.push_back(solve_target(paths, reach, target));
    return distances;
  } catch (const CGAL::Failure_exception& failure) {
    throw Error(ErrorCode::no_valid_result,
                "CGAL's shortest paths fail on this surface (" + failure.expression() + ")");
  }
}

QuietCgal::QuietCgal() : on_error_(CGAL::set_error_handler(ignore)), on_warning_(CGAL::set_warning_handler(ignore)) {}

QuietCgal::~QuietCgal() {
  CGAL::set_error_handler(on_error_);
  CGAL::set_warning_handler(on_warning_);
}

}  // namespace gvd
