#include <cmath>
#include <queue>

#include "geodesic/marching/local_march.hpp"
#include "geodesic/marching/local_update.hpp"
#include "mesh/vertex_ring.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_local_march {

/// The last column of vertices moved away: its edges become much longer than the mean.
Mesh moved(const Mesh& mesh, double by) {
  std::vector<Vec3> positions = mesh.positions();
  double last = 0;
  for (const Vec3& p : positions) last = std::max(last, p.x());
  for (Vec3& p : positions) p.x() += p.x() == last ? by : 0;
  return Mesh(std::move(positions), mesh.face_vertices());
}

SurfacePoint point_in(FaceId f) { return make_surface_point(f, {0.2, 0.3, 0.5}); }

TEST_CASE("before the first run nothing is reached") {
  const Mesh mesh = test::make_triangle();
  const LocalMarch march(mesh, Front::circle);
  CHECK(march.reached().empty());
}

TEST_CASE("in the faces of the start distances are straight, from a vertex, an edge and a face") {
  const Mesh mesh = test::make_pillow();
  LocalMarch march(mesh, Front::circle);
  for (const SurfacePoint& start :
       {vertex_point(mesh, VertexId(1)), edge_point(Mesh::halfedge(FaceId(0), 1), 0.25), point_in(FaceId(0))}) {
    march.run(start, kInfinity);
    for (int v = 0; v < 3; ++v) {
      CHECK(march.distance(VertexId(v)) == Approx((mesh.position(VertexId(v)) - position(mesh, start)).norm()));
    }
    CHECK(march.distance(start) == Approx(0).margin(1e-12));
  }
}

TEST_CASE("with circle fronts distances on a flat grid are straight, at vertices and inside of faces") {
  const Mesh mesh = test::make_grid(9, 7);
  LocalMarch march(mesh, Front::circle);
  for (const SurfacePoint& start : {vertex_point(mesh, VertexId(34)), point_in(FaceId(50))}) {
    march.run(start, kInfinity);
    CHECK(march.reached().size() == static_cast<std::size_t>(mesh.vertex_count()));
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      const double straight = (mesh.position(VertexId(v)) - position(mesh, start)).norm();
      REQUIRE(march.distance(VertexId(v)) == Approx(straight).epsilon(1e-10));
    }
    for (int f = 0; f < mesh.face_count(); ++f) {
      const SurfacePoint p = point_in(FaceId(f));
      REQUIRE(march.distance(p) == Approx((position(mesh, p) - position(mesh, start)).norm()).epsilon(1e-10));
    }
  }
}

TEST_CASE("a run stops at its limit: beyond it only the ring of vertices is reached") {
  const Mesh mesh = test::make_grid(30, 30);
  LocalMarch march(mesh, Front::circle);
  const SurfacePoint start = vertex_point(mesh, VertexId(15 * 31 + 15));
  march.run(start, 3);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    const double straight = (mesh.position(VertexId(v)) - position(mesh, start)).norm();
    if (straight < 3) REQUIRE(march.distance(VertexId(v)) == Approx(straight).epsilon(1e-10));
    if (straight > 3 + 2 * std::sqrt(2)) REQUIRE(std::isinf(march.distance(VertexId(v))));
  }
  CHECK(std::isinf(march.distance(point_in(FaceId(0)))));
}

