#include "gvd/verify.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "base/parallel_chunks.hpp"
#include "gvd/error.hpp"
#include "path_submesh.hpp"
#include "shortest_paths.hpp"

namespace gvd {
namespace {

std::vector<double> solve_query(const Mesh& mesh, const DistanceQuery& query, std::size_t index) {
  try {
    PathSubmesh submesh = extract_path_submesh(mesh, query);
    if (submesh.targets.empty()) return std::move(submesh.distances);
    const std::vector<double> solved = solve_shortest_paths(submesh);
    for (std::size_t i = 0; i < solved.size(); ++i) {
      const std::size_t point = submesh.targets[i].point;
      if (std::isinf(solved[i])) {
        throw Error(ErrorCode::no_valid_result, fmt::format("CGAL's shortest paths do not reach a point of face {}",
                                                            query.points[point].face.value()));
      }
      submesh.distances[point] = solved[i];
    }
    return std::move(submesh.distances);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::no_valid_result) throw;
    throw Error(error.code(),
                fmt::format("no exact distances from generator {}: {}; the usual cause are faces without area: remove "
                            "them, or run without verification",
                            index, error.what()),
                static_cast<std::int64_t>(index));
  }
}

}  // namespace

std::vector<std::vector<double>> compute_exact_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries,
                                                         const VerifyOptions& options) {
  if (options.threads < 0) throw Error(ErrorCode::invalid_option, "the number of threads must not be negative");
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
