#include "fuzz/random_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/barycentric.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd::test {
namespace {

using Points = std::vector<SurfacePoint>;

constexpr Bary kCentre{1.0 / 3, 1.0 / 3, 1.0 / 3};

/// Number of vertices, edges or faces used where all of them become generators, so that a case stays cheap.
constexpr int kMost = 60;

FaceId any_face(const Mesh& mesh, Random& random) { return FaceId(random.below(mesh.face_count())); }
HalfedgeId any_halfedge(const Mesh& mesh, Random& random) { return HalfedgeId(random.below(mesh.halfedge_count())); }
VertexId any_vertex(const Mesh& mesh, Random& random) { return VertexId(random.below(mesh.vertex_count())); }

Bary any_bary(Random& random) {
  const double a = random.real(0, 1), b = random.real(0, 1 - a);
  return {a, b, 1 - a - b};
}

/// A tiny number, from 1 % down to where kBarycentricSnap begins.
double tiny(Random& random) { return std::pow(10, random.real(-11.5, -2)); }

SurfacePoint any_point(const Mesh& mesh, Random& random) {
  const FaceId f = any_face(mesh, random);
  const HalfedgeId h = Mesh::halfedge(f, random.below(3));
  Bary bary = kCentre;
  switch (random.below(7)) {
    case 0:
      return vertex_point(mesh, any_vertex(mesh, random));
    case 1:
      return edge_point(h, random.real(0.01, 0.99));
    case 2:
      return edge_point(h, 0.5);
    case 3:
      break;
    case 4: {  // next to a corner
      const double e = tiny(random);
      bary = {1 - 2 * e, e, e};
      break;
    }
    case 5: {  // next to a side
      const double e = tiny(random), t = random.real(0, 1 - e);
      bary = {e, t, 1 - e - t};
      break;
    }
    default:
      bary = any_bary(random);
  }
  std::rotate(bary.begin(), bary.begin() + random.below(3), bary.end());
  return make_surface_point(f, bary);
}

Points any_points(const Mesh& mesh, Random& random) {
  Points points;
  for (int i = random.below(random.below(4) == 0 ? 40 : 10); i >= 0; --i) points.push_back(any_point(mesh, random));
  return points;
}

Points every_vertex(const Mesh& mesh, Random&) {
  Points points;
  for (int v = 0; v < std::min(kMost, mesh.vertex_count()); ++v) points.push_back(vertex_point(mesh, VertexId(v)));
  return points;
}

Points every_face(const Mesh& mesh, Random&) {
  Points points;
  for (int f = 0; f < std::min(kMost, mesh.face_count()); ++f) points.push_back(make_surface_point(FaceId(f), kCentre));
  return points;
}

Points every_edge(const Mesh& mesh, Random&) {
  Points points;
  for (int e = 0; e < std::min(kMost, mesh.edge_count()); ++e)
    points.push_back(edge_point(mesh.halfedge(EdgeId(e)), 0.5));
  return points;
}

Points in_one_face(const Mesh& mesh, Random& random) {
  Points points;
  const FaceId f = any_face(mesh, random);
  for (int i = 5 + random.below(40); i >= 0; --i) points.push_back(make_surface_point(f, any_bary(random)));
  return points;
}

Points along_one_edge(const Mesh& mesh, Random& random) {
  Points points;
  const HalfedgeId h = any_halfedge(mesh, random);
  const int n = 2 + random.below(20);
  for (int i = 1; i < n; ++i) points.push_back(edge_point(h, double(i) / n));
  return points;
}

/// A vertex, and a point very close to it on each of its edges and in each of its faces.
Points round_one_vertex(const Mesh& mesh, Random& random) {
  const VertexId v = any_vertex(mesh, random);
  const double e = tiny(random);
  Points points{vertex_point(mesh, v)};
  for_each_outgoing(mesh, v, [&](HalfedgeId h) {
    points.push_back(edge_point(h, e));
    if (random.below(2) == 0) return;
    Bary bary{e, e, e};
    bary[Mesh::corner(h)] = 1 - 2 * e;
    points.push_back(make_surface_point(Mesh::face(h), bary));
  });
  return points;
}

/// Groups whose members are 1e-3 to 1e-12 of a face apart.
Points near_coincident(const Mesh& mesh, Random& random) {
  Points points;
  for (int group = random.below(3); group >= 0; --group) {
    const FaceId f = any_face(mesh, random);
    const Bary middle = any_bary(random);
    const double e = std::pow(10, random.real(-12, -3));
    for (int i = 1 + random.below(5); i >= 0; --i) {
      const double a = std::clamp(middle[0] + e * random.real(-1, 1), 0.0, 1.0);
      const double b = std::clamp(middle[1] + e * random.real(-1, 1), 0.0, 1 - a);
      points.push_back(make_surface_point(f, {a, b, 1 - a - b}));
    }
  }
  return points;
}

Points on_boundary(const Mesh& mesh, Random& random) {
  Points points;
  for (int e = 0; e < mesh.edge_count(); ++e) {
    const HalfedgeId h = mesh.halfedge(EdgeId(e));
    if (!mesh.is_boundary(EdgeId(e)) || random.below(3) == 0) continue;
    points.push_back(edge_point(h, random.below(2) == 0 ? 0.5 : random.real(0.01, 0.99)));
  }
  return points.empty() ? any_points(mesh, random) : points;
}

struct Kind {
  const char* name;
  Points (*make)(const Mesh&, Random&);
};

constexpr std::array kKinds{Kind{"anywhere", &any_points},
                            Kind{"on every vertex", &every_vertex},
                            Kind{"in every face", &every_face},
                            Kind{"on every edge", &every_edge},
                            Kind{"in one face", &in_one_face},
                            Kind{"along one edge", &along_one_edge},
                            Kind{"round one vertex", &round_one_vertex},
                            Kind{"nearly coincident", &near_coincident},
                            Kind{"on the boundary", &on_boundary}};

/// Removes duplicates, but sometimes keeps them to provoke the error.
void drop_equal(const Mesh& mesh, Random& random, Points& points) {
  Points kept;
  for (const SurfacePoint& point : points) {
    const SurfacePoint same = canonical(mesh, point);
    const bool is_new = std::none_of(kept.begin(), kept.end(), [&](const SurfacePoint& other) {
      return canonical(mesh, other) == same || position(mesh, other) == position(mesh, same);
    });
    if (is_new || random.below(50) == 0) kept.push_back(point);
  }
  points = std::move(kept);
}

}  // namespace

RandomPoints make_random_points(const Mesh& mesh, Random& random) {
  const Kind& kind = kKinds[random.below(static_cast<int>(kKinds.size()))];
  RandomPoints result{kind.name, kind.make(mesh, random)};
  drop_equal(mesh, random, result.points);
  return result;
}

bool are_close(const Mesh& mesh, const std::vector<SurfacePoint>& points, double close) {
  const double limit = close * std::max(mesh.bbox_diagonal(), 0.01 * mesh.largest_coordinate());
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if ((position(mesh, points[i]) - position(mesh, points[j])).norm() < limit) return true;
    }
  }
  return false;
}

}  // namespace gvd::test
