#include "mesh/repair/repair_touching_edges.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace gvd {
namespace {

std::size_t index(std::int32_t i) { return static_cast<std::size_t>(i); }

class EdgeSplitter {
 public:
  explicit EdgeSplitter(WorkFaces& work) : work_(work), moved_(index(work.halfedge_count()), -1) {}

  // `halfedges`: all of one edge, numbered as before the first split.
  void split(std::vector<std::int32_t> halfedges) {
    for (std::int32_t& h : halfedges) h = now(h);
    const std::int32_t kept = halfedges.front();
    std::vector<std::int32_t> done = {kept, work_.twin[index(kept)]};
    for (const std::int32_t h : halfedges) {
      if (std::find(done.begin(), done.end(), h) != done.end()) continue;
      done.push_back(work_.twin[index(h)]);
      split_piece(h, work_.twin[index(h)]);
    }
  }

 private:
  // The current number of a halfedge of the original faces.
  std::int32_t now(std::int32_t h) const {
    while (moved_[index(h)] >= 0) h = moved_[index(h)];
    return h;
  }

  void split_piece(std::int32_t h, std::int32_t twin) {
    const std::int32_t m = add_vertex(h, twin);
    const std::int32_t second = split_face(h, m);
    if (twin < 0) {
      work_.twin[index(second)] = -1;
      return;
    }
    const std::int32_t twin_second = split_face(twin, m);
    link(h, twin_second);
    link(second, twin);
  }

  // The face (a, b, c) of h = a-b becomes (a, m, c) in its place and (m, b, c) at the end. Returns m-b; h becomes a-m.
  std::int32_t split_face(std::int32_t h, std::int32_t m) {
    const std::int32_t b = work_.to(h);
    const std::int32_t c = work_.from(WorkFaces::previous(h));
    const std::int32_t side = WorkFaces::next(h);  // b-c, from now on m-c
    const std::int32_t outer = work_.twin[index(side)];
    work_.faces[index(h / 3)][index(side % 3)] = m;
    const auto first = work_.halfedge_count();
    work_.faces.push_back({m, b, c});
    work_.origin.push_back(work_.origin[index(h / 3)]);
    work_.twin.resize(work_.twin.size() + 3, -1);
    moved_.resize(moved_.size() + 3, -1);
    moved_[index(side)] = first + 1;
    if (outer >= 0) link(first + 1, outer);
    link(first + 2, side);
    return first;
  }

  // At the middle of the edge, or beside it where an opposite corner lies at the middle: no edge may have length 0.
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
      return static_cast<std::int32_t>(work_.positions.size() - 1);
    }
    const std::int32_t face = work_.origin[index(h / 3)];
    refuse_soup(fmt::format("the surface touches itself along an edge of face {} that is too short to be split", face),
                face);
  }

  void link(std::int32_t a, std::int32_t b) {
    work_.twin[index(a)] = b;
    work_.twin[index(b)] = a;
  }

  Vec3 at(std::int32_t v) const { return work_.positions[index(v)]; }

  WorkFaces& work_;
  std::vector<std::int32_t> moved_;
};

}  // namespace

void split_touching_edges(WorkFaces& work, DefectLog& log) {
  if (log.report().count(DefectKind::nonmanifold_edges) == 0) return;
  std::vector<std::vector<std::int32_t>> touching;
  visit_edges(work, work.positions.size(), [&](const EdgeHalfedges& edge) {
    if (edge.size() == 1 || (edge.size() == 2 && work.from(edge[0]) != work.from(edge[1]))) return;  // an ordinary edge
    touching.emplace_back();
    for (std::size_t i = 0; i < edge.size(); ++i) touching.back().push_back(edge[i]);
  });
  EdgeSplitter splitter(work);
  for (const auto& halfedges : touching) splitter.split(halfedges);
  log.report().split_edges = static_cast<std::int64_t>(touching.size());
}

}  // namespace gvd
