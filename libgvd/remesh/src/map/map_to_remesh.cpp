#include <algorithm>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/remesh_map.hpp"
#include "gvd/surface_point.hpp"
#include "map/nearest_map.hpp"
#include "map/one_to_one_map.hpp"

namespace gvd {
namespace {

/// An image has no area unless twice its area exceeds this fraction of its longest edge squared. It is above the
/// rounding of the corners of images that are a millionth of the mesh in size.
constexpr double kFlatImage = 1e-9;

class MapMeasure {
 public:
  MapMeasure(const Mesh& surface, const Mesh& remesh, RemeshMap& map) : surface_(surface), remesh_(remesh), map_(map) {}

  void run() {
    double sum = 0;
    for (std::int32_t i = 0; i < surface_.vertex_count(); ++i) {
      const double move = (image(VertexId(i)) - surface_.position(VertexId(i))).norm();
      map_.largest_move = std::max(map_.largest_move, move);
      sum += move;
    }
    map_.mean_move = sum / surface_.vertex_count();
    for (std::int32_t f = 0; f < surface_.face_count(); ++f) count(FaceId(f));
  }

 private:
  Vec3 image(VertexId v) const { return position(remesh_, map_.points[v]); }

  /// Compares the image of a face with the normals of the remesh at its corners.
  void count(FaceId f) {
    const auto& [a, b, c] = surface_.vertices(f);
    const Vec3 along = image(b) - image(a), across = image(c) - image(a);
    const Vec3 area = along.cross(across);
    const double square = std::max({along.squaredNorm(), across.squaredNorm(), (across - along).squaredNorm()});
    Vec3 normal = Vec3::Zero();
    for (const VertexId v : {a, b, c}) normal += face_normal(remesh_, map_.points[v].face);
    if (!(area.norm() > kFlatImage * square)) {
      ++map_.collapsed_faces;
    } else {
      ++(area.dot(normal) > 0 ? map_.kept_faces : map_.reversed_faces);
    }
  }

  const Mesh& surface_;
  const Mesh& remesh_;
  RemeshMap& map_;
};

}  // namespace

RemeshMap map_to_remesh(const Mesh& surface, const RemeshResult& result, int threads) {
  if (result.diagram.vertex_label.size() != static_cast<std::size_t>(surface.vertex_count()) ||
      result.generators.size() != static_cast<std::size_t>(result.mesh.vertex_count())) {
    throw Error(ErrorCode::precondition, "the remesh is not one of this surface");
  }
  RemeshMap map;
  try {
    MapPoints points = one_to_one_points(surface, result, threads);
    map.points = std::move(points.images);
    map.origins = std::move(points.origins);
    map.one_to_one = true;
  } catch (const Error& error) {
    if (error.code() != ErrorCode::no_valid_result) throw;
    map.obstacle = error.what();
    map.points = nearest_points(surface, result, threads);
    map.origins = IdVector<VertexId, SurfacePoint>(result.generators);
  }
  MapMeasure(surface, result.mesh, map).run();
  return map;
}

}  // namespace gvd
