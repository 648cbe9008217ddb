#include "map/cell_borders.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gvd/error.hpp"

namespace gvd {
namespace {

[[noreturn]] void refuse(GeneratorId cell, const char* what) {
  throw Error(ErrorCode::no_valid_result, fmt::format("cell {} {}", cell.value(), what), cell.value());
}

class BorderTracer {
 public:
  BorderTracer(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t cells)
      : mesh_(mesh), label_(label), sizes_(cells), borders_(cells), is_reached_(label.size(), 0) {}

  IdVector<GeneratorId, CellBorder> run() {
    count_faces();
    count_vertices();
    for (std::int32_t i = 0; i < mesh_.halfedge_count(); ++i) {
      const HalfedgeId h(i);
      if (is_border(h) && borders_[cell(h)].loop.empty()) trace(h);
    }
    for (std::size_t i = 0; i < borders_.size(); ++i) check(GeneratorId(i));
    return std::move(borders_);
  }

 private:
  struct Size {
    std::int64_t faces = 0, border_edges = 0, inner_vertices = 0, reached_faces = 0;
  };

  GeneratorId cell(HalfedgeId h) const { return label_[Mesh::face(h)]; }

  /// The cell beyond the halfedge; invalid beyond the boundary.
  GeneratorId other(HalfedgeId h) const { return mesh_.twin(h).valid() ? cell(mesh_.twin(h)) : GeneratorId(); }
  bool is_border(HalfedgeId h) const { return other(h) != cell(h); }

  void count_faces() {
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const GeneratorId g = label_[FaceId(i)];
      if (!g.valid() || g.index() >= sizes_.size()) {
        throw Error(ErrorCode::no_valid_result, fmt::format("face {} is in no cell", i), i);
      }
      ++sizes_[g].faces;
      for (int corner = 0; corner < 3; ++corner) sizes_[g].border_edges += is_border(Mesh::halfedge(FaceId(i), corner));
    }
  }

  void count_vertices() {
    IdVector<VertexId, char> is_on_border(static_cast<std::size_t>(mesh_.vertex_count()), 0);
    for (std::int32_t i = 0; i < mesh_.halfedge_count(); ++i) {
      if (is_border(HalfedgeId(i))) is_on_border[mesh_.from(HalfedgeId(i))] = is_on_border[mesh_.to(HalfedgeId(i))] = 1;
    }
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      if (!is_on_border[VertexId(i)]) ++sizes_[cell(mesh_.halfedge(VertexId(i)))].inner_vertices;
    }
  }

  HalfedgeId next_on_border(HalfedgeId h) const {
    HalfedgeId next = Mesh::next(h);
    while (!is_border(next)) next = Mesh::next(mesh_.twin(next));
    return next;
  }

  void trace(HalfedgeId start) {
    CellBorder& border = borders_[cell(start)];
    HalfedgeId h = start;
    do {
      border.loop.push_back(h);
      h = next_on_border(h);
    } while (h != start);
    rotate_to_run(border.loop);
    for (std::size_t i = 0; i < border.loop.size(); ++i) {
      const GeneratorId beyond = other(border.loop[i]);
      if (i == 0 || beyond != border.runs.back().other) border.runs.push_back({beyond, i, i});
      ++border.runs.back().end;
    }
    flood(start);
  }

  /// Lets the loop begin where a run begins: behind the one along the boundary, if there is one.
  void rotate_to_run(std::vector<HalfedgeId>& loop) const {
    const auto begins_run = [&](std::size_t i) {
      return other(loop[i]) != other(loop[(i + loop.size() - 1) % loop.size()]);
    };
    std::size_t first = loop.size();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (!begins_run(i)) continue;
      if (first == loop.size()) first = i;
      if (!other(loop[(i + loop.size() - 1) % loop.size()]).valid()) first = i;
    }
    if (first < loop.size()) std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
  }

  /// Counts the faces of the cell that are connected with h's.
  void flood(HalfedgeId h) {
    std::vector<FaceId> stack{Mesh::face(h)};
    is_reached_[stack.back()] = 1;
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      ++sizes_[label_[f]].reached_faces;
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId side = Mesh::halfedge(f, corner);
        if (is_border(side) || is_reached_[Mesh::face(mesh_.twin(side))]) continue;
        is_reached_[Mesh::face(mesh_.twin(side))] = 1;
        stack.push_back(Mesh::face(mesh_.twin(side)));
      }
    }
  }

  /// A connected surface whose boundary is one simple loop is a disc if its Euler characteristic is 1.
  void check(GeneratorId g) const {
    const Size& size = sizes_[g];
    const CellBorder& border = borders_[g];
    const auto length = static_cast<std::int64_t>(border.loop.size());
    const std::int64_t twice_euler = 2 * (size.inner_vertices + length + size.faces) - (3 * size.faces + length);
    if (length == 0 || length != size.border_edges || size.reached_faces != size.faces || twice_euler != 2 ||
        has_repeated_vertex(border)) {
      refuse(g, "is not a disc");
    }
    std::vector<GeneratorId> others;
    for (const BorderRun& run : border.runs) others.push_back(run.other);
    std::sort(others.begin(), others.end());
    const auto twice = std::adjacent_find(others.begin(), others.end());
    if (twice != others.end()) refuse(g, twice->valid() ? "touches a neighbour twice" : "touches the boundary twice");
    if (others.size() < 2) refuse(g, "has too few neighbours");
  }

  bool has_repeated_vertex(const CellBorder& border) const {
    std::vector<VertexId> vertices;
    for (const HalfedgeId h : border.loop) vertices.push_back(mesh_.from(h));
    std::sort(vertices.begin(), vertices.end());
    return std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end();
  }

  const Mesh& mesh_;
  const IdVector<FaceId, GeneratorId>& label_;
  IdVector<GeneratorId, Size> sizes_;
  IdVector<GeneratorId, CellBorder> borders_;
  IdVector<FaceId, char> is_reached_;
};

}  // namespace

std::vector<VertexId> run_vertices(const Mesh& mesh, const CellBorder& border, const BorderRun& run) {
  std::vector<VertexId> vertices;
  for (std::size_t i = run.begin; i < run.end; ++i) vertices.push_back(mesh.from(border.loop[i]));
  vertices.push_back(mesh.to(border.loop[run.end - 1]));
  return vertices;
}

IdVector<GeneratorId, CellBorder> trace_cell_borders(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label,
                                                     std::size_t cells) {
  return BorderTracer(mesh, label, cells).run();
}

}  // namespace gvd
