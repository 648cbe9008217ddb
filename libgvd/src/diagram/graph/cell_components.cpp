// The components of every cell, by union-find over the pieces of the crossed faces.
//
// Vertices far from the bisectors need no look. A vertex of label g, unless it is unsupported, has a neighbour of label
// g that is nearer to g (see NearestLabels). So a chain of uncrossed edges connects it to the vertex of g. That chain
// may be missing only near an unsupported vertex, a crossed edge between two vertices of one cell, or a vertex that
// growth moved. There vertices are unanchored: members of their own, united with their neighbours one by one.
// Source: the paper takes cells to be connected, which rounded distances and growth do not ensure.
// Invariant: a cell is connected exactly if all of its members are in the set of its generator's vertex. The members
// are far fewer than the vertices: one for each generator, unanchored vertex and piece of a crossed face.
#include <algorithm>
#include <map>
#include <span>

#include "base/union_find.hpp"
#include "diagram/graph/connected_tracer.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A member of a set: the vertex of a generator, an unanchored vertex, or a piece of a crossed face.
struct Member {
  GeneratorId generator;
  FaceId face;  ///< of a piece, or one face at an unanchored vertex; invalid for the vertex of a generator
};

class ComponentFinder {
 public:
  ComponentFinder(const WorkingMesh& working, const TracedDiagram& traced)
      : working_(working), mesh_(working.mesh()), traced_(traced), sets_(0), crossed_index_(mesh_.face_count(), -1) {}

  CellComponents find() {
    for (const GeneratorId g : working_.generator_vertices().ids()) add_member(g, FaceId());
    find_unanchored_vertices();
    const auto& arcs = traced_.faces.arcs;
    for (std::size_t begin = 0, end = 0; begin < arcs.size(); begin = end) {
      while (end < arcs.size() && arcs[end].face == arcs[begin].face) ++end;
      add_face(arcs[begin].face, std::span(arcs).subspan(begin, end - begin));
    }
    unite_unanchored_vertices();
    unite_across_edges();
    return {count_components(), island_edges(), island_vertices()};
  }

 private:
  std::int32_t add_member(GeneratorId g, FaceId f) {
    members_.push_back({g, f});
    return sets_.add();
  }

  bool is_uncrossed(HalfedgeId h) const { return traced_.crossings.count(mesh_.edge(h)) == 0; }

