#include "reach.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/point_views.hpp"

namespace gvd {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// What the radius is widened by, relative: a path's length and a face's distance are sums of at most 1e5 rounded
/// terms, hence wrong by less than 1e5 units in the last place.
constexpr double kRadiusSlack = 1e-10;

void check_point(const Mesh& mesh, const SurfacePoint& point) {
  if (!point.face.valid() || point.face.value() >= mesh.face_count()) {
    throw Error(ErrorCode::precondition, "a surface point refers to no face of the mesh", point.face.value());
  }
}

/// Calls visit(w) for every vertex w that shares an edge with v (one of them twice where v is inside).
template <class Visit>
void for_each_neighbour(const Mesh& mesh, VertexId v, Visit visit) {
  const HalfedgeId start = mesh.halfedge(v);
  HalfedgeId h = start;
  do {
    visit(mesh.to(h));
    visit(mesh.opposite(h));
    h = mesh.twin(Mesh::previous(h));
  } while (h.valid() && h != start);
}

/// Distances along the edges from the corners of the generator's faces, each one started with its straight line:
/// upper bounds of the exact ones. Stops when every vertex of `wanted` is settled.
IdVector<VertexId, double> compute_edge_distances(const Mesh& mesh, const std::vector<SurfacePoint>& views,
                                                  const std::vector<VertexId>& wanted) {
  IdVector<VertexId, double> distance(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  IdVector<VertexId, char> waiting(distance.size(), 0);
  std::size_t left = 0;
  for (const VertexId v : wanted) left += waiting[v]++ == 0 ? 1 : 0;
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto relax = [&](VertexId v, double d) {
    if (d < distance[v]) queue.push({distance[v] = d, v});
  };
  const Vec3 origin = position(mesh, views.front());
  for (const SurfacePoint& view : views) {
    for (const VertexId v : mesh.vertices(view.face)) relax(v, (mesh.position(v) - origin).norm());
  }
  while (!queue.empty() && left > 0) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > distance[v]) continue;
    if (waiting[v] > 0) --left;
    waiting[v] = 0;
    for_each_neighbour(mesh, v, [&, from = v, reached = d](VertexId w) {
      relax(w, reached + (mesh.position(w) - mesh.position(from)).norm());
    });
  }
  return distance;
}

/// Builds a Reach in the order of its member functions.
class Cutter {
 public:
  Cutter(const Mesh& mesh, const DistanceQuery& query)
      : mesh_(mesh), query_(query), views_(find_views(mesh, query.generator)) {
    origin_ = position(mesh, query.generator);
    slot_.assign(static_cast<std::size_t>(mesh.face_count()), -1);
    reach_.distances.assign(query.points.size(), std::numeric_limits<double>::quiet_NaN());
  }

  Reach run() {
    sort_points();
    if (far_.empty()) return std::move(reach_);
    measure_radius();
    if (far_.empty()) return std::move(reach_);
    collect_faces();
    name_vertices();
    write_faces();
    write_targets();
    return std::move(reach_);
  }

 private:
  bool touches(FaceId f) const {
    return std::any_of(views_.begin(), views_.end(), [f](const SurfacePoint& view) { return view.face == f; });
  }

  /// Points in a face that touches the generator are at the end of a straight line; the others are far.
  void sort_points() {
    for (std::size_t i = 0; i < query_.points.size(); ++i) {
      const SurfacePoint& point = query_.points[i];
      check_point(mesh_, point);
      if (touches(point.face)) {
        reach_.distances[i] = (position(mesh_, point) - origin_).norm();
      } else {
        far_.push_back(i);
      }
    }
  }

  /// The radius, from upper bounds; drops the points that nothing reaches.
  void measure_radius() {
    std::vector<VertexId> wanted;
    for (const std::size_t i : far_) {
      for (const VertexId v : mesh_.vertices(query_.points[i].face)) wanted.push_back(v);
    }
    const auto distance = compute_edge_distances(mesh_, views_, wanted);
    std::vector<std::size_t> reached;
    for (const std::size_t i : far_) {
      const SurfacePoint& point = query_.points[i];
      const Vec3 at = position(mesh_, point);
      double bound = kInfinity;
      for (const VertexId v : mesh_.vertices(point.face)) {
        bound = std::min(bound, distance[v] + (mesh_.position(v) - at).norm());
      }
      if (std::isinf(bound)) {
        reach_.distances[i] = bound;
      } else {
        reached.push_back(i);
        radius_ = std::max(radius_, bound);
      }
    }
    radius_ *= 1 + kRadiusSlack;
    far_ = std::move(reached);
  }

