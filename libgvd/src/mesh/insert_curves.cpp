// Turns curves into chains of edges of the working mesh.
//
// First, segments of one curve that cross inside a face are divided at the crossing. Then all points become vertices,
// as generators do. Finally, each segment is followed through its face, from one vertex on it to the next; the edges
// that it crosses on the way are flipped until an edge joins the two vertices.
// Source: S. W. Sloan, A fast algorithm for generating constrained Delaunay triangulations (1993).
// Cost: O(k^2) for k segments and crossings in one face, and O(edges crossed) flips on average for each segment.
// Invariant: only edges inside a face of the input are flipped, and no edge of a curve, so the surface stays the same.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {
namespace {

/// A vertex counts as on a segment up to this distance in the affine plane of the face, which is also the distance by
/// which coordinates of surface points are snapped.
constexpr double kOnSegment = kBarycentricSnap;

/// The limit on flips, for each edge that a segment crosses. Each flip of a convex quadrilateral either ends a crossing
/// or leaves it to a later flip; only needles turned over by rounding can need more flips.
constexpr std::size_t kMostFlips = 100;

/// A straight part of a curve in a face of the input, between two points.
struct Segment {
  FaceId face;
  std::array<PointId, 2> points;
  std::array<Bary, 2> ends;  // the coordinates of `points` in the face
  GeneratorId generator;
};

/// The points of all curves in their order, and the segments. Points where a curve crosses itself are appended, so that
/// the user's points keep their numbers.
struct CurvePoints {
  std::vector<SurfacePoint> points;
  IdVector<PointId, GeneratorId> owner;
  std::vector<Segment> segments;
};

CurvePoints collect_points(const Mesh& mesh, const std::vector<GeneratorCurve>& curves) {
  CurvePoints all;
  for (std::size_t g = 0; g < curves.size(); ++g) {
    const auto first = std::int32_t(all.points.size());
    for (const SurfacePoint& p : curves[g].points) {
      all.points.push_back(p);
      all.owner.push_back(GeneratorId(g));
    }
    for (const auto& [a, b] : curves[g].segments) {
      const auto view = *find_common_view(mesh, curves[g].points[a], curves[g].points[b]);
      all.segments.push_back({view.first.face,
                              {PointId(first + a), PointId(first + b)},
                              {view.first.bary, view.second.bary},
                              GeneratorId(g)});
    }
  }
  return all;
}

/// Where two segments of a face cross, as a fraction of each. Only crossings inside both segments count, not a common
/// end.
std::optional<std::array<double, 2>> find_crossing(const Segment& a, const Segment& b) {
  const PlaneSegment first{affine_point(a.ends[0]), affine_point(a.ends[1])};
  const PlaneSegment second{affine_point(b.ends[0]), affine_point(b.ends[1])};
  if (!intersect_beyond(first, second, kOnSegment * (first.to - first.from).norm() * (second.to - second.from).norm()))
    return std::nullopt;
  const auto [s, t] = intersect_lines(first.from, first.to - first.from, second.from, second.to - second.from);
  return std::array{s, t};
}

/// Divides segments where they cross other segments of their curve. Refuses segments of two different curves that
/// cross.
void divide_at_crossings(CurvePoints& all) {
  std::map<FaceId, std::vector<std::size_t>> in_face;
  for (std::size_t i = 0; i < all.segments.size(); ++i) in_face[all.segments[i].face].push_back(i);
  std::map<std::size_t, std::vector<std::pair<double, PointId>>> divisions;  // for each segment
  for (const auto& [face, segments] : in_face) {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        const Segment &a = all.segments[segments[k]], &b = all.segments[segments[i]];
        const auto crossing = find_crossing(a, b);
        if (!crossing) continue;
        if (a.generator != b.generator) {
          throw Error(ErrorCode::precondition,
                      fmt::format("curves {} and {} cross in face {}; make them one curve, or separate them there",
                                  a.generator.value(), b.generator.value(), face.value()),
                      b.generator.value());
        }
        const PointId added(all.points.size());
        all.points.push_back(make_surface_point(face, mix(a.ends[0], a.ends[1], (*crossing)[0])));
        all.owner.push_back(a.generator);
        divisions[segments[k]].emplace_back((*crossing)[0], added);
        divisions[segments[i]].emplace_back((*crossing)[1], added);
      }
    }
  }
  for (auto& [number, points] : divisions) {
    std::sort(points.begin(), points.end());
    Segment rest = all.segments[number];
    for (std::size_t i = 0; i <= points.size(); ++i) {
      Segment part = rest;
      if (i < points.size()) {
        part.points[1] = rest.points[0] = points[i].second;
        part.ends[1] = rest.ends[0] = all.points[points[i].second.index()].bary;
      }
      if (i == 0) {
        all.segments[number] = part;
      } else {
        all.segments.push_back(part);
      }
    }
  }
}

}  // namespace