  void find_unanchored_vertices() {
    std::vector<VertexId> suspects = traced_.labels.unsupported;
    for (const Crossing& c : traced_.crossings.items()) {
      const HalfedgeId h = mesh_.halfedge(c.edge);
      if (traced_.labels.label[mesh_.from(h)] != traced_.labels.label[mesh_.to(h)]) continue;
      suspects.insert(suspects.end(), {mesh_.from(h), mesh_.to(h)});
    }
    const auto suspect_neighbours = [&](VertexId v) {
      for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId) { suspects.push_back(u); });
    };
    for (const VertexId v : traced_.moved) {
      unanchored_.emplace(v, -1);
      suspect_neighbours(v);
    }
    while (!suspects.empty()) {
      const VertexId v = suspects.back();
      suspects.pop_back();
      if (is_anchored(v) || !unanchored_.emplace(v, -1).second) continue;
      suspect_neighbours(v);  // v may have been the anchor of a neighbour
    }
    for (auto& [v, member] : unanchored_) member = add_member(traced_.labels.label[v], Mesh::face(mesh_.halfedge(v)));
  }

  /// Whether v is its generator's vertex, or an uncrossed edge connects it to an anchored vertex of its cell that is
  /// nearer to the generator.
  bool is_anchored(VertexId v) const {
    const NearestLabels& labels = traced_.labels;
    if (!labels.label[v].valid() || working_.vertex(labels.label[v]) == v) return true;
    bool anchored = false;
    for_each_neighbour(mesh_, v, [&](VertexId u, HalfedgeId h) {
      anchored = anchored || (labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v] &&
                              is_uncrossed(h) && !unanchored_.contains(u));
    });
    return anchored;
  }

  void add_face(FaceId f, std::span<const FaceArc> arcs) {
    boundary_crossings(mesh_, traced_.crossings, f, boundary_);
    add_pieces(f, arcs);
    crossed_index_[f] = static_cast<std::int32_t>(first_interval_.size() / 3);
    // A halfedge begins in the interval after the last crossing before it; every crossing on it begins another one.
    std::int32_t current = member_of_interval_.back();
    std::size_t next = 0;
    for (int corner = 0; corner < 3; ++corner) {
      sets_.unite(current, member_of(mesh_.vertices(f)[corner]));
      first_interval_.push_back(static_cast<std::int32_t>(interval_pieces_.size()));
      interval_pieces_.push_back(current);
      for (; next < boundary_.size() && boundary_[next].corner == corner; ++next) {
        interval_pieces_.push_back(current = member_of_interval_[next]);
      }
    }
  }

  /// Adds a member for every piece of f, whose crossings are in boundary_; fills in member_of_interval_.
  void add_pieces(FaceId f, std::span<const FaceArc> arcs) {
    member_of_interval_.assign(boundary_.size(), -1);
    bool distinct = true;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) distinct = distinct && boundary_[i].next != boundary_[j].next;
    }
    if (distinct) {  // every interval has a piece of its own
      for (std::size_t i = 0; i < boundary_.size(); ++i) member_of_interval_[i] = add_member(boundary_[i].next, f);
      return;
    }
    trace_pieces(boundary_, arcs, traced_.faces, pieces_);
    const auto first = static_cast<std::int32_t>(members_.size());
    for (const WorkingPiece& piece : pieces_.pieces) add_member(piece.generator, f);
    for (std::size_t i = 0; i < boundary_.size(); ++i) member_of_interval_[i] = first + pieces_.piece_of_interval[i];
  }

  std::int32_t member_of(VertexId v) const {
    const auto it = unanchored_.find(v);
    return it == unanchored_.end() ? traced_.labels.label[v].value() : it->second;
  }

  void unite_unanchored_vertices() {
    for (const auto& [v, member] : unanchored_) {
      for_each_neighbour(mesh_, v, [&, v = v, member = member](VertexId u, HalfedgeId h) {
        if (is_uncrossed(h) && traced_.labels.label[u] == traced_.labels.label[v]) sets_.unite(member, member_of(u));
      });
    }
  }

  void unite_across_edges() {
    const auto& items = traced_.crossings.items();
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0 && items[i - 1].edge == items[i].edge) continue;
      const HalfedgeId h = mesh_.halfedge(items[i].edge), twin = mesh_.twin(h);
      if (!twin.valid()) continue;
      const std::int32_t last = traced_.crossings.count(items[i].edge);
      for (std::int32_t k = 0; k <= last; ++k) sets_.unite(piece_along(h, k), piece_along(twin, last - k));
    }
  }

  /// The piece along label interval `interval` of halfedge h of a crossed face, counted along h.
  std::int32_t piece_along(HalfedgeId h, std::int32_t interval) const {
    return interval_pieces_[first_interval_[3 * crossed_index_[Mesh::face(h)] + Mesh::corner(h)] + interval];
  }

  IdVector<GeneratorId, std::int32_t> count_components() {
    IdVector<GeneratorId, std::int32_t> count(working_.generator_vertices().size(), 0);
    for (int i = 0; i < std::ssize(members_); ++i) count[members_[i].generator] += sets_.find(i) == i;
    return count;
  }

  std::vector<EdgeId> island_edges() {
    std::vector<EdgeId> edges;
    for (int i = 0; i < std::ssize(members_); ++i) {
      // The smallest member represents its set, and the vertices of the generators come first.
      if (sets_.find(i) == members_[i].generator.value()) continue;
      for (const HalfedgeId h : Mesh::halfedges(members_[i].face)) edges.push_back(mesh_.edge(h));
    }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
  }

  std::vector<VertexId> island_vertices() {
    std::vector<VertexId> vertices;
    for (const auto& [v, member] : unanchored_) {
      if (sets_.find(member) != traced_.labels.label[v].value()) vertices.push_back(v);
    }
    return vertices;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  UnionFind sets_;  // of members; 0 .. generators - 1 are the vertices of the generators
  std::vector<Member> members_;
  std::map<VertexId, std::int32_t> unanchored_;   // and their members
  IdVector<FaceId, std::int32_t> crossed_index_;  // number of the face among the crossed ones, or -1
  std::vector<std::int32_t> first_interval_;      // three for every crossed face: where its halfedge begins in
  std::vector<std::int32_t> interval_pieces_;     // the piece along each label interval
  std::vector<BoundaryCrossing> boundary_;        // of the current face
  std::vector<std::int32_t> member_of_interval_;  // of the current face: by boundary crossing before the interval
  WorkingPieces pieces_;                          // of the current face, if they had to be traced
};

}  // namespace

CellComponents find_cell_components(const WorkingMesh& working, const TracedDiagram& traced) {
  return ComponentFinder(working, traced).find();
}

}  // namespace gvd
