// Properties and texture coordinates of the input on its remesh.
//
// Each vertex of the remesh has an origin on the surface. Numbers are interpolated there, labels taken from the nearest
// corner. Texture coordinates jump at seams, so a face takes the coordinates of all its corners from one chart, the one
// that contains its branch point, and no triangle crosses a seam. A vertex at a vertex of the input takes that value
// bit by bit.

#include "gvd/carry_properties.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <string_view>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/closest_point.hpp"
#include "mesh/submesh.hpp"

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
  std::int32_t vertex = 0;
  double weight = 0;
};

/// The shares of the corners of a point's face that have a weight and are in the file; they sum to 1. If only the
/// midpoint of a split edge has a weight, the others share it.
std::vector<Share> find_shares(const CheckedMesh& input, const SurfacePoint& point) {
  std::vector<Share> known, used;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::int32_t vertex = input.input_vertex[input.mesh.vertices(point.face)[i]];
    if (vertex < 0) continue;
    known.push_back({vertex, 1});
    if (!(point.bary[i] > 0)) continue;
    used.push_back({vertex, point.bary[i]});
    sum += point.bary[i];
  }
  std::vector<Share>& shares = used.empty() ? known : used;
  if (used.empty()) sum = double(known.size());
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
std::int32_t largest_share(const std::vector<Share>& shares) {
  const auto largest = std::ranges::max_element(shares, {}, &Share::weight);
  return largest == shares.end() ? 0 : largest->vertex;
}

MeshProperty without_values(const MeshProperty& property) {
  MeshProperty empty{property.name, property.type, property.of_vertices, {}, property.count_type, {}};
  if (empty.count_type) empty.first_value.push_back(0);
  return empty;
}

/// Appends the value of an element, or its list.
void append(const MeshProperty& property, std::size_t element, MeshProperty& carried) {
  if (!property.count_type) return carried.values.push_back(property.values[element]);
  const auto at = [&](std::size_t i) { return property.values.begin() + property.first_value[i]; };
  carried.values.insert(carried.values.end(), at(element), at(element + 1));
  carried.first_value.push_back(carried.values.size());
}

MeshProperty carry_to_vertices(const std::vector<std::vector<Share>>& shares, const MeshProperty& property) {
  MeshProperty carried = without_values(property);
  const bool is_smooth = !property.count_type && (!is_integer(property.type) || is_color(property));
  for (const std::vector<Share>& at : shares) {
    is_smooth ? carried.values.push_back(weighted_mean(at, property.values))
              : append(property, largest_share(at), carried);
  }
  return carried;
}

MeshProperty carry_to_faces(const CheckedMesh& input, const RemeshResult& result, const MeshProperty& property) {
  MeshProperty carried = without_values(property);
  for (const SurfacePoint& point : result.face_points) {
    append(property, input.input_polygon[point.face], carried);
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

/// The faces of a chart as a mesh of their own, in which nearest points are searched for.
struct SearchedChart {
  Submesh part;
  ClosestPointTree tree{part.mesh};
};

class TextureCarrier {
 public:
  explicit TextureCarrier(const CheckedMesh& input) : mesh_(input.mesh), corners_(input.appearance.texture) {
    find_charts();
  }

  std::vector<Uv> run(const RemeshResult& result, const RemeshMap& map) {
    std::vector<Uv> carried;
    for (const FaceId f : result.mesh.faces()) {
      const FaceId at = result.face_points[f.index()].face;
      for (const VertexId v : result.mesh.vertices(f)) {
        carried.push_back(has_texture(at) ? in_chart(chart_[at], map.origins[v]) : kNoTexture);
      }
    }
    return carried;
  }

 private:
  const Uv& at(HalfedgeId h) const { return corners_[h.index()]; }
  const Uv& corner(FaceId f, int i) const { return at(Mesh::halfedge(f, i)); }
  bool has_texture(FaceId f) const {
    return is_finite(corner(f, 0)) && is_finite(corner(f, 1)) && is_finite(corner(f, 2));
  }

  void find_charts() {
    UnionFind sets(mesh_.face_count());
    for (const HalfedgeId h : mesh_.halfedges()) {
      const HalfedgeId twin = mesh_.twin(h);
      if (!twin.valid() || !has_texture(Mesh::face(h)) || !has_texture(Mesh::face(twin))) continue;
      if (at(h) == at(Mesh::next(twin)) && at(Mesh::next(h)) == at(twin)) {
        sets.unite(Mesh::face(h).value(), Mesh::face(twin).value());
      }
    }
    for (const FaceId f : mesh_.faces()) {
      chart_.push_back(has_texture(f) ? FaceId(sets.find(f.value())) : FaceId());
      if (chart_[f].valid()) faces_[chart_[f]].push_back(f);
    }
  }

  Uv in_chart(FaceId chart, const SurfacePoint& point) {
    for (const FaceId f : faces_around(mesh_, point)) {
      if (chart_[f] == chart) return interpolate(f, weights_in(f, point));
    }
    std::unique_ptr<SearchedChart>& searched = searched_[chart];
    if (!searched) searched.reset(new SearchedChart{make_submesh(mesh_, faces_[chart])});
    const SurfacePoint nearest = searched->part.to_whole(searched->tree.query(position(mesh_, point)).point);
    return interpolate(nearest.face, nearest.bary);
  }

  /// The barycentric coordinates in f of a point of f that is given in another face.
  std::array<double, 3> weights_in(FaceId f, const SurfacePoint& point) const {
    if (f == point.face) return point.bary;
    std::array<double, 3> weights{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh_.vertices(f)[i] == mesh_.vertices(point.face)[k]) weights[i] = point.bary[k];
      }
    }
    return weights;
  }

  Uv interpolate(FaceId f, const std::array<double, 3>& weights) const {
    Uv sum{};
    for (int i = 0; i < 3; ++i) {
      if (weights[i] == 1) return corner(f, i);
      for (std::size_t k = 0; k < 2; ++k) sum[k] += weights[i] * corner(f, i)[k];
    }
    return sum;
  }

  const Mesh& mesh_;
  const std::vector<Uv>& corners_;  // where each halfedge begins
  IdVector<FaceId, FaceId> chart_;  // the smallest face of the chart; invalid without texture coordinates
  std::map<FaceId, std::vector<FaceId>> faces_;
  std::map<FaceId, std::unique_ptr<SearchedChart>> searched_;  // charts in which a nearest point was searched for
};

}  // namespace

std::vector<MeshProperty> carry_properties(const CheckedMesh& input, const std::vector<MeshProperty>& properties,
                                           const RemeshResult& result, const RemeshMap& map) {
  std::vector<std::vector<Share>> shares;
  for (const SurfacePoint& point : map.origins) shares.push_back(find_shares(input, point));
  const std::size_t polygons =
      input.input_polygon.empty() ? 0 : 1 + *std::max_element(input.input_polygon.begin(), input.input_polygon.end());
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

Appearance carry_appearance(const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map) {
  Appearance carried = input.appearance;
  if (!carried.texture.empty()) carried.texture = TextureCarrier(input).run(result, map);
  if (carried.material.empty()) return carried;
  carried.material.clear();
  for (const SurfacePoint& point : result.face_points) {
    carried.material.push_back(input.appearance.material[point.face.index()]);
  }
  return carried;
}

}  // namespace gvd