/// Turns segments into edges, one after the other.
class CurveInsertion {
 public:
  explicit CurveInsertion(WorkingMesh& working) : working_(working) {}

  void insert(const Segment& segment) {
    VertexId at = working_.point_vertex_[segment.points[0]];
    const VertexId target = working_.point_vertex_[segment.points[1]];
    // Each step reaches another vertex on the way.
    for (std::int32_t steps = 0; at != target; ++steps) {
      if (steps > mesh().vertex_count()) fail(segment);
      const VertexId next = step(segment, at, target);
      working_.claim_for(next, segment.generator);
      if (working_.coincident_) throw *working_.coincident_;
      edges_.insert(std::minmax(at, next));
      at = next;
    }
  }

  /// Collects the edges of all curves. This is possible only after the last flip, because each flip reassigns the
  /// halfedges of two faces to other edges. Until then an edge is identified by its ends.
  void finish() {
    CurveEdges& curves = working_.curves_;
    std::set<VertexId> vertices;
    for (const auto& [a, b] : edges_) {
      curves.edges.push_back(mesh().halfedge(mesh().edge(*find(a, b))));
      vertices.insert({a, b});
    }
    std::sort(curves.edges.begin(), curves.edges.end());
    for (const VertexId v : vertices) curves.vertices.emplace_back(v, working_.generator(v));
  }

 private:
  const Mesh& mesh() const { return working_.mesh(); }

  [[noreturn]] static void fail(const Segment& segment) {
    throw Error(ErrorCode::precondition,
                fmt::format("curve {} can't be drawn in face {}: it runs too close to itself for double precision, or "
                            "the face is too thin; leave out points there",
                            segment.generator.value(), segment.face.value()),
                segment.generator.value());
  }

  /// A halfedge that joins two vertices, in either direction.
  std::optional<HalfedgeId> find(VertexId a, VertexId b) const {
    std::optional<HalfedgeId> found;
    for_each_neighbour(mesh(), a, [&](VertexId v, HalfedgeId h) {
      if (v == b) found = h;
    });
    return found;
  }

  /// The distance of p from the line, times the distance of `from` and `to`, in the affine plane of the face. Positive
  /// on the left.
  static double beside(const Bary& from, const Bary& to, const Bary& p) {
    return twice_signed_area(affine_point(from), affine_point(to), affine_point(p));
  }
  static bool is_on(const Bary& from, const Bary& to, const Bary& p) {
    const Vec2 way = affine_point(to) - affine_point(from), step = affine_point(p) - affine_point(from);
    const double along = way.dot(step);
    return std::abs(cross(way, step)) <= kOnSegment * way.norm() && along > 0 && along < way.squaredNorm();
  }

  /// Returns the next vertex on the segment after `at`. An edge then joins the two, which exists already or is made by
  /// flips. Either a face around `at` has a corner on the segment, or exactly one face around `at` lies on both sides
  /// of the segment.
  VertexId step(const Segment& segment, VertexId at, VertexId target) {
    const Bary& to = segment.ends[1];
    std::optional<VertexId> next;
    std::optional<HalfedgeId> across;
    Bary from{};
    for_each_outgoing(mesh(), at, [&](HalfedgeId h) {
      const FaceId f = Mesh::face(h);
      if (next || working_.parent(f) != segment.face) return;
      const auto& corners = working_.corners(f);
      const int i = Mesh::corner(h);
      from = corners[i];
      for (const int k : {(i + 1) % 3, (i + 2) % 3}) {
        const VertexId v = mesh().vertices(f)[k];
        if (v == target || is_on(from, to, corners[k])) next = v;
      }
      // The corners are counter-clockwise, so the segment leaves the face through the side that runs from its right to
      // its left.
      if (beside(from, to, corners[(i + 1) % 3]) < 0 && beside(from, to, corners[(i + 2) % 3]) > 0) {
        across = Mesh::next(h);
      }
    });
    if (next) return *next;
    if (!across) fail(segment);
    return flip_to_edge(segment, from, *across, target);
  }

