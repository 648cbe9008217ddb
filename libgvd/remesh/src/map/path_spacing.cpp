#include "map/path_spacing.hpp"

#include <cstddef>

namespace gvd {

std::vector<double> lengths_along(const Mesh& mesh, const std::vector<VertexId>& path) {
  std::vector<double> lengths{0};
  for (std::size_t i = 1; i < path.size(); ++i) {
    lengths.push_back(lengths.back() + (mesh.position(path[i]) - mesh.position(path[i - 1])).norm());
  }
  return lengths;
}

void scale_and_even(std::vector<double>& values, double last, double even_share) {
  const double given = values.back(), steps = static_cast<double>(values.size() - 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = last * ((1 - even_share) * values[i] / given + even_share * static_cast<double>(i) / steps);
  }
  values.back() = last;
}

}  // namespace gvd
