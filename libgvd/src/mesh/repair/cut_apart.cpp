// Cuts a soup apart where it is not manifold: first at edges of three or more faces, then at vertices of several fans.
//
// The faces of an edge are sorted around it, and neighbours stay together if the inside of the surface lies between
// them. So bodies that touch along an edge stay closed, and a fin is cut off. Then each fan of faces gets a vertex of
// its own, and edges that still share both ends get midpoints. Angles are compared by divisions alone, so that the
// order is the same on every machine, unlike with atan2.
// Source: A. Gueziec, G. Taubin, F. Lazarus and B. Horn, Cutting and stitching, 2001, for cutting vertices into their
// fans.
// Cost: O(n log n) for n halfedges of edges with three or more faces, and O(n) for all others.
// Invariant: no vertex moves and no area is lost; copies and midpoints are appended.
#include "mesh/repair/cut_apart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "gvd/text.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"
#include "mesh/visit_edges.hpp"

namespace gvd {
namespace {

/// A number that increases with the angle of (x, y), from 0 to 4.
double pseudo_angle(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  if (sum == 0) return 0;
  if (y >= 0) return x >= 0 ? y / sum : 1 - x / sum;
  return x < 0 ? 2 - y / sum : 3 + x / sum;
}

struct Spoke {
  double angle;
  std::int32_t halfedge;
  bool forward;  // whether it runs from the edge's smaller vertex to its larger one
};

/// Sorts the faces of an edge counter-clockwise around it, as seen from its larger vertex.
std::vector<Spoke> sort_round_edge(const WorkFaces& work, const std::vector<std::int32_t>& halfedges,
                                   const std::vector<Vec3>& positions) {
  const auto at = [&](std::int32_t v) -> const Vec3& { return positions[v]; };
  const auto [low, high] = std::minmax({work.from(halfedges[0]), work.to(halfedges[0])});
  const Vec3 axis = (at(high) - at(low)).stableNormalized();
  const Vec3 x = axis.unitOrthogonal();
  const Vec3 y = axis.cross(x);
  std::vector<Spoke> spokes;
  for (const std::int32_t h : halfedges) {
    const Vec3 arm = at(work.from(WorkFaces::previous(h))) - at(low);
    spokes.push_back({pseudo_angle(arm.dot(x), arm.dot(y)), h, work.from(h) == low});
  }
  std::ranges::sort(spokes, {}, [](const Spoke& s) { return std::tuple(s.angle, s.halfedge); });
  return spokes;
}

/// Pairs faces with the inside between them. The normal of a forward face points towards increasing angles, and the
/// normal of a backward face towards decreasing angles. So the inside lies between a backward face and the next forward
/// face.
void pair_inside(WorkFaces& work, const std::vector<Spoke>& spokes) {
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& a = spokes[i];
    const Spoke& b = spokes[(i + 1) % spokes.size()];
    if (a.forward || !b.forward || a.halfedge / 3 == b.halfedge / 3) continue;
    work.link(a.halfedge, b.halfedge);
  }
}

/// Gives the corners of a fan another vertex. A corner is identified by the halfedge that leaves it. The walk goes
/// around the vertex from the corner h in both directions until the fan closes or ends. It can't use vertex_ring.hpp,
/// because vertices of a soup may have several fans.
void rename_fan(WorkFaces& work, std::int32_t h, std::int32_t vertex, std::vector<char>& is_named) {
  const auto rename = [&](std::int32_t corner) {
    work.faces[corner / 3][corner % 3] = vertex;
    is_named[corner] = 1;
  };
  std::int32_t corner = h;
  do {
    rename(corner);
    corner = work.twin[WorkFaces::previous(corner)];
  } while (corner >= 0 && corner != h);
  if (corner == h) return;
  corner = h;
  while (work.twin[corner] >= 0) {
    corner = WorkFaces::next(work.twin[corner]);
    rename(corner);
  }
}

/// Splits all but the first of several edges that have the same two vertices.
class EdgeSplitter {
 public:
  explicit EdgeSplitter(WorkFaces& work) : work_(work), moved_(work.halfedge_count(), -1) {}

  /// `halfedges`: all halfedges between two vertices, by their numbers before the first split.
  void split(std::vector<std::int32_t> halfedges) {
    for (std::int32_t& h : halfedges) h = now(h);
    const std::int32_t kept = halfedges.front();
    std::vector<std::int32_t> done = {kept, work_.twin[kept]};
    for (const std::int32_t h : halfedges) {
      if (std::find(done.begin(), done.end(), h) != done.end()) continue;
      done.push_back(work_.twin[h]);
      split_piece(h, work_.twin[h]);
    }
  }

 private:
  /// The current number of a halfedge of the original faces.
  std::int32_t now(std::int32_t h) const {
    while (moved_[h] >= 0) h = moved_[h];
    return h;
  }

  void split_piece(std::int32_t h, std::int32_t twin) {
    const std::int32_t m = add_vertex(h, twin);
    const std::int32_t second = split_face(h, m);
    if (twin < 0) return;
    const std::int32_t twin_second = split_face(twin, m);
    work_.link(h, twin_second);
    work_.link(second, twin);
  }

