#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// A face's part of the mesh, and its place there.
struct PartPlace {
  std::int32_t part, place;
};

/// A face that a collapse changes.
struct MovedFace {
  std::int32_t place;  ///< in the part
  std::array<VertexId, 3> corners;
};

/// Decides on collapses that topology and normals allow.
class CollapseGuard {
 public:
  virtual ~CollapseGuard() = default;
  /// Whether the faces may change so, where those at the places of `removed` are gone.
  virtual bool allows(std::span<const MovedFace> moved, std::span<const std::int32_t> removed) = 0;
  /// The last one that it has allowed was made.
  virtual void collapsed() = 0;
};

/// Some faces of a mesh, which are decimated without a look at the others.
///
/// Vertices that have a face elsewhere stay, and no vertex collapses to one of them. So the parts of a mesh can be
/// decimated at the same time.
class PartDecimator {
 public:
  /// `faces`: all those of a part, in the order of their places. Cost: O(faces), and 4 bytes a vertex of the mesh.
  PartDecimator(const Mesh& mesh, std::span<const FaceId> faces, const IdVector<FaceId, PartPlace>& places);

  /// Lets these vertices, of the mesh, stay. Others may collapse to them. Before `decimate`.
  void keep(const std::function<bool(VertexId)>& is_kept);

  /// Asks this before each collapse; it must outlive the part. Before `decimate`.
  void guard(CollapseGuard& guard) { guard_ = &guard; }

  /// Where the surface is not flat, collapses may make no edge longer than this, in mesh units, or than it was before.
  /// Before `decimate`.
  void limit_edges(double longest) { longest_ = longest; }

  /// Collapses halfedges until this share of the faces is left, or none can be collapsed. Faces with a vertex that has
  /// to stay count as if all were left. With a guard, collapses that make thin faces or turn them by much follow where
  /// others do not do. `report` is called now and then with the share of the work that is done, and
  /// may throw; it may be empty.
  void decimate(double share, const std::function<void(double)>& report = {});
  /// The same until so many vertices are left.
  void decimate_to(std::int64_t vertices, const std::function<void(double)>& report = {});

  /// Faces that are left, by vertices of the mesh.
  std::vector<std::array<VertexId, 3>> faces() const;
  /// The place in the part of each of them, where it has been a face from the beginning: each of its corners then
  /// collapsed to one of its corners now, or is the same.
  std::vector<std::int32_t> face_places() const;
  /// Enters the vertex that each collapsed vertex went to, which may have collapsed later.
  void enter_targets(IdVector<VertexId, VertexId>& target) const;

 private:
  /// A sum of squared distances from planes, weighted by areas: x A x + 2 b x + c, and the sum of the areas.
  struct Quadric {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Vec3 b = Vec3::Zero();
    double c = 0, area = 0;

    void add_plane(const Vec3& normal, const Vec3& point, double weight) {
      const double distance = normal.dot(point);
      a += weight * normal * normal.transpose();
      b -= weight * distance * normal;
      c += weight * distance * distance;
    }
    void add(const Quadric& other) {
      a += other.a;
      b += other.b;
      c += other.c;
      area += other.area;
    }
    double at(const Vec3& x) const { return x.dot(a * x) + 2 * b.dot(x) + c; }
  };

  static std::int32_t next(std::int32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::int32_t previous(std::int32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::int32_t from(std::int32_t h) const { return corner_[h]; }
  std::int32_t to(std::int32_t h) const { return corner_[next(h)]; }
  bool is_boundary(std::int32_t v) const { return twin_[leaving_[v]] < 0; }

  void link(const Mesh& mesh, std::span<const FaceId> faces, const IdVector<FaceId, PartPlace>& places);
  void add_quadrics();
  /// Calls visit(halfedge) for the halfedges that leave an unlocked vertex, and at the boundary for the last one, which
  /// arrives.
  template <class Visit>
  void for_each_edge(std::int32_t v, Visit visit) const;
  /// The key of a vertex in the heap: minus the cost of its best legal collapse, which is stored.
  double find_best(std::int32_t v);
  bool is_legal(std::int32_t v, std::int32_t halfedge);
  bool keeps_topology(std::int32_t v, std::int32_t w, std::int32_t halfedge);
  /// Whether no face turns by much, gets thin under the strict rules, or gets too long an edge.
  bool keeps_shapes(std::int32_t v, std::int32_t w) const;
  /// Whether the edge to the vertex across would get longer than is allowed.
  bool lengthens(const Vec3& before, const Vec3& after, const Vec3& across) const;
  /// The vertex that v collapses to along a halfedge.
  std::int32_t other_end(std::int32_t v, std::int32_t halfedge) const {
    return from(halfedge) == v ? to(halfedge) : from(halfedge);
  }
  /// How many collapses, at least, a limit on faces or vertices still asks for; none at 0 or below.
  using Excess = std::function<std::int64_t()>;
  /// Collapses while there is an excess, first with the strict rules for faces; with a guard, then without these.
  void decimate_while(const Excess& excess, const std::function<void(double)>& report);
  void collapse_while(const Excess& excess, const std::function<void(double)>& report);
  bool is_refused_by_guard(std::int32_t v, std::int32_t halfedge);
  void collapse(std::int32_t v, std::int32_t halfedge);
  void remove_face(std::int32_t halfedge, std::int32_t kept);
  std::int32_t first_of_fan(std::int32_t halfedge) const;
  /// Whether v is not on the boundary, which stays so. Any halfedge may then be the one that leaves it.
  bool is_inner(std::int32_t v) const { return twin_[leaving_[v]] >= 0; }

  std::vector<VertexId> vertex_;       // of the mesh
  std::vector<Vec3> position_;         // relative to the first vertex
  std::vector<Quadric> quadric_;       // of what collapsed to each vertex
  std::vector<char> is_locked_;        // stays, and is no target
  std::vector<char> is_kept_;          // stays, and may be a target
  std::vector<std::int32_t> leaving_;  // a halfedge of an unlocked vertex; on the boundary the first one of the fan
  std::vector<std::int32_t> target_;   // of collapsed vertices, -1 of others
  std::vector<std::int32_t> best_;     // the halfedge to collapse
  std::vector<std::int32_t> corner_;   // of each halfedge, where it begins; -1 where its face is gone
  std::vector<std::int32_t> twin_;     // -1 on the boundary and between parts
  std::vector<std::int32_t> mark_;     // per vertex: the last question that it is a neighbour in
  std::vector<std::pair<double, std::int32_t>> choices_;
  CollapseGuard* guard_ = nullptr;
  double longest_ = kInfinity;                               // edge that a collapse may make
  bool is_strict_ = true;                                    // no face gets thin, or turns by much
  std::set<std::pair<std::int32_t, std::int32_t>> refused_;  // collapses by the guard, from the first to the second
  std::vector<MovedFace> moved_;
  std::vector<std::int32_t> removed_;
  std::int32_t question_ = 0;
  std::int64_t left_;           // faces
  std::int64_t vertices_left_;  // without those that have collapsed
};

}  // namespace gvd
