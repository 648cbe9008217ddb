// The surface of a remesh, cut into cells with the vertices that the one-to-one map needs.
//
// The map flattens each cell onto a convex disc and takes borders to borders, vertex by vertex. So cells must be discs,
// bisectors need an inner vertex where they cross an edge of the remesh, and cells at the boundary an anchor, which
// goes to the remesh's vertex. Chords between vertices of one straight side would flatten to nothing, so they are
// split. After each kind of split the borders are traced again. The conditions are those of docs/developer/proofs.md,
// section 7.

#include "map/cut_into_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "base/least.hpp"
#include "base/union_find.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/error.hpp"
#include "mesh/mesh_editor.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

Error unusable(GeneratorId cell, const char* what) {
  return {ErrorCode::no_valid_result, fmt::format("cell {} {}", cell.value(), what), cell.value()};
}

/// The least id that occurs twice, if any does.
template <class Id>
std::optional<Id> find_repeated(std::vector<Id> ids) {
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  return twice == ids.end() ? std::nullopt : std::optional(*twice);
}

class BorderTracer {
 public:
  BorderTracer(const Mesh& mesh, const IdVector<FaceId, GeneratorId>& label, std::size_t cells)
      : mesh_(mesh), label_(label), sizes_(cells), borders_(cells) {}

  OrError<IdVector<GeneratorId, CellBorder>> run() {
    if (auto error = count_faces()) return *std::move(error);
    count_vertices();
    for (const HalfedgeId h : mesh_.halfedges()) {
      if (is_border(h) && borders_[cell(h)].loop.empty()) trace(h);
    }
    for (const GeneratorId g : borders_.ids()) {
      if (const char* const obstacle = find_obstacle(g)) return unusable(g, obstacle);
    }
    return std::move(borders_);
  }

 private:
  struct Size {
    std::int64_t faces = 0, components = 0, border_edges = 0, inner_vertices = 0;
  };

  GeneratorId cell(HalfedgeId h) const { return label_[Mesh::face(h)]; }

  /// The cell beyond the halfedge; invalid beyond the boundary.
  GeneratorId other(HalfedgeId h) const { return mesh_.twin(h).valid() ? cell(mesh_.twin(h)) : GeneratorId(); }
  bool is_border(HalfedgeId h) const { return other(h) != cell(h); }

  /// Returns an error if a face is in no cell.
  std::optional<Error> count_faces() {
    UnionFind connected(label_.size());
    for (const FaceId f : mesh_.faces()) {
      const GeneratorId g = label_[f];
      if (!g.valid() || g.index() >= sizes_.size()) {
        return Error(ErrorCode::no_valid_result, fmt::format("face {} is in no cell", f.value()), f.value());
      }
      ++sizes_[g].faces;
      for (const HalfedgeId h : Mesh::halfedges(f)) {
        sizes_[g].border_edges += is_border(h);
        if (!is_border(h)) connected.unite(f.value(), Mesh::face(mesh_.twin(h)).value());
      }
    }
    for (const FaceId f : mesh_.faces()) sizes_[label_[f]].components += connected.find(f.value()) == f.value();
    return std::nullopt;
  }