  /// Splits the face (a, b, c) of h = a-b: it becomes (a, m, c), and (m, b, c) is appended. Returns m-b; h becomes a-m.
  std::int32_t split_face(std::int32_t h, std::int32_t m) {
    const std::int32_t b = work_.to(h);
    const std::int32_t c = work_.from(WorkFaces::previous(h));
    const std::int32_t side = WorkFaces::next(h);  // b-c, from now on m-c
    const std::int32_t outer = work_.twin[side];
    work_.faces[h / 3][side % 3] = m;
    const auto first = work_.halfedge_count();
    work_.faces.push_back({m, b, c});
    work_.origin.push_back(work_.origin[h / 3]);
    work_.twin.resize(work_.twin.size() + 3, -1);
    moved_.resize(moved_.size() + 3, -1);
    moved_[side] = first + 1;
    if (outer >= 0) work_.link(first + 1, outer);
    work_.link(first + 2, side);
    return first;
  }

  /// Adds a vertex at the middle of the edge. If an opposite corner lies exactly there, the vertex is placed beside the
  /// middle, so that no edge has length 0.
  std::int32_t add_vertex(std::int32_t h, std::int32_t twin) {
    const Vec3 a = at(work_.from(h));
    const Vec3 b = at(work_.to(h));
    const Vec3 c = at(work_.from(WorkFaces::previous(h)));
    const Vec3 d = twin < 0 ? c : at(work_.from(WorkFaces::previous(twin)));
    for (const double t : {0.5, 0.375, 0.625}) {
      const Vec3 m = a + t * (b - a);
      if (m == a || m == b || m == c || m == d) continue;
      work_.positions.push_back(m);
      work_.source.push_back(-1);
      return std::int32_t(work_.positions.size() - 1);
    }
    const std::int32_t face = work_.origin[h / 3];
    refuse_soup(fmt::format("the surface touches itself along an edge of face {} that is too short to be split", face),
                face);
  }

  Vec3 at(std::int32_t v) const { return work_.positions[v]; }

  WorkFaces& work_;
  std::vector<std::int32_t> moved_;
};

}  // namespace

std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log) {
  std::vector<char> on_cut_edge(positions.size(), 0);
  std::pair<std::int32_t, std::size_t> first(-1, 0);  // the least halfedge, and the number of its edge's faces
  for (std::vector<std::int32_t> halfedges : nonmanifold_edges) {
    const std::int32_t least = *std::min_element(halfedges.begin(), halfedges.end());
    if (first.first < 0 || least < first.first) first = {least, halfedges.size()};
    for (const std::int32_t v : {work.from(least), work.to(least)}) on_cut_edge[v] = 1;
    std::erase_if(halfedges, [&](std::int32_t h) { return one_sided[h / 3] != 0; });
    if (!halfedges.empty()) pair_inside(work, sort_round_edge(work, halfedges, positions));
  }
  if (nonmanifold_edges.empty()) return on_cut_edge;
  const auto [h, size] = first;
  const std::int32_t face = work.origin[h / 3];
  const auto [low, high] = std::minmax({work.from(h), work.to(h)});
  log.add(DefectKind::nonmanifold_edges, std::ssize(nonmanifold_edges), face,
          fmt::format("{} more than two faces, first the one between vertices {} and {} ({} faces, one is face {})",
                      counted(std::ssize(nonmanifold_edges), "edge has", "edges have"), low, high, size, face),
          "cut apart");
  return on_cut_edge;
}

void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log) {
  work.positions = positions;
  work.source.resize(positions.size());
  std::iota(work.source.begin(), work.source.end(), 0);
  std::vector<char> is_named(work.halfedge_count(), 0);  // for each corner, whether its vertex is final
  // For each input vertex, the number of fans so far: 0, 1, or 2 for several.
  std::vector<char> fans(positions.size(), 0);
  std::int64_t count = 0;
  std::int32_t first = -1;
  // The first fan of a vertex keeps it; the others get copies, in the order of their first corners.
  for (std::int32_t h = 0; h < work.halfedge_count(); ++h) {
    if (is_named[h]) continue;
    const std::int32_t v = work.from(h);
    std::int32_t vertex = v;
    if (fans[v] > 0) {
      vertex = std::int32_t(work.positions.size());
      work.source.push_back(v);
      work.positions.push_back(Vec3(work.positions[v]));
      if (work.positions.size() > 0x7fffffff) refuse_soup("more vertices than 32-bit ids can count", v);
    }
    if (fans[v] == 1 && !on_cut_edge[v]) {
      ++count;
      first = first < 0 ? v : std::min(first, v);
    }
    if (fans[v] < 2) ++fans[v];
    rename_fan(work, h, vertex, is_named);
  }
  log.add(
      DefectKind::nonmanifold_vertices, count, first,
      fmt::format("{} several fans of faces, first vertex {}", counted(count, "vertex joins", "vertices join"), first),
      "cut apart");
}

void split_touching_edges(WorkFaces& work, DefectLog& log) {
  if (log.report().count(DefectKind::nonmanifold_edges) == 0) return;
  EdgeTable touching;
  visit_edges(work.faces, work.positions.size(), [&](const EdgeHalfedges& edge) {
    if (edge.size() == 1 || (edge.size() == 2 && work.from(edge[0]) != work.from(edge[1]))) return;  // an ordinary edge
    touching.push_back(edge.list());
  });
  EdgeSplitter splitter(work);
  for (const auto& halfedges : touching) splitter.split(halfedges);
  log.report().split_edges = std::ssize(touching);
}

}  // namespace gvd
