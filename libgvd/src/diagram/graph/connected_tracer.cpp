// The rounds that connect every cell, around any tracer, and the components of cells that they look at.
//
// The edges are crossed and the faces closed; then every piece of a cell has to be connected to the cell's generator.
// Around a piece that is not, growth is disabled, vertices take the label of a neighbour, edges are crossed at most
// once, and the faces are closed again. After a fixed number of rounds all edges are crossed at most once, between
// labels that edges join to their generators: such cells are connected by construction.
//
// Components come from union-find over the pieces of the crossed faces. Vertices far from the bisectors need no look. A
// vertex of label g, unless it is unsupported, has a neighbour of label g that is nearer to g (see NearestLabels). So a
// chain of uncrossed edges connects it to the vertex of g. That chain may be missing only near an unsupported vertex, a
// crossed edge between two vertices of one cell, or a vertex that growth moved. There vertices are unanchored: members
// of their own, united with their neighbours one by one.
// Source: the paper does not treat this; see docs/developer/algorithm.md.
// Invariant: a cell is connected exactly if all of its members are in the set of its generator's vertex. The members
// are far fewer than the vertices: one for each generator, unanchored vertex and piece of a crossed face.
#include "diagram/graph/connected_tracer.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "base/union_find.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "gvd/diagram_steps.hpp"
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

  /// Whether v is a vertex of its generator, of which a curve has several. Or else whether an uncrossed edge connects
  /// it to an anchored vertex of its cell that is nearer to the generator.
  bool is_anchored(VertexId v) const {
    const NearestLabels& labels = traced_.labels;
    if (!labels.label[v].valid() || working_.generator(v) == labels.label[v]) return true;
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

/// Rounds of local repair before the last resort; the meshes of docs/developer/performance.md take one or two.
constexpr int kMaxRounds = 12;

/// The label intervals inside of edges, in groups that common faces connect. An interval is known by the index of the
/// crossing at its end.
class IntervalGroups {
 public:
  IntervalGroups(const Mesh& mesh, const NearestLabels& labels, const Crossings& crossings)
      : mesh_(mesh), labels_(labels), crossings_(crossings), items_(crossings.items()), groups_(items_.size()) {
    std::vector<FaceId> faces;
    for (int i = 1; i < std::ssize(items_); ++i) {
      if (!is_interval(i)) continue;
      const HalfedgeId h = mesh_.halfedge(items_[i].edge), twin = mesh_.twin(h);
      faces.push_back(Mesh::face(h));
      if (twin.valid()) faces.push_back(Mesh::face(twin));
    }
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    for (const FaceId f : faces) join_in_face(f);
  }

  /// Whether interval i exists, and no common faces connect it to a corner.
  bool is_disconnected(std::int32_t i) { return is_interval(i) && groups_.find(i) != kCorners; }

 private:
  /// Represents all corners: no interval has index 0.
  static constexpr std::int32_t kCorners = 0;

  /// Whether crossings i - 1 and i bound an interval.
  bool is_interval(std::int32_t i) const { return items_[i - 1].edge == items_[i].edge; }

  void join_in_face(FaceId f) {
    in_face_.clear();
    for (const VertexId v : mesh_.vertices(f)) in_face_.emplace_back(labels_.label[v], kCorners);
    for (int corner = 0; corner < 3; ++corner) {
      const EdgeId e = mesh_.edge(Mesh::halfedge(f, corner));
      if (!crossings_.first(e).valid()) continue;
      for (int k = crossings_.first(e).value() + 1; k < std::ssize(items_) && items_[k].edge == e; ++k) {
        in_face_.emplace_back(items_[k].before, k);
      }
    }
    std::sort(in_face_.begin(), in_face_.end());
    for (std::size_t i = 1; i < in_face_.size(); ++i) {
      if (in_face_[i - 1].first == in_face_[i].first) groups_.unite(in_face_[i - 1].second, in_face_[i].second);
    }
  }

  const Mesh& mesh_;
  const NearestLabels& labels_;
  const Crossings& crossings_;
  const std::vector<Crossing>& items_;
  UnionFind groups_;                                           // of intervals, and kCorners
  std::vector<std::pair<GeneratorId, std::int32_t>> in_face_;  // labels and intervals of the current face
};

class ConnectedTracer {
 public:
  ConnectedTracer(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer)
      : working_(working), mesh_(working.mesh()), tracer_(tracer), labels_(std::move(labels)) {}

  TracedDiagram run() {
    crossings_ = tracer_.cross_edges(labels_);
    cross_at_most_once(find_disconnected_intervals(mesh_, labels_, crossings_));
    while (true) {
      TracedDiagram traced{labels_, crossings_};
      tracer_.close_faces(traced);
      const CellComponents components = find_cell_components(working_, traced);
      traced.cell_components = components.count;
      traced.counts.relabelled_vertices = relabelled_;
      if (components.island_edges.empty()) {
        traced.before_relabelling = std::move(before_relabelling_);
        return traced;
      }
      if (++rounds_ > kMaxRounds) {
        connect_everywhere();
      } else {
        connect(components.island_edges, vertices_to_relabel(components, traced));
      }
    }
  }

 private:
  /// Crosses these edges at most once, between the present labels of their ends; those of earlier calls again.
  void cross_at_most_once(const std::vector<EdgeId>& edges) {
    if (edges.empty()) return;
    std::vector<EdgeId> all;
    std::set_union(edges.begin(), edges.end(), crossed_once_.begin(), crossed_once_.end(), std::back_inserter(all));
    crossed_once_ = std::move(all);
    tracer_.cross_at_most_once(crossed_once_, labels_, crossings_);
  }

  /// The vertices of islands, without those that are there because growth moved them.
  std::vector<VertexId> vertices_to_relabel(const CellComponents& components, const TracedDiagram& traced) const {
    std::vector<VertexId> relabelled = components.island_vertices;
    std::erase_if(relabelled, [&](VertexId v) { return labels_.label[v] != traced.labels.label[v]; });
    return relabelled;
  }

  /// Prepares the next round: no growth around the islands, new labels for their vertices, one crossing at most on
  /// their edges.
  void connect(const std::vector<EdgeId>& islands, const std::vector<VertexId>& relabelled) {
    tracer_.disable_growth(islands);
    relabelled_ += std::ssize(relabelled);
    if (!relabelled.empty()) keep_labels();
    relabel_from_neighbours(working_, relabelled, labels_);
    std::set<EdgeId> edges(islands.begin(), islands.end());
    for (const VertexId v : relabelled) {
      for_each_neighbour(mesh_, v, [&](VertexId, HalfedgeId h) { edges.insert(mesh_.edge(h)); });
    }
    cross_at_most_once({edges.begin(), edges.end()});
  }

  /// The last resort, whose cells are connected by construction.
  void connect_everywhere() {
    const std::vector<EdgeId> all(mesh_.edges().begin(), mesh_.edges().end());
    tracer_.disable_growth(all);
    keep_labels();
    relabelled_ += relabel_unsupported(working_, labels_);
    cross_at_most_once(all);
  }

  void keep_labels() {
    if (!before_relabelling_) before_relabelling_ = labels_;
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  DiagramTracer& tracer_;
  NearestLabels labels_;
  std::optional<NearestLabels> before_relabelling_;
  Crossings crossings_;
  std::vector<EdgeId> crossed_once_;  // ascending
  std::int64_t relabelled_ = 0;
  int rounds_ = 0;
};

}  // namespace

CellComponents find_cell_components(const WorkingMesh& working, const TracedDiagram& traced) {
  return ComponentFinder(working, traced).find();
}

std::vector<EdgeId> find_disconnected_intervals(const Mesh& mesh, const NearestLabels& labels,
                                                const Crossings& crossings) {
  IntervalGroups groups(mesh, labels, crossings);
  const auto& items = crossings.items();
  std::vector<EdgeId> edges;
  for (int i = 1; i < std::ssize(items); ++i) {
    if (!groups.is_disconnected(i)) continue;
    if (edges.empty() || edges.back() != items[i].edge) edges.push_back(items[i].edge);
  }
  return edges;
}

TracedDiagram trace_connected(const WorkingMesh& working, NearestLabels labels, DiagramTracer& tracer,
                              const Progress& progress) {
  report_progress(progress, steps::kBisectors, 0);
  return ConnectedTracer(working, std::move(labels), tracer).run();
}

}  // namespace gvd
