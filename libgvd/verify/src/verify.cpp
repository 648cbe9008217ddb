// Computes exact distances by CGAL, independently of the library's own solvers. This is the only file that includes
// CGAL.
//
// Idea: one query for each generator, on the part of the mesh that its shortest paths can visit, on several threads.
// Source: Xin and Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, 2009, as CGAL's
// Surface_mesh_shortest_path implements it.
// Invariant: queries share no data, so the results are the same for any number of threads.
#include "gvd/verify.hpp"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/exceptions.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/parallel_chunks.hpp"
#include "gvd/error.hpp"
#include "gvd/vec.hpp"
#include "path_submesh.hpp"
#include "quiet_cgal.hpp"

namespace gvd {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Traits = CGAL::Surface_mesh_shortest_path_traits<Kernel, SurfaceMesh>;
using ShortestPath = CGAL::Surface_mesh_shortest_path<Traits>;
using Face = SurfaceMesh::Face_index;

SurfaceMesh::Vertex_index vertex_of(VertexId v) {
  return SurfaceMesh::Vertex_index(static_cast<SurfaceMesh::size_type>(v.value()));
}

SurfaceMesh build_surface(const PathSubmesh& submesh) {
  SurfaceMesh surface;
  for (const Vec3& p : submesh.positions) surface.add_vertex({p.x(), p.y(), p.z()});
  for (const auto& [a, b, c] : submesh.faces) {
    const Face f = surface.add_face(vertex_of(a), vertex_of(b), vertex_of(c));
    if (f == SurfaceMesh::null_face()) throw Error(ErrorCode::no_valid_result, "CGAL rejects the surface");
    // In CGAL, the first barycentric coordinate belongs to the source of the face's halfedge.
    surface.set_halfedge(f, surface.halfedge(vertex_of(a), vertex_of(b)));
  }
  return surface;
}

/// CGAL's distance, with infinity in place of a negative number, which means "no path", and of NaN, which degenerate
/// faces can give.
double checked(double distance) { return distance >= 0 ? distance : kInfinity; }

/// The minimum of CGAL's distance in the target's face and the lengths of paths through the face's corners. The latter
/// matter if a path passes very close to a corner, because rounding can make it miss the windows on both sides.
double solve_target(ShortestPath& paths, const PathSubmesh& submesh, const PathSubmesh::Target& target) {
  const std::array<VertexId, 3>& corners = submesh.faces[target.face.index()];
  Vec3 at = Vec3::Zero();
  for (std::size_t i = 0; i < 3; ++i) at += target.bary[i] * submesh.positions[corners[i].index()];
  const Face f(static_cast<SurfaceMesh::size_type>(target.face.value()));
  double best = checked(paths.shortest_distance_to_source_points(f, target.bary).first);
  for (const VertexId corner : corners) {
    const double to_corner = checked(paths.shortest_distance_to_source_points(vertex_of(corner)).first);
    best = std::min(best, to_corner + (submesh.positions[corner.index()] - at).norm());
  }
  return best;
}

/// Writes the exact distances of the targets to `submesh.distances`.
/// Throws Error{no_valid_result} if CGAL rejects the surface or finds no path to a target.
void solve_targets(PathSubmesh& submesh, const DistanceQuery& query) {
  const SurfaceMesh surface = build_surface(submesh);
  ShortestPath paths(surface);
  paths.add_source_point(vertex_of(submesh.source));
  paths.build_sequence_tree();
  for (const PathSubmesh::Target& target : submesh.targets) {
    const double distance = submesh.distances[target.point] = solve_target(paths, submesh, target);
    if (!std::isinf(distance)) continue;
    throw Error(ErrorCode::no_valid_result, fmt::format("CGAL's shortest paths do not reach a point of face {}",
                                                        query.points[target.point].face.value()));
  }
}

std::vector<double> solve_query(const Mesh& mesh, const DistanceQuery& query, std::size_t index) {
  PathSubmesh submesh = extract_path_submesh(mesh, query);
  const auto refuse = [index](const std::string& reason) {
    throw Error(ErrorCode::no_valid_result,
                fmt::format("no exact distances from generator {}: {}; the usual cause are faces without area: remove "
                            "them, or run without verification",
                            index, reason),
                std::int64_t(index));
  };
  try {
    if (!submesh.targets.empty()) solve_targets(submesh, query);
  } catch (const CGAL::Failure_exception& failure) {
    refuse("CGAL's shortest paths fail on this surface (" + failure.expression() + ")");
  } catch (const Error& error) {
    refuse(error.what());
  }
  return std::move(submesh.distances);
}

void ignore(const char*, const char*, const char*, int, const char*) {}

}  // namespace

QuietCgal::QuietCgal() : on_error_(CGAL::set_error_handler(ignore)), on_warning_(CGAL::set_warning_handler(ignore)) {}

QuietCgal::~QuietCgal() {
  CGAL::set_error_handler(on_error_);
  CGAL::set_warning_handler(on_warning_);
}

std::vector<std::vector<double>> compute_exact_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                                         const VerifyOptions& options) {
  if (options.threads < 0) throw Error(ErrorCode::invalid_option, "the number of threads must not be negative");
  // CGAL's predicates need a processor that rounds upwards on demand, which valgrind's simulated processor does not.
  if ((CGAL::Interval_nt<>(1) / 3).is_point()) {
    throw Error(ErrorCode::no_valid_result, "no exact distances: this processor only rounds to nearest");
  }
  constexpr std::string_view kStep = "exact distances";
  report_progress(options.progress, kStep, 0);
  const QuietCgal quiet;
  std::vector<std::vector<double>> distances(queries.size());
  ParallelChunks(options.threads, options.progress).run(queries.size(), {kStep}, [&](std::size_t i) {
    distances[i] = solve_query(mesh, queries[i], i);
  });
  return distances;
}

ErrorMeasure verify_diagram(const Mesh& mesh, const Diagram& diagram, const VerifyOptions& options) {
  const ExactDistances exact = [&](const std::vector<DistanceQuery>& queries) {
    return compute_exact_distances(mesh, queries, options);
  };
  return compute_error_measure(mesh, diagram, exact, {options.panels});
}

}  // namespace gvd