  /// Whether some point of f can lie in the ball, by f's own enclosing ball.
  bool in_ball(FaceId f) const {
    Vec3 centre = Vec3::Zero();
    for (const VertexId v : mesh_.vertices(f)) centre += mesh_.position(v) / 3;
    double extent = 0;
    for (const VertexId v : mesh_.vertices(f)) extent = std::max(extent, (mesh_.position(v) - centre).norm());
    return (centre - origin_).norm() - extent <= radius_;
  }

  void take(FaceId f) {
    if (slot_[f] >= 0) return;
    slot_[f] = static_cast<int>(faces_.size());
    faces_.push_back(f);
  }

  void collect_faces() {
    for (const SurfacePoint& view : views_) take(view.face);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh_.twin(Mesh::halfedge(faces_[i], corner));
        if (twin.valid() && in_ball(Mesh::face(twin))) take(Mesh::face(twin));
      }
    }
  }

  std::size_t corner_index(HalfedgeId h) const {
    return 3 * static_cast<std::size_t>(slot_[Mesh::face(h)]) + static_cast<std::size_t>(Mesh::corner(h));
  }

  bool taken(HalfedgeId h) const { return h.valid() && slot_[Mesh::face(h)] >= 0; }

  /// One local vertex for each fan of taken faces.
  void name_vertices() {
    corner_vertex_.assign(3 * faces_.size(), -1);
    for (const FaceId f : faces_) {
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId start = Mesh::halfedge(f, corner);
        if (corner_vertex_[corner_index(start)] >= 0) continue;
        const int name = add_vertex(mesh_.position(mesh_.from(start)));
        for (HalfedgeId h = start; taken(h) && corner_vertex_[corner_index(h)] < 0; h = mesh_.twin(Mesh::previous(h))) {
          corner_vertex_[corner_index(h)] = name;
        }
        HalfedgeId h = mesh_.twin(start);
        while (taken(h) && corner_vertex_[corner_index(Mesh::next(h))] < 0) {
          corner_vertex_[corner_index(Mesh::next(h))] = name;
          h = mesh_.twin(Mesh::next(h));
        }
      }
    }
  }

  int add_vertex(const Vec3& at) {
    reach_.positions.push_back(at);
    return static_cast<int>(reach_.positions.size()) - 1;
  }

  /// The faces that touch the generator come first, each one cut at it: the piece that leaves out a corner has an
  /// area in proportion to that corner's coordinate. The others follow whole.
  void write_faces() {
    reach_.source = add_vertex(origin_);
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::array<int, 3> face{corner_vertex_[3 * i], corner_vertex_[3 * i + 1], corner_vertex_[3 * i + 2]};
      if (i >= views_.size()) {
        local_face_.push_back(static_cast<int>(reach_.faces.size()));
        reach_.faces.push_back(face);
        continue;
      }
      local_face_.push_back(-1);
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (views_[i].bary[corner] == 0) continue;
        reach_.faces.push_back(face);
        reach_.faces.back()[corner] = reach_.source;
      }
    }
  }

  void write_targets() {
    for (const std::size_t i : far_) {
      const SurfacePoint& point = query_.points[i];
      reach_.targets.push_back({i, local_face_[static_cast<std::size_t>(slot_[point.face])], point.bary});
    }
  }

  const Mesh& mesh_;
  const DistanceQuery& query_;
  std::vector<SurfacePoint> views_;
  Vec3 origin_;
  double radius_ = 0;
  std::vector<std::size_t> far_;
  IdVector<FaceId, int> slot_;  ///< place in faces_, -1 for a face that is not taken
  std::vector<FaceId> faces_;
  std::vector<int> corner_vertex_;
  std::vector<int> local_face_;
  Reach reach_;
};

}  // namespace

Reach cut_reach(const Mesh& mesh, const DistanceQuery& query) {
  check_point(mesh, query.generator);
  return Cutter(mesh, query).run();
}

}  // namespace gvd
