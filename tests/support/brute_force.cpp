#include "support/brute_force.hpp"

#include <cmath>
#include <limits>

namespace gvd::test {

Nearest compute_nearest(const DistanceFields& fields) {
  const std::size_t count = fields.empty() ? 0 : fields.front().size();
  Nearest nearest;
  nearest.label.assign(count, GeneratorId());
  nearest.distance.assign(count, std::numeric_limits<double>::infinity());
  for (std::size_t g = 0; g < fields.size(); ++g) {
    for (std::size_t i = 0; i < count; ++i) {
      const VertexId v(i);
      if (!(fields[g][i] < nearest.distance[v])) continue;
      nearest.distance[v] = fields[g][i];
      nearest.label[v] = GeneratorId(g);
    }
  }
  return nearest;
}

bool is_right_label(const DistanceFields& fields, VertexId v, GeneratorId label) {
  double least = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& field : fields) least = std::fmin(least, field[v.index()]);
  if (std::isinf(least) || !label.valid()) return std::isinf(least) && !label.valid();
  return label.index() < fields.size() && fields[label.index()][v.index()] <= least * (1 + kLabelTolerance);
}

std::vector<VertexId> find_wrong_labels(const DistanceFields& fields, const IdVector<VertexId, GeneratorId>& labels) {
  std::vector<VertexId> wrong;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const VertexId v(i);
    if (!is_right_label(fields, v, labels[v])) wrong.push_back(v);
  }
  return wrong;
}

}  // namespace gvd::test
