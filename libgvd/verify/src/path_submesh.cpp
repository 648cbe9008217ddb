// Extracts the part of a mesh that the shortest paths of a query can visit.
//
// Idea: Dijkstra's algorithm on the edges bounds the largest distance R of the query's points. No path of that length
// leaves the ball of radius R around the generator, so CGAL does not need the faces outside the ball.
// Invariant: the faces of the submesh are connected across edges and oriented as in the mesh. Each vertex is in a face,
// and all its faces form a single fan (number_fans).
#include "path_submesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/submesh.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Relative enlargement of the radius. The compared lengths are sums of at most 1e5 rounded terms, so their relative
/// error is below 1e5 units in the last place.
constexpr double kRadiusSlack = 1e-10;

void check_point(const Mesh& mesh, const SurfacePoint& point) {
  if (!point.face.valid() || point.face.value() >= mesh.face_count()) {
    throw Error(ErrorCode::precondition, "a surface point lies in no face of the mesh", point.face.value());
  }
}

/// Upper bounds of the exact distances: Euclidean from the generator to the corners of its faces, then along edges.
/// Stops as soon as the values of all `wanted` vertices are final.
IdVector<VertexId, double> compute_edge_distances(const Mesh& mesh, const std::vector<SurfacePoint>& views,
                                                  const std::vector<VertexId>& wanted) {
  IdVector<VertexId, double> distance(mesh.vertex_count(), kInfinity);
  IdVector<VertexId, char> waiting(distance.size(), 0);
  std::size_t pending = 0;
  for (const VertexId v : wanted) pending += waiting[v]++ == 0 ? 1 : 0;
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto relax = [&](VertexId v, double d) {
    if (d < distance[v]) queue.push({distance[v] = d, v});
  };
  const Vec3 origin = position(mesh, views.front());
  for (const SurfacePoint& view : views) {
    for (const VertexId v : mesh.vertices(view.face)) relax(v, (mesh.position(v) - origin).norm());
  }
  while (!queue.empty() && pending > 0) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    if (waiting[v] > 0) --pending;
    waiting[v] = 0;
    for_each_neighbour(mesh, v, [&, from = v, so_far = d](VertexId w, HalfedgeId) {
      relax(w, so_far + (mesh.position(w) - mesh.position(from)).norm());
    });
  }
  return distance;
}

/// Writes the Euclidean distances of the points in faces that contain the generator. Returns the other points.
std::vector<std::size_t> measure_near_points(const Mesh& mesh, const DistanceQuery& query,
                                             const std::vector<SurfacePoint>& views, std::vector<double>& distances) {
  const Vec3 origin = position(mesh, query.generator);
  std::vector<std::size_t> far;
  for (std::size_t i = 0; i < query.points.size(); ++i) {
    const SurfacePoint& point = query.points[i];
    check_point(mesh, point);
    if (std::ranges::find(views, point.face, &SurfacePoint::face) != views.end()) {
      distances[i] = (position(mesh, point) - origin).norm();
    } else {
      far.push_back(i);
    }
  }
  return far;
}

/// The radius of a ball that the shortest paths to the far points do not leave, from upper bounds of their lengths.
/// Points without a path get infinity, and are removed from `far`.
double bound_paths(const Mesh& mesh, const DistanceQuery& query, const std::vector<SurfacePoint>& views,
                   std::vector<std::size_t>& far, std::vector<double>& distances) {
  std::vector<VertexId> wanted;
  for (const std::size_t i : far) {
    for (const VertexId v : mesh.vertices(query.points[i].face)) wanted.push_back(v);
  }
  const auto distance = compute_edge_distances(mesh, views, wanted);
  double radius = 0;
  std::erase_if(far, [&](std::size_t i) {
    const SurfacePoint& point = query.points[i];
    const Vec3 at = position(mesh, point);
    double bound = kInfinity;
    for (const VertexId v : mesh.vertices(point.face)) {
      bound = std::min(bound, distance[v] + (mesh.position(v) - at).norm());
    }
    if (std::isinf(bound)) distances[i] = bound;
    if (!std::isinf(bound)) radius = std::max(radius, bound);
    return std::isinf(bound);
  });
  return radius * (1 + kRadiusSlack);
}

