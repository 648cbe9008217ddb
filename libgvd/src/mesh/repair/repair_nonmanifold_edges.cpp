#include "mesh/repair/repair_nonmanifold_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "gvd/counted.hpp"

namespace gvd {
namespace {

// Increases with the angle of (x, y), from 0 to 4. It needs only divisions, so it is the same on every machine, unlike
// atan2.
double pseudo_angle(double x, double y) {
  const double sum = std::abs(x) + std::abs(y);
  if (sum == 0) return 0;
  if (y >= 0) return x >= 0 ? y / sum : 1 - x / sum;
  return x < 0 ? 2 - y / sum : 3 + x / sum;
}

struct Spoke {
  double angle;
  std::int32_t halfedge;
  bool forward;  // runs from the edge's smaller vertex to its larger one
};

// The faces of an edge, counter-clockwise round it as seen from its larger vertex.
std::vector<Spoke> sort_round_edge(const WorkFaces& work, std::span<const std::int32_t> halfedges,
                                   const std::vector<Vec3>& positions) {
  const auto at = [&](std::int32_t v) -> const Vec3& { return positions[v]; };
  const std::int32_t low = std::min(work.from(halfedges[0]), work.to(halfedges[0]));
  const std::int32_t high = std::max(work.from(halfedges[0]), work.to(halfedges[0]));
  const Vec3 axis = (at(high) - at(low)).stableNormalized();
  const Vec3 x = axis.unitOrthogonal();
  const Vec3 y = axis.cross(x);
  std::vector<Spoke> spokes;
  for (const std::int32_t h : halfedges) {
    const Vec3 arm = at(work.from(WorkFaces::previous(h))) - at(low);
    spokes.push_back({pseudo_angle(arm.dot(x), arm.dot(y)), h, work.from(h) == low});
  }
  std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
    return std::tie(a.angle, a.halfedge) < std::tie(b.angle, b.halfedge);
  });
  return spokes;
}

// The normal of a forward face points to increasing angles, that of a backward face to decreasing ones. So the inside
// lies between a backward face and the forward face that follows it.
void pair_inside(WorkFaces& work, const std::vector<Spoke>& spokes) {
  for (std::size_t i = 0; i < spokes.size(); ++i) {
    const Spoke& a = spokes[i];
    const Spoke& b = spokes[(i + 1) % spokes.size()];
    if (a.forward || !b.forward || a.halfedge / 3 == b.halfedge / 3) continue;
    work.twin[a.halfedge] = b.halfedge;
    work.twin[b.halfedge] = a.halfedge;
  }
}

}  // namespace

std::vector<char> cut_edges(WorkFaces& work, const EdgeTable& nonmanifold_edges, const std::vector<Vec3>& positions,
                            const std::vector<char>& one_sided, DefectLog& log) {
  std::vector<char> on_cut_edge(positions.size(), 0);
  std::int64_t count = 0;
  std::int32_t first = -1;  // the halfedge of the smallest face
  std::size_t first_size = 0;
  std::vector<std::int32_t> current;
  for (const EdgeGroup& edge : nonmanifold_edges.edges) {
    ++count;
    current.clear();
    for (std::size_t i = edge.begin; i < edge.end; ++i) current.push_back(nonmanifold_edges.halfedges[i]);
    const std::int32_t least = *std::min_element(current.begin(), current.end());
    if (first < 0 || least < first) std::tie(first, first_size) = std::pair(least, current.size());
    for (const std::int32_t v : {work.from(least), work.to(least)}) on_cut_edge[v] = 1;
    std::erase_if(current, [&](std::int32_t h) { return one_sided[h / 3] != 0; });
    if (!current.empty()) pair_inside(work, sort_round_edge(work, current, positions));
  }
  if (count == 0) return on_cut_edge;
  const std::int32_t face = work.origin[first / 3];
  log.add(DefectKind::nonmanifold_edges, count, face,
          fmt::format("{} more than two faces, first the one between vertices {} and {} ({} faces, one is face {})",
                      counted(count, "edge has", "edges have"), std::min(work.from(first), work.to(first)),
                      std::max(work.from(first), work.to(first)), first_size, face),
          "cut apart");
  return on_cut_edge;
}

}  // namespace gvd