  void count_vertices() {
    IdVector<VertexId, char> is_on_border(mesh_.vertex_count(), 0);
    for (const HalfedgeId h : mesh_.halfedges()) {
      if (is_border(h)) is_on_border[mesh_.from(h)] = is_on_border[mesh_.to(h)] = 1;
    }
    for (const VertexId v : mesh_.vertices()) {
      if (!is_on_border[v]) ++sizes_[cell(mesh_.halfedge(v))].inner_vertices;
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
    if (first < loop.size()) std::rotate(loop.begin(), loop.begin() + first, loop.end());
  }

  /// The reason why a cell can't be used; null if it can.
  ///
  /// A connected surface whose boundary is one simple loop is a disc if its Euler characteristic is 1. Each face has
  /// three halfedges, and those of the loop have no twin: Euler's formula gives the number of faces.
  const char* find_obstacle(GeneratorId g) const {
    const Size& size = sizes_[g];
    const CellBorder& border = borders_[g];
    const std::int64_t length = std::ssize(border.loop);
    const std::int64_t faces_of_disc = 2 * size.inner_vertices + length - 2;
    std::vector<VertexId> vertices;
    for (const HalfedgeId h : border.loop) vertices.push_back(mesh_.from(h));
    if (length == 0 || length != size.border_edges || size.components != 1 || size.faces != faces_of_disc ||
        find_repeated(std::move(vertices))) {
      return "is no disc of whole triangles";
    }
    std::vector<GeneratorId> others;
    for (const BorderRun& run : border.runs) others.push_back(run.other);
    if (const auto twice = find_repeated(std::move(others))) {
      return twice->valid() ? "touches a neighbour twice" : "touches the boundary twice";
    }
    return border.runs.size() < 2 ? "has too few neighbours" : nullptr;
  }

  const Mesh& mesh_;
  const IdVector<FaceId, GeneratorId>& label_;
  IdVector<GeneratorId, Size> sizes_;
  IdVector<GeneratorId, CellBorder> borders_;
};

/// A generator on the boundary within this fraction of an edge from a vertex counts as being at the vertex. The value
/// is far above the rounding of positions, and far below a visible distance.
constexpr double kAtVertex = 1e-6;

/// A point on an edge, between its ends.
struct EdgeCut {
  HalfedgeId edge;
  double t = 0.5;
};

class CellCutter {
 public:
  CellCutter(const Mesh& surface, const std::vector<SurfacePoint>& generators, CutMesh cut)
      : surface_(surface), generators_(generators) {
    cells_.cut = std::move(cut);
    cells_.anchors.assign(generators_.size(), {});
  }

  OrError<CellSurface> run() {
    if (auto error = trace()) return *std::move(error);
    for (const auto split : {&CellCutter::split_short_runs, &CellCutter::split_at_anchors, &CellCutter::split_chords}) {
      (this->*split)();
      if (auto error = trace()) return *std::move(error);
    }
    return std::move(cells_);
  }

 private:
  const Mesh& mesh() const { return cells_.cut.mesh; }

  /// Returns an error if a cell is not a disc.
  std::optional<Error> trace() {
    auto traced = trace_cell_borders(mesh(), cells_.cut.label, generators_.size());
    if (Error* const error = std::get_if<Error>(&traced)) return std::move(*error);
    cells_.borders = std::get<IdVector<GeneratorId, CellBorder>>(std::move(traced));
    return std::nullopt;
  }

  VertexId split(HalfedgeId h, double t) {
    const std::array<FaceId, 2> faces{Mesh::face(h), mesh().twin(h).valid() ? Mesh::face(mesh().twin(h)) : FaceId()};
    const Vec3 at = (1 - t) * mesh().position(mesh().from(h)) + t * mesh().position(mesh().to(h));
    const VertexId v = MeshEditor(cells_.cut.mesh).split_edge(h, at);
    for (const FaceId f : faces) {
      if (!f.valid()) continue;
      cells_.cut.parent.push_back(cells_.cut.parent[f]);
      cells_.cut.label.push_back(cells_.cut.label[f]);
    }
    return v;
  }

  /// Edges keep their ids when others are split, halfedges do not.
  void split_edges(const std::vector<EdgeId>& edges) {
    for (const EdgeId e : edges) split(mesh().halfedge(e), 0.5);
  }

  void split_short_runs() {
    std::vector<EdgeId> edges;
    for (const GeneratorId g : cells_.borders.ids()) {
      for (const BorderRun& run : cells_.borders[g].runs) {
        if (run.end == run.begin + 1 && run.other > g) edges.push_back(mesh().edge(cells_.borders[g].loop[run.begin]));
      }
    }
    split_edges(edges);
  }

