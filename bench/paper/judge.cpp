#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gvd/exact_field.hpp"

namespace gvd::paper {

std::vector<std::vector<double>> compute_field_distances(const Mesh& mesh, const std::vector<DistanceQuery>& queries) {
  std::vector<std::vector<double>> answers;
  for (const DistanceQuery& query : queries) {
    const ExactField field(mesh, {query.generator});
    std::vector<double>& answer = answers.emplace_back();
    for (const SurfacePoint& point : query.points) answer.push_back(field.nearest(point).distance);
  }
  return answers;
}

Judge::Judge(const Mesh& mesh, const std::vector<SurfacePoint>& generators)
    : mesh_(mesh), least_(static_cast<std::size_t>(mesh.vertex_count()), std::numeric_limits<double>::infinity()) {
  for (const SurfacePoint& generator : generators) {
    const ExactField field(mesh, {generator});
    std::vector<double>& row = distances_.emplace_back();
    for (std::int32_t v = 0; v < mesh.vertex_count(); ++v) row.push_back(field.distance(VertexId(v)));
    for (std::size_t v = 0; v < row.size(); ++v) least_[v] = std::min(least_[v], row[v]);
  }
}

bool Judge::is_nearest(VertexId v, GeneratorId label) const {
  return label.valid() && distances_[label.index()][v.index()] <= least_[v.index()] * (1 + kEquallyNear);
}

Judgement Judge::judge(const Diagram& diagram) const {
  const auto exact = [&](const std::vector<DistanceQuery>& queries) { return compute_field_distances(mesh_, queries); };
  Judgement result;
  result.error = compute_error_measure(mesh_, diagram, exact);
  for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
    const VertexId v(i);
    if (!std::isfinite(least_[v.index()])) continue;
    ++result.labelled;
    if (!is_nearest(v, diagram.vertex_label[v])) ++result.wrong_labels;
  }
  return result;
}

}  // namespace gvd::paper
