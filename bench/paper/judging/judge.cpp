#include "judging/judge.hpp"

#include <cmath>
#include <utility>

#include "judging/turning.hpp"
#include "path_submesh.hpp"

namespace gvd::paper {
namespace {

/// The submesh as a `Mesh`, which allows no vertex without a face; `source` becomes the new number of its source.
Mesh build_submesh(const PathSubmesh& part, VertexId& source) {
  std::vector<VertexId> number(part.positions.size());
  std::vector<Vec3> positions;
  std::vector<std::array<VertexId, 3>> faces;
  for (const std::array<int, 3>& face : part.faces) {
    std::array<VertexId, 3>& numbered = faces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto v = static_cast<std::size_t>(face[i]);
      if (!number[v].valid()) {
        number[v] = VertexId(positions.size());
        positions.push_back(part.positions[v]);
      }
      numbered[i] = number[v];
    }
  }
  source = number[part.source];
  return Mesh(std::move(positions), std::move(faces));
}

std::vector<double> solve(const Mesh& mesh, const DistanceQuery& query) {
  PathSubmesh part = extract_path_submesh(mesh, query);
  if (part.targets.empty()) return std::move(part.distances);
  VertexId source;
  const Mesh submesh = build_submesh(part, source);
  const ExactField field(submesh, {vertex_point(submesh, source)});
  for (const PathSubmesh::Target& target : part.targets) {
    const SurfacePoint point = make_surface_point(FaceId(target.face), target.bary);
    part.distances[target.point] = field.nearest(point).distance;
  }
  return std::move(part.distances);
}

}  // namespace

std::vector<std::vector<double>> compute_field_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries) {
  std::vector<std::vector<double>> answers;
  for (const DistanceQuery& query : queries) answers.push_back(solve(mesh, query));
  return answers;
}

/// Only the vertices with another label than the exact one need a distance of their own.
std::int64_t Judge::count_wrong_labels(const Diagram& diagram) const {
  std::vector<DistanceQuery> queries(diagram.generators.size());
  std::vector<std::vector<double>> allowed(queries.size());
  std::int64_t wrong = 0;
  for (std::size_t g = 0; g < queries.size(); ++g) queries[g].generator = diagram.generators[g];
  for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
    const VertexId v(i);
    const GeneratorId label = diagram.vertex_label[v];
    if (label == nearest_.label(v) || !nearest_.label(v).valid()) continue;
    if (!label.valid()) {
      ++wrong;
      continue;
    }
    queries[label.index()].points.push_back(vertex_point(mesh_, v));
    allowed[label.index()].push_back(nearest_.distance(v) * (1 + kEquallyNear));
  }
  const auto distances = compute_field_distances(mesh_, queries);
  for (std::size_t g = 0; g < queries.size(); ++g) {
    for (std::size_t i = 0; i < allowed[g].size(); ++i) wrong += distances[g][i] <= allowed[g][i] ? 0 : 1;
  }
  return wrong;
}

Judgement Judge::judge(const Diagram& diagram) const {
  const auto exact = [&](const std::vector<DistanceQuery>& queries) { return compute_field_distances(mesh_, queries); };
  Judgement result;
  result.error = compute_error_measure(mesh_, diagram, exact);
  result.turning_angle = sum_turning_angles(mesh_, diagram);
  result.wrong_labels = count_wrong_labels(diagram);
  for (std::int32_t v = 0; v < mesh_.vertex_count(); ++v)
    result.labelled += nearest_.label(VertexId(v)).valid() ? 1 : 0;
  return result;
}

}  // namespace gvd::paper