  /// The place on the boundary of a cell that is nearest to its generator.
  EdgeCut nearest_on_boundary(GeneratorId g) const {
    const CellBorder& border = cells_.borders[g];
    const Vec3 at = position(surface_, generators_[g.index()]);
    Least<EdgeCut> nearest;
    for (std::size_t i = border.runs.back().begin; i < border.runs.back().end; ++i) {
      const HalfedgeId h = border.loop[i];
      const Vec3 &from = mesh().position(mesh().from(h)), along = mesh().position(mesh().to(h)) - from;
      const double t = std::clamp(foot_on_edge(mesh(), h, at), 0.0, 1.0);
      nearest.offer((from + t * along - at).norm(), {h, t});
    }
    return nearest.value;
  }

  /// The ends of the run belong to other cells as well, so they can't be anchors.
  void split_at_anchors() {
    for (const GeneratorId g : cells_.borders.ids()) {
      const CellBorder& border = cells_.borders[g];
      if (!border.at_boundary()) continue;
      const EdgeCut cut = nearest_on_boundary(g);
      const VertexId from = mesh().from(cut.edge), to = mesh().to(cut.edge);
      const BorderRun& run = border.runs.back();
      if (cut.t <= kAtVertex && from != mesh().from(border.loop[run.begin])) {
        cells_.anchors[g] = from;
      } else if (cut.t >= 1 - kAtVertex && to != mesh().to(border.loop[run.end - 1])) {
        cells_.anchors[g] = to;
      } else {
        cells_.anchors[g] = split(cut.edge, away_from_ends(cut.t));
      }
    }
  }

  static double away_from_ends(double t) {
    constexpr double kNearEnd = 0.01;
    if (t <= kAtVertex) return kNearEnd;
    return t >= 1 - kAtVertex ? 1 - kNearEnd : t;
  }

  void split_chords() {
    std::vector<EdgeId> chords;
    for (const GeneratorId g : cells_.borders.ids()) {
      const CellBorder& border = cells_.borders[g];
      if (!border.at_boundary()) continue;
      const std::vector<VertexId> vertices = run_vertices(mesh(), border, border.runs.back());
      const auto anchor = std::find(vertices.begin(), vertices.end(), cells_.anchors[g]);
      collect_chords(g, {vertices.begin(), anchor + 1}, chords);
      collect_chords(g, {anchor, vertices.end()}, chords);
    }
    split_edges(chords);
  }

  /// Appends the edges inside cell g that join two vertices of one side.
  void collect_chords(GeneratorId g, const std::vector<VertexId>& side, std::vector<EdgeId>& chords) const {
    const std::set<VertexId> ends(side.begin(), side.end());
    for (const VertexId v : side) {
      for_each_outgoing(mesh(), v, [&](HalfedgeId h) {
        const HalfedgeId twin = mesh().twin(h);
        if (!twin.valid() || mesh().to(h) < v || !ends.contains(mesh().to(h))) return;
        const auto& label = cells_.cut.label;
        if (label[Mesh::face(h)] == g && label[Mesh::face(twin)] == g) chords.push_back(mesh().edge(h));
      });
    }
  }

  const Mesh& surface_;
  const std::vector<SurfacePoint>& generators_;
  CellSurface cells_;
};

}  // namespace

std::vector<VertexId> run_vertices(const Mesh& mesh, const CellBorder& border, const BorderRun& run) {
  std::vector<VertexId> vertices;
  for (std::size_t i = run.begin; i < run.end; ++i) vertices.push_back(mesh.from(border.loop[i]));
  vertices.push_back(mesh.to(border.loop[run.end - 1]));
  return vertices;
}

OrError<IdVector<GeneratorId, CellBorder>> trace_cell_borders(const Mesh& mesh,
                                                              const IdVector<FaceId, GeneratorId>& label,
                                                              std::size_t cells) {
  return BorderTracer(mesh, label, cells).run();
}

OrError<CellSurface> cut_into_cells(const Mesh& surface, const RemeshResult& result, const Progress& progress) {
  auto cut = try_to_cut_faces(surface, result.diagram, progress);
  if (Error* const error = std::get_if<Error>(&cut)) return std::move(*error);
  return CellCutter(surface, result.generators, std::get<CutMesh>(std::move(cut))).run();
}

}  // namespace gvd
