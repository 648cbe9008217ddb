#include "diagram/cell_topology.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <tuple>

#include "diagram/face_pieces.hpp"

namespace gvd {

CellParts::CellParts(const WorkingMesh& working, const TracedDiagram& traced)
    : working_(working),
      mesh_(working.mesh()),
      traced_(traced),
      sets_(static_cast<std::size_t>(mesh_.face_count())),
      part_label_(static_cast<std::size_t>(mesh_.face_count())),
      cut_index_(static_cast<std::size_t>(mesh_.face_count()), kWhole) {
  std::size_t arc = 0;
  const auto& arcs = traced.faces.arcs;
  for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
    const FaceId f(i);
    const std::size_t begin = arc;
    while (arc < arcs.size() && arcs[arc].face == f) ++arc;
    if (begin < arc) {
      cut(f, begin, arc);
    } else {
      part_label_[f.index()] = traced.labels.label[mesh_.vertices(f)[0]];
    }
  }
  for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) join_across(EdgeId(i));
}

void CellParts::cut(FaceId f, std::size_t first_arc, std::size_t last_arc) {
  const auto boundary = boundary_crossings(mesh_, traced_.crossings, f);
  const auto arcs = std::span(traced_.faces.arcs).subspan(first_arc, last_arc - first_arc);
  const auto base = static_cast<std::int32_t>(run_parts_.size());
  cut_index_[f] = base / 3;
  run_parts_.resize(run_parts_.size() + 3);
  std::vector<std::int32_t> part_of_run(boundary.size());
  for (const WorkingPiece& piece : trace_pieces(boundary, arcs, traced_.faces.branches)) {
    const std::int32_t id = sets_.add();
    part_label_.push_back(piece.generator);
    part_face_.push_back(f);
    for (const int run : piece.runs) part_of_run[static_cast<std::size_t>(run)] = id;
  }
  // A halfedge begins in the run of the last crossing before it; every crossing on it begins another.
  std::int32_t current = part_of_run.back();
  std::size_t next = 0;
  for (int corner = 0; corner < 3; ++corner) {
    auto& parts = run_parts_[static_cast<std::size_t>(base + corner)];
    parts.push_back(current);
    for (; next < boundary.size() && boundary[next].corner == corner; ++next) parts.push_back(current = part_of_run[next]);
  }
}

std::int32_t CellParts::part(HalfedgeId h, std::int32_t run) const {
  const FaceId f = Mesh::face(h);
  if (cut_index_[f] == kWhole) return f.value();
  return run_parts_[static_cast<std::size_t>(3 * cut_index_[f] + Mesh::corner(h))][static_cast<std::size_t>(run)];
}

void CellParts::join_across(EdgeId e) {
  const HalfedgeId h = mesh_.halfedge(e), twin = mesh_.twin(h);
  if (!twin.valid()) return;
  const std::int32_t last = traced_.crossings.count(e);
  for (std::int32_t run = 0; run <= last; ++run) sets_.unite(part(h, run), part(twin, last - run));
}

IdVector<GeneratorId, std::int32_t> CellParts::count_components() {
  IdVector<GeneratorId, std::int32_t> count(working_.generator_vertices().size(), 0);
  for (std::size_t i = 0; i < part_label_.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    if (part_label_[i].valid() && sets_.find(part) == part) ++count[part_label_[i]];
  }
  return count;
}

std::vector<EdgeId> CellParts::island_edges() {
  std::vector<char> is_home(part_label_.size(), 0);  // of the sets that hold their generator's vertex
  for (const VertexId v : working_.generator_vertices()) {
    const HalfedgeId h = mesh_.halfedge(v);
    is_home[static_cast<std::size_t>(sets_.find(part(h, 0)))] = 1;
  }
  std::vector<EdgeId> edges;
  for (std::size_t i = 0; i < part_label_.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    if (!part_label_[i].valid() || is_home[static_cast<std::size_t>(sets_.find(part))]) continue;
    const auto faces = static_cast<std::size_t>(mesh_.face_count());
    const FaceId f = i < faces ? FaceId(part) : part_face_[i - faces];
    for (int corner = 0; corner < 3; ++corner) edges.push_back(mesh_.edge(Mesh::halfedge(f, corner)));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

namespace {

/// Joins the sides of arcs and the runs of boundary edges that follow each other round a cell.
class LoopCounter {
 public:
  LoopCounter(const WorkingMesh& working, const TracedDiagram& traced)
      : mesh_(working.mesh()), traced_(traced), sets_(0), generators_(working.generator_vertices().size()) {}

  IdVector<GeneratorId, std::int32_t> count() {
    for (const FaceArc& arc : traced_.faces.arcs) add_sides(arc);
    for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
      if (mesh_.is_boundary(EdgeId(i))) add_boundary_edge(EdgeId(i));
    }
    IdVector<GeneratorId, std::int32_t> loops(generators_, 0);
    for (std::size_t i = 0; i < label_.size(); ++i) {
      if (label_[i].valid() && sets_.find(static_cast<std::int32_t>(i)) == static_cast<std::int32_t>(i)) ++loops[label_[i]];
    }
    return loops;
  }

 private:
  std::int32_t add(GeneratorId g) {
    label_.push_back(g);
    return sets_.add();
  }

  // Round an end of an arc each cell has one sector where it meets the end in one place only. A cell that meets a branch
  // point in two sectors is told apart by its neighbour: a sector lies between the arc that it leaves on its right and the
  // next arc, counter-clockwise; branch points of the faces have three different cells, so (end, cell) names the sector.
  void add_sides(const FaceArc& arc) {
    for (const GeneratorId g : {arc.left, arc.right}) {
      const std::int32_t side = add(g);
      for (const ArcEnd& end : {arc.begin, arc.end}) {
        meet({end.crossing.valid() ? 0 : 1, end.crossing.valid() ? end.crossing.value() : end.branch.value(), g.value()}, side);
      }
    }
  }

  void add_boundary_edge(EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    GeneratorId g = traced_.labels.label[mesh_.from(h)];
    std::int32_t run = add(g);
    meet({2, mesh_.from(h).value(), 0}, run);
    for (std::int32_t k = 0; k < traced_.crossings.count(e); ++k) {
      const CrossingId id(traced_.crossings.first(e).value() + k);
      meet({0, id.value(), g.value()}, run);
      g = traced_.crossings[id].after;
      run = add(g);
      meet({0, id.value(), g.value()}, run);
    }
    meet({2, mesh_.to(h).value(), 0}, run);
  }

  void meet(const std::tuple<int, std::int32_t, std::int32_t>& place, std::int32_t part) {
    const auto [it, fresh] = first_at_.try_emplace(place, part);
    if (!fresh) sets_.unite(it->second, part);
  }

  const Mesh& mesh_;
  const TracedDiagram& traced_;
  UnionFind sets_;
  std::vector<GeneratorId> label_;
  std::map<std::tuple<int, std::int32_t, std::int32_t>, std::int32_t> first_at_;
  std::size_t generators_;
};

}  // namespace

IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced) {
  return LoopCounter(working, traced).count();
}

}  // namespace gvd