/// Whether f may intersect a ball, by an enclosing ball of f.
bool may_intersect_ball(const Mesh& mesh, FaceId f, const Vec3& origin, double radius) {
  Vec3 centre = Vec3::Zero();
  for (const VertexId v : mesh.vertices(f)) centre += mesh.position(v) / 3;
  double extent = 0;
  for (const VertexId v : mesh.vertices(f)) extent = std::max(extent, (mesh.position(v) - centre).norm());
  return (centre - origin).norm() - extent <= radius;
}

/// Collects the faces that may intersect the ball and are connected to the generator's faces through such faces;
/// ascending.
std::vector<FaceId> collect_faces(const Mesh& mesh, const std::vector<SurfacePoint>& views, const Vec3& origin,
                                  double radius) {
  IdVector<FaceId, char> is_added(mesh.face_count(), 0);
  std::vector<FaceId> faces;
  const auto add = [&](FaceId f) {
    if (!std::exchange(is_added[f], 1)) faces.push_back(f);
  };
  for (const SurfacePoint& view : views) add(view.face);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (const HalfedgeId h : Mesh::halfedges(faces[i])) {
      const HalfedgeId twin = mesh.twin(h);
      if (twin.valid() && may_intersect_ball(mesh, Mesh::face(twin), origin, radius)) add(Mesh::face(twin));
    }
  }
  std::ranges::sort(faces);
  return faces;
}

/// Splits the faces that contain the generator into triangles at the generator; all other faces stay whole. The
/// triangle without corner i has the fraction bary[i] of the area, and is omitted if that is 0. Returns the number of
/// each face in the submesh; invalid for a face that is split.
std::vector<FaceId> split_at_generator(const Mesh& mesh, const std::vector<SurfacePoint>& views, const Vec3& origin,
                                       const std::vector<FaceId>& faces, PathSubmesh& part) {
  FanFaces fans = number_fans(mesh, faces);
  const VertexId source = fans.whole_vertex.push_back({});  // stands for no vertex of the mesh
  std::vector<FaceId> number(faces.size());
  for (std::size_t i = 0; i < faces.size(); ++i) {
    const auto view = std::ranges::find(views, faces[i], &SurfacePoint::face);
    if (view == views.end()) {
      number[i] = FaceId(part.faces.size());
      part.faces.push_back(fans.faces[i]);
      continue;
    }
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (view->bary[corner] == 0) continue;
      part.faces.push_back(fans.faces[i]);
      part.faces.back()[corner] = source;
    }
  }
  const KeptVertices kept = drop_unused_vertices(fans.whole_vertex.size(), part.faces);
  part.source = kept.after[source];
  for (const VertexId v : kept.before) {
    part.positions.push_back(v == source ? origin : mesh.position(fans.whole_vertex[v]));
  }
  return number;
}

}  // namespace

PathSubmesh extract_path_submesh(const Mesh& mesh, const DistanceQuery& query) {
  check_point(mesh, query.generator);
  const std::vector<SurfacePoint> views = find_views(mesh, query.generator);
  PathSubmesh part;
  part.distances.assign(query.points.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<std::size_t> far = measure_near_points(mesh, query, views, part.distances);
  const double radius = far.empty() ? 0 : bound_paths(mesh, query, views, far, part.distances);
  if (far.empty()) return part;
  const Vec3 origin = position(mesh, query.generator);
  const std::vector<FaceId> faces = collect_faces(mesh, views, origin, radius);
  const std::vector<FaceId> number = split_at_generator(mesh, views, origin, faces, part);
  for (const std::size_t i : far) {
    const SurfacePoint& point = query.points[i];
    const auto found = std::ranges::lower_bound(faces, point.face);
    part.targets.push_back({i, number[std::size_t(found - faces.begin())], point.bary});
  }
  return part;
}

}  // namespace gvd
