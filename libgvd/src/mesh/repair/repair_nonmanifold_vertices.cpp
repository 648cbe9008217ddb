#include "mesh/repair/repair_nonmanifold_vertices.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/counted.hpp"

namespace gvd {
namespace {

// A corner is identified by the halfedge that leaves it. The walk round a vertex is that of vertex_ring.hpp, but for
// the faces of a soup, whose vertices may have several fans.
class FanCutter {
 public:
  FanCutter(WorkFaces& work, const std::vector<Vec3>& positions)
      : work_(work), is_named_(static_cast<std::size_t>(work.halfedge_count()), 0), fans_(positions.size(), 0) {
    work_.positions = positions;
    work_.source.resize(positions.size());
    for (std::size_t v = 0; v < positions.size(); ++v) work_.source[v] = static_cast<std::int32_t>(v);
  }

  // The first fan of a vertex keeps it; the others get copies, in the order of their first corners.
  void cut(const std::vector<char>& on_cut_edge) {
    for (std::int32_t h = 0; h < work_.halfedge_count(); ++h) {
      if (is_named_[h]) continue;
      const std::int32_t v = work_.from(h);
      std::int32_t name = v;
      char& fans = fans_[v];
      if (fans > 0) name = add_copy(v);
      if (fans == 1 && !on_cut_edge[v]) count(v);
      if (fans < 2) ++fans;
      mark_fan(h, name);
    }
  }

  std::int64_t vertices() const { return vertices_; }
  std::int32_t first() const { return first_; }

 private:
  std::int32_t add_copy(std::int32_t v) {
    work_.source.push_back(v);
    work_.positions.push_back(Vec3(work_.positions[v]));
    if (work_.positions.size() > 0x7fffffff) refuse_soup("more vertices than 32-bit ids can count", v);
    return static_cast<std::int32_t>(work_.positions.size() - 1);
  }

  void count(std::int32_t v) {
    ++vertices_;
    first_ = first_ < 0 ? v : std::min(first_, v);
  }

  // Goes round from the corner h in both directions, until the fan closes or ends.
  void mark_fan(std::int32_t h, std::int32_t name) {
    std::int32_t corner = h;
    do {
      set_name(corner, name);
      corner = work_.twin[WorkFaces::previous(corner)];
    } while (corner >= 0 && corner != h);
    if (corner == h) return;
    corner = h;
    while (work_.twin[corner] >= 0) {
      corner = WorkFaces::next(work_.twin[corner]);
      set_name(corner, name);
    }
  }

  void set_name(std::int32_t corner, std::int32_t name) {
    work_.faces[corner / 3][corner % 3] = name;
    is_named_[corner] = 1;
  }

  WorkFaces& work_;
  std::vector<char> is_named_;  // per corner whether its vertex is final; until then it is that of the input
  std::vector<char> fans_;      // per input vertex the number of fans so far: 0, 1, or 2 for several
  std::int64_t vertices_ = 0;
  std::int32_t first_ = -1;
};

}  // namespace

void cut_vertices(WorkFaces& work, const std::vector<Vec3>& positions, const std::vector<char>& on_cut_edge,
                  DefectLog& log) {
  FanCutter cutter(work, positions);
  cutter.cut(on_cut_edge);
  log.add(DefectKind::nonmanifold_vertices, cutter.vertices(), cutter.first(),
          fmt::format("{} several fans of faces, first vertex {}",
                      counted(cutter.vertices(), "vertex joins", "vertices join"), cutter.first()),
          "cut apart");
}

}  // namespace gvd
