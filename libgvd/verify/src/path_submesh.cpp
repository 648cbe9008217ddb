// The part of a mesh that the shortest paths of a query can visit.
//
// Idea: Dijkstra's algorithm on the edges bounds the largest distance R of the query's points. No path of that length
// leaves the ball of radius R round the generator, so CGAL need not see the faces outside of it.
// Invariant: the faces of the submesh are connected across edges, oriented as in the mesh, and each of its vertices has
// one fan of them. Vertices where several fans remain are duplicated.
#include "path_submesh.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// Relative enlargement of the radius. The lengths compared are sums of at most 1e5 rounded terms. Their relative
/// error is below 1e5 units in the last place.
constexpr double kRadiusSlack = 1e-10;

void check_point(const Mesh& mesh, const SurfacePoint& point) {
  if (!point.face.valid() || point.face.value() >= mesh.face_count()) {
    throw Error(ErrorCode::precondition, "a surface point lies in no face of the mesh", point.face.value());
  }
}

/// Upper bounds of the exact distances: Euclidean from the generator to the corners of its faces, then along edges.
/// Stops when the values of all `wanted` vertices are final.
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

/// Builds a PathSubmesh; its member functions are in the order of their calls.
class SubmeshExtractor {
 public:
  SubmeshExtractor(const Mesh& mesh, const DistanceQuery& query)
      : mesh_(mesh), query_(query), views_(find_views(mesh, query.generator)) {
    origin_ = position(mesh, query.generator);
    slot_.assign(mesh.face_count(), -1);
    submesh_.distances.assign(query.points.size(), std::numeric_limits<double>::quiet_NaN());
  }

  PathSubmesh run() {
    sort_points();
    if (!far_.empty()) measure_radius();
    if (far_.empty()) return std::move(submesh_);
    collect_faces();
    number_vertices();
    write_faces();
    write_targets();
    return std::move(submesh_);
  }

 private:
  bool touches(FaceId f) const {
    return std::any_of(views_.begin(), views_.end(), [f](const SurfacePoint& view) { return view.face == f; });
  }

  /// Computes the Euclidean distances of the points in faces that contain the generator; the other points are far.
  void sort_points() {
    for (std::size_t i = 0; i < query_.points.size(); ++i) {
      const SurfacePoint& point = query_.points[i];
      check_point(mesh_, point);
      if (touches(point.face)) {
        submesh_.distances[i] = (position(mesh_, point) - origin_).norm();
      } else {
        far_.push_back(i);
      }
    }
  }

  /// The radius, from upper bounds of the distances. Points without a path get infinity and are no longer far.
  void measure_radius() {
    std::vector<VertexId> wanted;
    for (const std::size_t i : far_) {
      for (const VertexId v : mesh_.vertices(query_.points[i].face)) wanted.push_back(v);
    }
    const auto distance = compute_edge_distances(mesh_, views_, wanted);
    std::erase_if(far_, [&](std::size_t i) {
      const SurfacePoint& point = query_.points[i];
      const Vec3 at = position(mesh_, point);
      double bound = kInfinity;
      for (const VertexId v : mesh_.vertices(point.face)) {
        bound = std::min(bound, distance[v] + (mesh_.position(v) - at).norm());
      }
      if (std::isinf(bound)) submesh_.distances[i] = bound;
      if (!std::isinf(bound)) radius_ = std::max(radius_, bound);
      return std::isinf(bound);
    });
    radius_ *= 1 + kRadiusSlack;
  }

  /// Whether f may intersect the ball, by an enclosing ball of f.
  bool may_intersect_ball(FaceId f) const {
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : mesh_.vertices(f)) centre += mesh_.position(v) / 3;
    double extent = 0;
    for (const VertexId v : mesh_.vertices(f)) extent = std::max(extent, (mesh_.position(v) - centre).norm());
    return (centre - origin_).norm() - extent <= radius_;
  }

  void add_face(FaceId f) {
    if (slot_[f] >= 0) return;
    slot_[f] = int(faces_.size());
    faces_.push_back(f);
  }

  void collect_faces() {
    for (const SurfacePoint& view : views_) add_face(view.face);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh_.twin(Mesh::halfedge(faces_[i], corner));
        if (twin.valid() && may_intersect_ball(Mesh::face(twin))) add_face(Mesh::face(twin));
      }
    }
  }

  std::size_t corner_index(HalfedgeId h) const { return 3 * std::size_t(slot_[Mesh::face(h)]) + Mesh::corner(h); }

  bool is_added(HalfedgeId h) const { return h.valid() && slot_[Mesh::face(h)] >= 0; }

  /// One vertex of the submesh for each fan of its faces.
  void number_vertices() {
    corner_vertex_.assign(3 * faces_.size(), -1);
    for (const FaceId f : faces_) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId start = Mesh::halfedge(f, corner);
        if (corner_vertex_[corner_index(start)] >= 0) continue;
        const int number = add_vertex(mesh_.position(mesh_.from(start)));
        const auto number_from = [&](HalfedgeId h, auto step) {
          for (; is_added(h) && corner_vertex_[corner_index(h)] < 0; h = step(mesh_, h)) {
            corner_vertex_[corner_index(h)] = number;
          }
        };
        number_from(start, next_outgoing);
        number_from(previous_outgoing(mesh_, start), previous_outgoing);
      }
    }
  }

  int add_vertex(const Vec3& at) {
    submesh_.positions.push_back(at);
    return int(submesh_.positions.size()) - 1;
  }

  /// First the faces that contain the generator, each split into triangles at it. The triangle without corner i has the
  /// fraction bary[i] of the area; it is omitted if that is 0. The other faces follow whole.
  void write_faces() {
    submesh_.source = add_vertex(origin_);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::array<int, 3> face{corner_vertex_[3 * i], corner_vertex_[3 * i + 1], corner_vertex_[3 * i + 2]};
      if (i >= views_.size()) {
        local_face_.push_back(int(submesh_.faces.size()));
        submesh_.faces.push_back(face);
        continue;
      }
      local_face_.push_back(-1);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (views_[i].bary[corner] == 0) continue;
        submesh_.faces.push_back(face);
        submesh_.faces.back()[corner] = submesh_.source;
      }
    }
  }

  void write_targets() {
    for (const std::size_t i : far_) {
      const SurfacePoint& point = query_.points[i];
      submesh_.targets.push_back({i, local_face_[slot_[point.face]], point.bary});
    }
  }

  const Mesh& mesh_;
  const DistanceQuery& query_;
  std::vector<SurfacePoint> views_;
  Vec3 origin_;
  double radius_ = 0;
  std::vector<std::size_t> far_;
  IdVector<FaceId, int> slot_;  // index in faces_; -1 for a face outside of the submesh
  std::vector<FaceId> faces_;
  std::vector<int> corner_vertex_;  // of the submesh, for each corner of faces_
  std::vector<int> local_face_;     // of the submesh, for each of faces_; -1 for a split one
  PathSubmesh submesh_;
};

}  // namespace

PathSubmesh extract_path_submesh(const Mesh& mesh, const DistanceQuery& query) {
  check_point(mesh, query.generator);
  return SubmeshExtractor(mesh, query).run();
}

}  // namespace gvd