TEST_CASE("a vertex that is nearer to something else does not propagate") {
  const Mesh mesh = test::make_grid(20, 20);
  LocalMarch march(mesh, Front::circle);
  // The left half belongs to others.
  IdVector<PlaceId, double> upper(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
  for (int v = 0; v < mesh.vertex_count(); ++v) {
    if (mesh.position(VertexId(v)).x() < 10) upper[march.fans().place(VertexId(v))] = 0;
  }
  march.run(vertex_point(mesh, VertexId(10 * 21 + 15)), kInfinity, &upper);
  for (const PlaceId p : march.reached()) REQUIRE(mesh.position(march.fans().vertex(p)).x() >= 9);
  CHECK(march.reached().size() >= 11 * 21);
}

TEST_CASE("a second run does not depend on the first one") {
  const Mesh mesh = test::make_bumpy_sphere(2, 4);
  LocalMarch used(mesh, Front::circle), fresh(mesh, Front::circle);
  used.run(vertex_point(mesh, VertexId(0)), kInfinity);
  const SurfacePoint start = point_in(FaceId(20));
  used.run(start, 0.7);
  fresh.run(start, 0.7);
  CHECK(used.reached() == fresh.reached());
  for (int v = 0; v < mesh.vertex_count(); ++v) REQUIRE(used.distance(VertexId(v)) == fresh.distance(VertexId(v)));
}

/// The same march without places, fans and buckets, from a vertex: one heap of all events.
class PlainMarch {
 public:
  PlainMarch(const Mesh& mesh, VertexId start, const std::vector<double>& upper)
      : mesh_(mesh), start_(start), upper_(upper), distance_(upper.size(), kInfinity), gained_(upper.size(), 0) {
    reach(start, 0);
    while (!queue_.empty()) {
      const auto [d, v] = queue_.top();
      queue_.pop();
      if (d == distance_[v.index()]) relax(v);
    }
  }

  const std::vector<double>& distances() const { return distance_; }
  const std::vector<VertexId>& reached() const { return reached_; }

 private:
  bool is_below(VertexId v) const { return distance_[v.index()] < upper_[v.index()]; }

  void reach(VertexId v, double d) {
    double& now = distance_[v.index()];
    if (now == kInfinity) {
      reached_.push_back(v);
    } else if (d < now * (1 - std::ldexp(1e-13, gained_[v.index()]))) {
      ++gained_[v.index()];
    } else {
      return;
    }
    now = d;
    queue_.push({d, v});
  }

  void relax(VertexId v) {
    const bool propagates = is_below(v) || v == start_;
    for_each_outgoing(mesh_, v, [&](HalfedgeId h) {
      const HalfedgeId before = Mesh::previous(h);
      const VertexId b = mesh_.to(h), c = mesh_.from(before);
      const bool has_b = distance_[b.index()] < kInfinity, has_c = distance_[c.index()] < kInfinity;
      reach_beyond(h, before, v, has_b ? b : VertexId(), c, propagates);
      reach_beyond(before, h, v, has_c ? c : VertexId(), b, propagates);
    });
  }

  void reach_beyond(HalfedgeId base, HalfedgeId side, VertexId v, VertexId other, VertexId apex, bool propagates) {
    const double d = distance_[v.index()], along = d + mesh_.length(side);
    if (!other.valid()) {
      if (propagates && distance_[apex.index()] > d) reach(apex, along);
      return;
    }
    const double least = std::min(d, distance_[other.index()]);
    if (distance_[apex.index()] <= least || !(propagates || is_below(other))) return;
    const UpdateTriangle t = make_update_triangle(mesh_.shape(Mesh::face(base)), Mesh::corner(base));
    const double a = distance_[mesh_.from(base).index()], b = distance_[mesh_.to(base).index()];
    reach(apex, std::min(along, std::max(update_circle(t, a, b), least)));
  }

  using Event = std::pair<double, VertexId>;
  const Mesh& mesh_;
  VertexId start_;
  const std::vector<double>& upper_;
  std::vector<double> distance_;
  std::vector<int> gained_;
  std::vector<VertexId> reached_;
  std::priority_queue<Event, std::vector<Event>, std::greater<>> queue_;
};

TEST_CASE("distances and their order are those of a march with one heap, to the last bit") {
  auto family = test::small_family();
  // Edges beyond the ring of buckets, and ties everywhere.
  family.push_back({"grid with a long strip", moved(test::make_grid(60, 2), 1e5)});
  family.push_back({"grid", test::make_grid(30, 30)});
  for (const auto& [name, mesh] : family) {
    INFO(name);
    LocalMarch march(mesh, Front::circle);
    IdVector<PlaceId, double> upper(static_cast<std::size_t>(mesh.vertex_count()), kInfinity);
    std::vector<double> plain_upper(upper.size(), kInfinity);
    for (int i = 0; i < 12; ++i) {
      const VertexId start(mesh.vertex_count() * i / 12);
      march.run(vertex_point(mesh, start), kInfinity, &upper);
      const PlainMarch plain(mesh, start, plain_upper);
      REQUIRE(march.reached().size() == plain.reached().size());
      for (std::size_t k = 0; k < plain.reached().size(); ++k) {
        REQUIRE(march.fans().vertex(march.reached()[k]) == plain.reached()[k]);
      }
      for (const VertexId v : mesh.vertices()) {
        REQUIRE(march.distance(v) == plain.distances()[v.index()]);
        plain_upper[v.index()] = std::min(plain_upper[v.index()], march.distance(v));
        upper[march.fans().place(v)] = plain_upper[v.index()];
      }
    }
  }
}

}  // namespace gvd::test_local_march