  /// An edge by its ends on the two sides of the segment.
  struct Crossed {
    VertexId right, left;
  };

  /// Flips the edges that the segment crosses, beginning with `first`, up to the next vertex on the segment. Returns
  /// this vertex.
  VertexId flip_to_edge(const Segment& segment, const Bary& from, HalfedgeId first, VertexId target) {
    std::deque<Crossed> crossed;
    const VertexId end = collect_crossed(segment, from, first, target, crossed);
    std::size_t flips = kMostFlips * crossed.size();
    for (std::size_t postponed = 0; !crossed.empty();) {
      const Crossed edge = crossed.front();
      crossed.pop_front();
      if (edges_.contains(std::minmax(edge.right, edge.left))) {
        throw Error(ErrorCode::precondition,
                    fmt::format("curve {} meets itself or another curve in face {} at too small an angle; leave out "
                                "points there",
                                segment.generator.value(), segment.face.value()),
                    segment.generator.value());
      }
      HalfedgeId h = *find(edge.right, edge.left);
      if (!working_.flip_if_convex(h)) {
        crossed.push_back(edge);
        if (++postponed > crossed.size()) fail(segment);
        continue;
      }
      postponed = 0;
      if (--flips == 0) fail(segment);
      // The new diagonal joins the third corners of the two faces.
      const FaceId f = Mesh::face(h);
      const VertexId a = mesh().vertices(f)[0], b = mesh().vertices(f)[2];
      if (a == end || b == end) continue;
      const double side_a = beside(from, segment.ends[1], working_.corners(f)[0]);
      const double side_b = beside(from, segment.ends[1], working_.corners(f)[2]);
      if (side_a < 0 && side_b > 0) crossed.push_back({a, b});
      if (side_b < 0 && side_a > 0) crossed.push_back({b, a});
    }
    return end;
  }

  /// Collects the edges that the segment crosses, in order, and returns the vertex at which the segment leaves the last
  /// face.
  VertexId collect_crossed(const Segment& segment, const Bary& from, HalfedgeId h, VertexId target,
                           std::deque<Crossed>& crossed) const {
    const Bary& to = segment.ends[1];
    for (;;) {  // h runs from the right to the left of the segment
      crossed.push_back({mesh().from(h), mesh().to(h)});
      const HalfedgeId twin = mesh().twin(h);
      if (!twin.valid() || working_.parent(Mesh::face(twin)) != segment.face) fail(segment);
      const FaceId f = Mesh::face(twin);
      const int top = (Mesh::corner(twin) + 2) % 3;
      const VertexId v = mesh().vertices(f)[top];
      const Bary& p = working_.corners(f)[top];
      if (v == target || is_on(from, to, p)) return v;
      h = beside(from, to, p) > 0 ? Mesh::next(twin) : Mesh::previous(twin);
    }
  }

  WorkingMesh& working_;
  std::set<std::pair<VertexId, VertexId>> edges_;  // the edges of curves by their ends, the smaller one first
};

WorkingMesh::WorkingMesh(const Mesh& input, const std::vector<GeneratorCurve>& curves, const Progress& progress)
    : WorkingMesh(input, curves.size()) {
  check_curves(input, curves);
  CurvePoints all = collect_points(input, curves);
  divide_at_crossings(all);
  owner_ = std::move(all.owner);
  point_vertex_.assign(owner_.size(), VertexId());
  insert(all.points, progress);
  if (coincident_) throw *coincident_;
  CurveInsertion insertion(*this);
  for (const Segment& segment : all.segments) insertion.insert(segment);
  insertion.finish();
  std::int32_t first = 0;
  for (std::size_t g = 0; g < curves.size(); first += std::int32_t(curves[g++].points.size())) {
    generator_vertex_[GeneratorId(g)] = point_vertex_[PointId(first)];
  }
}

}  // namespace gvd
