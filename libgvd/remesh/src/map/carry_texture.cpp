#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <optional>

#include "base/union_find.hpp"
#include "gvd/carry_properties.hpp"
#include "gvd/closest_point.hpp"

namespace gvd {
namespace {

using Uv = std::array<double, 2>;
constexpr Uv kNone{std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};

bool is_finite(const Uv& uv) { return std::isfinite(uv[0]) && std::isfinite(uv[1]); }

/// The faces of a chart, apart from each other: neighbours need not have the chart's coordinates in common elsewhere.
class ChartSurface {
 public:
  ChartSurface(const Mesh& mesh, std::vector<FaceId> faces) : faces_(std::move(faces)), surface_(take(mesh, faces_)) {}

  SurfacePoint nearest(const Vec3& point) const {
    const SurfacePoint found = tree_.query(point).point;
    return {faces_[found.face.index()], found.bary};
  }

 private:
  static Mesh take(const Mesh& mesh, const std::vector<FaceId>& faces) {
    std::vector<Vec3> positions;
    std::vector<std::array<VertexId, 3>> triangles;
    for (const FaceId f : faces) {
      const auto first = static_cast<std::int64_t>(positions.size());
      for (const VertexId v : mesh.vertices(f)) positions.push_back(mesh.position(v));
      triangles.push_back({VertexId(first), VertexId(first + 1), VertexId(first + 2)});
    }
    return Mesh(std::move(positions), std::move(triangles));
  }

  std::vector<FaceId> faces_;
  Mesh surface_;
  ClosestPointTree tree_{surface_};
};

class TextureCarrier {
 public:
  TextureCarrier(const CheckedMesh& input, const CornerTexture& texture)
      : mesh_(input.mesh), corners_(static_cast<std::size_t>(3 * input.mesh.face_count()), kNone) {
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) find_corners(input, texture, FaceId(f));
    find_charts();
  }

  std::vector<Uv> run(const RemeshResult& result, const RemeshMap& map) {
    std::vector<Uv> carried;
    for (std::int32_t f = 0; f < result.mesh.face_count(); ++f) {
      const FaceId at = result.face_points[f].face;
      for (const VertexId v : result.mesh.vertices(FaceId(f))) {
        carried.push_back(has_texture(at) ? in_chart(chart_[at], map.origins[v]) : kNone);
      }
    }
    return carried;
  }

 private:
  const Uv& corner(FaceId f, std::size_t i) const { return corners_[3 * f.index() + i]; }
  bool has_texture(FaceId f) const {
    return is_finite(corner(f, 0)) && is_finite(corner(f, 1)) && is_finite(corner(f, 2));
  }

  /// The polygon's corner at each of the face's vertices; of a vertex that the repair welded, the first one.
  void find_corners(const CheckedMesh& input, const CornerTexture& texture, FaceId f) {
    const auto polygon = static_cast<std::size_t>(input.input_polygon[f]);
    if (polygon + 1 >= texture.first_corner.size()) return;
    for (std::size_t i = 0; i < 3; ++i) {
      const VertexId v = mesh_.vertices(f)[i];
      for (std::size_t c = texture.first_corner[polygon + 1]; c-- > texture.first_corner[polygon];) {
        const std::int32_t vertex = texture.corners[c];
        if (vertex != input.input_vertex[v] && input.mesh_vertex[vertex] != v) continue;
        corners_[3 * f.index() + i] = texture.coordinates[c];
      }
    }
  }

  void find_charts() {
    UnionFind sets(static_cast<std::size_t>(mesh_.face_count()));
    for (std::int32_t i = 0; i < mesh_.halfedge_count(); ++i) {
      const HalfedgeId h(i), twin = mesh_.twin(h);
      if (!twin.valid() || !has_texture(Mesh::face(h)) || !has_texture(Mesh::face(twin))) continue;
      const auto of = [&](HalfedgeId g) { return corners_[g.index()]; };
      if (of(h) == of(Mesh::next(twin)) && of(Mesh::next(h)) == of(twin)) {
        sets.unite(Mesh::face(h).value(), Mesh::face(twin).value());
      }
    }
    for (std::int32_t f = 0; f < mesh_.face_count(); ++f) {
      chart_.push_back(has_texture(FaceId(f)) ? FaceId(sets.find(f)) : FaceId());
      if (chart_[FaceId(f)].valid()) faces_[chart_[FaceId(f)]].push_back(FaceId(f));
    }
  }

  Uv in_chart(FaceId chart, const SurfacePoint& point) {
    for (const FaceId f : faces_around(mesh_, point)) {
      if (chart_[f] == chart) return interpolate(f, weights_in(f, point));
    }
    std::unique_ptr<ChartSurface>& surface = surfaces_[chart];
    if (!surface) surface = std::make_unique<ChartSurface>(mesh_, faces_[chart]);
    const SurfacePoint nearest = surface->nearest(position(mesh_, point));
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
    for (std::size_t i = 0; i < 3; ++i) {
      if (weights[i] == 1) return corner(f, i);
      for (std::size_t k = 0; k < 2; ++k) sum[k] += weights[i] * corner(f, i)[k];
    }
    return sum;
  }

  const Mesh& mesh_;
  std::vector<Uv> corners_;         // three for each face
  IdVector<FaceId, FaceId> chart_;  // the smallest face of the chart; invalid without texture coordinates
  std::map<FaceId, std::vector<FaceId>> faces_;
  std::map<FaceId, std::unique_ptr<ChartSurface>> surfaces_;  // where a point outside of the chart was looked for
};

}  // namespace

std::vector<std::array<double, 2>> carry_texture(const CheckedMesh& input, const CornerTexture& texture,
                                                 const RemeshResult& result, const RemeshMap& map) {
  return TextureCarrier(input, texture).run(result, map);
}

}  // namespace gvd
