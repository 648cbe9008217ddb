// Computes exact distances by CGAL, independently of the library's own solvers. This is the only file that includes
// CGAL.
//
// Idea: one query for each generator, on the part of the mesh that its shortest paths can visit, on several threads.
// CGAL constructs windows in doubles. On needles it can lose one, and then takes a longer way. What it says is no
// longer exact where there is a path on the surface that is shorter: its length, measured along its points, is taken
// instead. The library's solver proposes such paths, and can't make a distance too short by that: what counts is the
// length of a path that is there.
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
#include "gvd/exact_field.hpp"
#include "gvd/surface_point.hpp"
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

/// Paths that are shorter than a distance by less than this fraction of it are as long: the error of the oracle.
constexpr double kOracleError = 1e-9;

/// The length of a path on the surface, from its points alone; infinity where two of them have no face in common.
double measure_path(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const auto view = find_common_view(mesh, points[i - 1], points[i]);
    if (!view) return kInfinity;
    length += (position(mesh, view->second) - position(mesh, view->first)).norm();
  }
  return length;
}

/// The answers to one query.
struct Answer {
  std::vector<double> distances;
  std::int64_t corrected = 0;  ///< those for which a shorter path than CGAL's is there
};

/// Takes the lengths of shorter paths for distances that are too long.
void take_shorter_paths(const PathSubmesh& submesh, Answer& answer) {
  const Mesh part(submesh.positions, submesh.faces);
  const SurfacePoint source = vertex_point(part, submesh.source);
  const ExactField field(part, {source}, {.threads = 1});
  for (const PathSubmesh::Target& target : submesh.targets) {
    double& distance = answer.distances[target.point];
    const SurfacePoint point = make_surface_point(target.face, target.bary);
    const double least = (1 - kOracleError) * distance;
    if (!(field.nearest(point).distance < least)) continue;
    std::vector<SurfacePoint> path = field.path(point).points;
    path.insert(path.begin(), point);
    path.push_back(source);
    const double length = measure_path(part, path);
    if (!(length < least)) continue;
    distance = length;
    ++answer.corrected;
  }
}

/// Writes the exact distances of the targets to `answer`.
/// Throws Error{no_valid_result} if CGAL rejects the surface or no path reaches a target.
void solve_targets(const PathSubmesh& submesh, const DistanceQuery& query, Answer& answer) {
  const SurfaceMesh surface = build_surface(submesh);
  ShortestPath paths(surface);
  paths.add_source_point(vertex_of(submesh.source));
  paths.build_sequence_tree();
  for (const PathSubmesh::Target& target : submesh.targets) {
    answer.distances[target.point] = solve_target(paths, submesh, target);
  }
  take_shorter_paths(submesh, answer);
  for (const PathSubmesh::Target& target : submesh.targets) {
    if (!std::isinf(answer.distances[target.point])) continue;
    throw Error(ErrorCode::no_valid_result, fmt::format("CGAL's shortest paths do not reach a point of face {}",
                                                        query.points[target.point].face.value()));
  }
}

Answer solve_query(const Mesh& mesh, const DistanceQuery& query, std::size_t index) {
  PathSubmesh submesh = extract_path_submesh(mesh, query);
  const auto refuse = [index](const std::string& reason) {
    throw Error(ErrorCode::no_valid_result,
                fmt::format("no exact distances from generator {}: {}; the usual cause are faces without area: remove "
                            "them, or run without verification",
                            index, reason),
                std::int64_t(index));
  };
  Answer answer{std::move(submesh.distances)};
  try {
    if (!submesh.targets.empty()) solve_targets(submesh, query, answer);
  } catch (const CGAL::Failure_exception& failure) {
    refuse("CGAL's shortest paths fail on this surface (" + failure.expression() + ")");
  } catch (const Error& error) {
    refuse(error.what());
  }
  return answer;
}

void ignore(const char*, const char*, const char*, int, const char*) {}

}  // namespace

QuietCgal::QuietCgal() : on_error_(CGAL::set_error_handler(ignore)), on_warning_(CGAL::set_warning_handler(ignore)) {}

QuietCgal::~QuietCgal() {
  CGAL::set_error_handler(on_error_);
  CGAL::set_warning_handler(on_warning_);
}

namespace {

std::vector<Answer> solve_queries(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                  const VerifyOptions& options) {
  if (options.threads < 0) throw Error(ErrorCode::invalid_option, "the number of threads must not be negative");
  // CGAL's predicates need a processor that rounds upwards on demand, which valgrind's simulated processor does not.
  if ((CGAL::Interval_nt<>(1) / 3).is_point()) {
    throw Error(ErrorCode::no_valid_result, "no exact distances: this processor only rounds to nearest");
  }
  constexpr std::string_view kStep = "exact distances";
  report_progress(options.progress, kStep, 0);
  const QuietCgal quiet;
  std::vector<Answer> answers(queries.size());
  ParallelChunks(options.threads, options.progress).run(queries.size(), {kStep}, [&](std::size_t i) {
    answers[i] = solve_query(mesh, queries[i], i);
  });
  return answers;
}

std::vector<std::vector<double>> take_distances(std::vector<Answer> answers) {
  std::vector<std::vector<double>> distances;
  for (Answer& answer : answers) distances.push_back(std::move(answer.distances));
  return distances;
}

}  // namespace

std::vector<std::vector<double>> compute_exact_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                                         const VerifyOptions& options) {
  return take_distances(solve_queries(mesh, queries, options));
}

ErrorMeasure verify_diagram(const Mesh& mesh, const Diagram& diagram, const VerifyOptions& options) {
  std::int64_t corrected = 0, asked = 0;
  const ExactDistances exact = [&](const std::vector<DistanceQuery>& queries) {
    std::vector<Answer> answers = solve_queries(mesh, queries, options);
    for (const Answer& answer : answers) {
      corrected += answer.corrected;
      asked += std::ssize(answer.distances);
    }
    return take_distances(std::move(answers));
  };
  ErrorMeasure measure = compute_error_measure(mesh, diagram, exact, {options.panels});
  measure.distances = asked;
  measure.corrected = corrected;
  return measure;
}

}  // namespace gvd
