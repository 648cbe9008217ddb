#include "diagram/graph/cell_components.hpp"

#include <algorithm>

#include "mesh/vertex_ring.hpp"

namespace gvd {

CellComponents::CellComponents(const WorkingMesh& working, const TracedDiagram& traced)
    : working_(working),
      mesh_(working.mesh()),
      traced_(traced),
      sets_(0),
      cut_index_(static_cast<std::size_t>(mesh_.face_count()), -1) {
  for (std::size_t g = 0; g < working.generator_vertices().size(); ++g) {
    add_part(GeneratorId(static_cast<std::int64_t>(g)), FaceId());
  }
  find_loose_vertices();
  const auto& arcs = traced.faces.arcs;
  for (std::size_t begin = 0, end = 0; begin < arcs.size(); begin = end) {
    while (end < arcs.size() && arcs[end].face == arcs[begin].face) ++end;
    cut(arcs[begin].face, std::span(arcs).subspan(begin, end - begin));
  }
  join_loose_vertices();
  join_across_edges();
}

std::int32_t CellComponents::add_part(GeneratorId g, FaceId f) {
  parts_.push_back({g, f});
  return sets_.add();
}

void CellComponents::find_loose_vertices() {
  std::vector<VertexId> doubtful = traced_.labels.unsupported;
  const auto& items = traced_.crossings.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    const HalfedgeId h = mesh_.halfedge(items[i].edge);
    if (traced_.labels.label[mesh_.from(h)] != traced_.labels.label[mesh_.to(h)]) continue;
    doubtful.insert(doubtful.end(), {mesh_.from(h), mesh_.to(h)});
  }
  const auto doubt_neighbours = [&](VertexId v) {
    for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId) { doubtful.push_back(u); });
  };
  for (const VertexId v : traced_.moved) {
    loose_.emplace(v, -1);
    doubt_neighbours(v);
  }
  while (!doubtful.empty()) {
    const VertexId v = doubtful.back();
    doubtful.pop_back();
    if (is_anchored(v) || !loose_.emplace(v, -1).second) continue;
    doubt_neighbours(v);  // they may have hung on v alone
  }
  for (auto& [v, part] : loose_) part = add_part(traced_.labels.label[v], Mesh::face(mesh_.halfedge(v)));
}

/// An uncut edge joins v to a vertex of its cell that is nearer to the generator, and is not loose itself.
bool CellComponents::is_anchored(VertexId v) const {
  const NearestLabels& labels = traced_.labels;
  if (!labels.label[v].valid() || working_.vertex(labels.label[v]) == v) return true;
  bool anchored = false;
  for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId h) {
    anchored = anchored || (labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v] &&
                            traced_.crossings.count(mesh_.edge(h)) == 0 && !loose_.contains(u));
  });
  return anchored;
}

void CellComponents::cut(FaceId f, std::span<const FaceArc> arcs) {
  boundary_crossings(mesh_, traced_.crossings, f, boundary_);
  number_pieces(f, arcs);
  cut_index_[f] = static_cast<std::int32_t>(first_run_.size() / 3);
  // A halfedge begins in the run of the last crossing before it; every crossing on it begins another.
  std::int32_t current = piece_of_interval_.back();
  std::size_t next = 0;
  for (int corner = 0; corner < 3; ++corner) {
    sets_.unite(current, part_of(mesh_.vertices(f)[static_cast<std::size_t>(corner)]));
    first_run_.push_back(static_cast<std::int32_t>(run_pieces_.size()));
    run_pieces_.push_back(current);
    for (; next < boundary_.size() && boundary_[next].corner == corner; ++next) {
      run_pieces_.push_back(current = piece_of_interval_[next]);
    }
  }
}

void CellComponents::number_pieces(FaceId f, std::span<const FaceArc> arcs) {
  piece_of_interval_.assign(boundary_.size(), -1);
  bool distinct = true;
  for (std::size_t i = 0; i < boundary_.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) distinct = distinct && boundary_[i].next != boundary_[j].next;
  }
  if (distinct) {  // every run has a piece of its own: nothing to trace
    for (std::size_t i = 0; i < boundary_.size(); ++i) piece_of_interval_[i] = add_part(boundary_[i].next, f);
    return;
  }
  trace_pieces(boundary_, arcs, traced_.faces, pieces_);
  const auto first = static_cast<std::int32_t>(parts_.size());
  for (const WorkingPiece& piece : pieces_.pieces) add_part(piece.generator, f);
  for (std::size_t i = 0; i < boundary_.size(); ++i) piece_of_interval_[i] = first + pieces_.piece_of_interval[i];
}

std::int32_t CellComponents::part_of(VertexId v) const {
  const auto it = loose_.find(v);
  return it == loose_.end() ? traced_.labels.label[v].value() : it->second;
}

void CellComponents::join_loose_vertices() {
  for (const auto& [v, part] : loose_) {
    for_each_neighbour(mesh_, v, [&, v = v, part = part](VertexId u, HalfedgeId h) {
      const bool uncut = traced_.crossings.count(mesh_.edge(h)) == 0;
      if (uncut && traced_.labels.label[u] == traced_.labels.label[v]) sets_.unite(part, part_of(u));
    });
  }
}

void CellComponents::join_across_edges() {
  const auto& items = traced_.crossings.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0 && items[i - 1].edge == items[i].edge) continue;
    const HalfedgeId h = mesh_.halfedge(items[i].edge), twin = mesh_.twin(h);
    if (!twin.valid()) continue;
    const std::int32_t last = traced_.crossings.count(items[i].edge);
    for (std::int32_t run = 0; run <= last; ++run) sets_.unite(piece(h, run), piece(twin, last - run));
  }
}

std::int32_t CellComponents::piece(HalfedgeId h, std::int32_t run) const {
  const auto place = static_cast<std::size_t>(3 * cut_index_[Mesh::face(h)] + Mesh::corner(h));
  return run_pieces_[static_cast<std::size_t>(first_run_[place] + run)];
}

IdVector<GeneratorId, std::int32_t> CellComponents::count_components() {
  IdVector<GeneratorId, std::int32_t> count(working_.generator_vertices().size(), 0);
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const auto part = static_cast<std::int32_t>(i);
    if (sets_.find(part) == part) ++count[parts_[i].generator];
  }
  return count;
}

std::vector<EdgeId> CellComponents::island_edges() {
  std::vector<EdgeId> edges;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    // The smallest member stands for a set, and the homes come first.
    if (sets_.find(static_cast<std::int32_t>(i)) == parts_[i].generator.value()) continue;
    for (int corner = 0; corner < 3; ++corner) edges.push_back(mesh_.edge(Mesh::halfedge(parts_[i].face, corner)));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

std::vector<VertexId> CellComponents::island_vertices() {
  std::vector<VertexId> vertices;
  for (const auto& [v, part] : loose_) {
    if (sets_.find(part) != traced_.labels.label[v].value()) vertices.push_back(v);
  }
  return vertices;
}

}  // namespace gvd
