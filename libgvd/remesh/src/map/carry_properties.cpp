#include "gvd/carry_properties.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

namespace gvd {
namespace {

bool is_color(const MeshProperty& property) {
  constexpr std::string_view kDiffuse = "diffuse_";
  constexpr std::array<std::string_view, 4> kColors{"red", "green", "blue", "alpha"};
  std::string_view name = property.name;
  if (name.starts_with(kDiffuse)) name.remove_prefix(kDiffuse.size());
  return (property.type == NumberType::uint8 || property.type == NumberType::uint16) &&
         std::find(kColors.begin(), kColors.end(), name) != kColors.end();
}

/// A vertex of the input file, and its weight.
struct Share {
  std::size_t vertex = 0;
  double weight = 0;
};

/// Of the corners of a point's face that have a weight and are in the file; the weights sum to 1. If only the midpoint
/// of a split edge has a weight, the others share it.
std::vector<Share> find_shares(const CheckedMesh& input, const SurfacePoint& point) {
  std::vector<Share> known, used;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t vertex = input.input_vertex[input.mesh.vertices(point.face)[i]];
    if (vertex < 0) continue;
    known.push_back({static_cast<std::size_t>(vertex), 1});
    if (!(point.bary[i] > 0)) continue;
    used.push_back({static_cast<std::size_t>(vertex), point.bary[i]});
    sum += point.bary[i];
  }
  std::vector<Share>& shares = used.empty() ? known : used;
  if (used.empty()) sum = static_cast<double>(known.size());
  for (Share& share : shares) share.weight /= sum;
  return shares;
}

/// Sums in order of the corners; a single corner gives its value, bit by bit.
double weighted_mean(const std::vector<Share>& shares, const std::vector<double>& values) {
  if (shares.size() == 1) return values[shares.front().vertex];
  double sum = 0;
  for (const Share& share : shares) sum += share.weight * values[share.vertex];
  return sum;
}

/// The vertex with the largest share.
std::size_t largest_share(const std::vector<Share>& shares) {
  const auto largest = std::max_element(shares.begin(), shares.end(),
                                        [](const Share& a, const Share& b) { return a.weight < b.weight; });
  return largest == shares.end() ? 0 : largest->vertex;
}

/// The property without values.
MeshProperty without_values(const MeshProperty& property) {
  MeshProperty empty{property.name, property.type, property.of_vertices, {}, property.count_type, {}};
  if (empty.count_type) empty.first_value.push_back(0);
  return empty;
}

void append_list(const MeshProperty& property, std::size_t element, MeshProperty& carried) {
  const auto at = [&](std::size_t i) {
    return property.values.begin() + static_cast<std::ptrdiff_t>(property.first_value[i]);
  };
  carried.values.insert(carried.values.end(), at(element), at(element + 1));
  carried.first_value.push_back(carried.values.size());
}

MeshProperty carry_lists(const std::vector<std::vector<Share>>& shares, const MeshProperty& property) {
  MeshProperty carried = without_values(property);
  for (const std::vector<Share>& at : shares) append_list(property, largest_share(at), carried);
  return carried;
}

MeshProperty carry_to_vertices(const std::vector<std::vector<Share>>& shares, const MeshProperty& property) {
  if (property.count_type) return carry_lists(shares, property);
  MeshProperty carried = without_values(property);
  const bool smooth = !is_integer(property.type) || is_color(property);
  for (const std::vector<Share>& at : shares) {
    carried.values.push_back(smooth ? weighted_mean(at, property.values) : property.values[largest_share(at)]);
  }
  return carried;
}

MeshProperty carry_to_faces(const CheckedMesh& input, const RemeshResult& result, const MeshProperty& property) {
  MeshProperty carried = without_values(property);
  for (const SurfacePoint& point : result.face_points) {
    const auto polygon = static_cast<std::size_t>(input.input_polygon[point.face]);
    property.count_type ? append_list(property, polygon, carried) : carried.values.push_back(property.values[polygon]);
  }
  return carried;
}

void scale_normals(std::vector<MeshProperty>& properties) {
  std::array<MeshProperty*, 3> axes{};
  for (MeshProperty& property : properties) {
    if (!property.of_vertices || is_integer(property.type) || property.count_type) continue;
    constexpr std::array<std::string_view, 3> kNames{"nx", "ny", "nz"};
    const auto axis = std::find(kNames.begin(), kNames.end(), property.name) - kNames.begin();
    if (axis < 3) axes[axis] = &property;
  }
  if (std::find(axes.begin(), axes.end(), nullptr) != axes.end()) return;
  for (std::size_t i = 0; i < axes[0]->values.size(); ++i) {
    const double length = std::hypot(axes[0]->values[i], axes[1]->values[i], axes[2]->values[i]);
    if (!(length > 0)) continue;
    for (MeshProperty* axis : axes) axis->values[i] /= length;
  }
}

}  // namespace

std::vector<MeshProperty> carry_properties(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                           const RemeshResult& result, const RemeshMap& map) {
  std::vector<std::vector<Share>> shares;
  for (const SurfacePoint& point : map.origins) shares.push_back(find_shares(input, point));
  const auto polygons = static_cast<std::size_t>(
      input.input_polygon.empty() ? 0 : 1 + *std::max_element(input.input_polygon.begin(), input.input_polygon.end()));
  std::vector<MeshProperty> carried;
  for (const MeshProperty& property : properties) {
    if (property.of_vertices && property.element_count() == input.mesh_vertex.size()) {
      carried.push_back(carry_to_vertices(shares, property));
    } else if (!property.of_vertices && property.element_count() >= polygons) {
      carried.push_back(carry_to_faces(input, result, property));
    }
  }
  scale_normals(carried);
  return carried;
}

}  // namespace gvd
