#include "shortest_paths.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "gvd/error.hpp"
#include "gvd/vec.hpp"

namespace gvd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
using Vertex = SurfaceMesh::Vertex_index;
using Face = SurfaceMesh::Face_index;

Vertex vertex_of(int index) { return Vertex(static_cast<SurfaceMesh::size_type>(index)); }

SurfaceMesh build_surface(const PathSubmesh& submesh) {
  SurfaceMesh surface;
  for (const Vec3& p : submesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : submesh.faces) {
    const Face f = surface.add_face(vertex_of(a), vertex_of(b), vertex_of(c));
    if (f == SurfaceMesh::null_face()) throw Error(ErrorCode::no_valid_result, "CGAL rejects the surface");
    // In CGAL, the first barycentric coordinate belongs to the source of the face's halfedge.
    const auto h = surface.halfedge(vertex_of(a), vertex_of(b));
    surface.set_halfedge(f, h);
  }
  return surface;
}

/// CGAL's distance; infinity for a negative one, which means "no path", and for NaN, which degenerate faces can give.
double checked(double distance) { return distance >= 0 ? distance : kInfinity; }

/// The minimum of CGAL's distance in the target's face and of the paths through the face's corners. The latter matter
/// where a path passes very close to a corner: by rounding it can miss the windows on both sides.
double solve_target(ShortestPath& paths, const PathSubmesh& submesh, const PathSubmesh::Target& target) {
  const Face f(static_cast<SurfaceMesh::size_type>(target.face));
  const std::array<int, 3>& corners = submesh.faces[target.face];
  Vec3 at = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) at += target.bary[i] * submesh.positions[corners[i]];
  double best = checked(paths.shortest_distance_to_source_points(f, target.bary).first);
  for (const int corner : corners) {
    const double to_corner = checked(paths.shortest_distance_to_source_points(vertex_of(corner)).first);
    best = std::min(best, to_corner + (submesh.positions[corner] - at).norm());
  }
  return best;
}

void ignore(const char*, const char*, const char*, int, const char*) {}

}  // namespace

std::vector<double> solve_shortest_paths(const PathSubmesh& submesh) {
  try {
    const SurfaceMesh surface = build_surface(submesh);
    ShortestPath paths(surface);
    paths.add_source_point(vertex_of(submesh.source));
    paths.build_sequence_tree();
    std::vector<double> distances;
    distances.reserve(submesh.targets.size());
    for (const PathSubmesh::Target& target : submesh.targets) distances.push_back(solve_target(paths, submesh, target));
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
