// The connected components of every cell, by union-find over the pieces of the crossed faces.
//
// Vertices far from the bisectors need not be examined. A vertex of label g, unless it is unsupported, has a neighbour
// of label g that is nearer to g (see NearestLabels). A chain of uncrossed edges therefore connects it to the vertex of
// g. That chain may be missing only near an unsupported vertex, a crossed edge between two vertices of one cell, or a
// vertex that growth moved. Vertices there are unanchored: each of them is a member of its own, which is united with
// its neighbours one by one.
// Source: the paper does not treat this; see docs/developer/algorithm.md.
// Invariant: a cell is connected exactly if all of its members are in the set of its generator's vertex. There are far
// fewer members than vertices: one for each generator, unanchored vertex and piece of a crossed face.
#include "diagram/graph/cell_components.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "base/sort_unique.hpp"
#include "base/union_find.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

constexpr std::int32_t kNoMember = -1;

/// A member of a set: the vertex of a generator, an unanchored vertex, or a piece of a crossed face.
struct Member {
  GeneratorId generator;
  FaceId face;  ///< face of a piece, or some face at an unanchored vertex; invalid for the vertex of a generator
};

/// Members in sets, each of which is a connected part of a cell. The smallest member represents its set. The vertices
/// of the generators come first, so that member g is the vertex of generator g.
struct MemberSets {
  std::vector<Member> members{};
  UnionFind sets{0};

  std::int32_t add(GeneratorId g, FaceId f) {
    members.push_back({g, f});
    return sets.add();
  }
};

/// The vertices from which it is not certain that a chain of uncrossed edges leads to the vertex of their generator.
std::map<VertexId, std::int32_t> find_unanchored_vertices(const WorkingMesh& working, const TracedDiagram& traced) {
  const Mesh& mesh = working.mesh();
  const NearestLabels& labels = traced.labels;
  std::map<VertexId, std::int32_t> unanchored;
  // Whether v is a vertex of its generator (a curve has several), or an uncrossed edge connects it to an anchored
  // vertex of its cell that is nearer to the generator.
  const auto is_anchored = [&](VertexId v) {
    if (!labels.label[v].valid() || working.generator(v) == labels.label[v]) return true;
    bool anchored = false;
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId h) {
      anchored = anchored || (labels.label[u] == labels.label[v] && labels.distance[u] < labels.distance[v] &&
                              traced.crossings.count(mesh.edge(h)) == 0 && !unanchored.contains(u));
    });
    return anchored;
  };
  std::vector<VertexId> suspects = labels.unsupported;
  const auto suspect_neighbours = [&](VertexId v) {
    for_each_neighbour(mesh, v, [&](VertexId u, HalfedgeId) { suspects.push_back(u); });
  };
  for (const Crossing& c : traced.crossings.items()) {
    const HalfedgeId h = mesh.halfedge(c.edge);
    if (labels.label[mesh.from(h)] != labels.label[mesh.to(h)]) continue;
    suspects.insert(suspects.end(), {mesh.from(h), mesh.to(h)});
  }
  for (const VertexId v : traced.moved) {
    unanchored.emplace(v, kNoMember);
    suspect_neighbours(v);
  }
  while (!suspects.empty()) {
    const VertexId v = suspects.back();
    suspects.pop_back();
    if (is_anchored(v) || !unanchored.emplace(v, kNoMember).second) continue;
    suspect_neighbours(v);  // v may have been the anchor of a neighbour
  }
  return unanchored;
}

/// The members of the pieces of the crossed faces, by the label intervals along the faces' halfedges.
struct PieceMembers {
  IdVector<FaceId, std::int32_t> crossed_index;  ///< number of the face among the crossed faces, or -1
  std::vector<std::int32_t> first_interval{};    ///< three per crossed face: where each halfedge begins in `pieces`
  std::vector<std::int32_t> pieces{};            ///< the piece along each label interval

  /// The piece along an interval of halfedge h of a crossed face, counted along h.
  std::int32_t along(HalfedgeId h, std::int32_t interval) const {
    return pieces[first_interval[3 * crossed_index[Mesh::face(h)] + Mesh::corner(h)] + interval];
  }
};

/// Whether the label intervals of a face all belong to different cells, so that each has its own piece.
bool are_distinct(const std::vector<BoundaryCrossing>& boundary) {
  for (std::size_t i = 0; i < boundary.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (boundary[i].next == boundary[j].next) return false;
    }
  }
  return true;
}

/// Adds a member for each piece of the crossed faces, and unites it with the members of its corners,
/// `member_of(vertex)`.
template <class MemberOf>
PieceMembers add_pieces(const Mesh& mesh, const TracedDiagram& traced, const MemberOf& member_of, MemberSets& all) {
  PieceMembers result{IdVector<FaceId, std::int32_t>(mesh.face_count(), -1)};
  std::vector<BoundaryCrossing> boundary;  // of the current face
  WorkingPieces traced_pieces;             // of the current face, if they have to be traced
  const std::vector<FaceArc>& arcs = traced.faces.arcs;
  for (std::size_t begin = 0, end = 0; begin < arcs.size(); begin = end) {
    const FaceId f = arcs[begin].face;
    while (end < arcs.size() && arcs[end].face == f) ++end;
    boundary_crossings(mesh, traced.crossings, f, boundary);
    const auto first = static_cast<std::int32_t>(all.members.size());
    const bool is_distinct = are_distinct(boundary);
    if (is_distinct) {
      for (const BoundaryCrossing& c : boundary) all.add(c.next, f);
    } else {
      trace_pieces(boundary, std::span(arcs).subspan(begin, end - begin), traced.faces, traced_pieces);
      for (const WorkingPiece& piece : traced_pieces.pieces) all.add(piece.generator, f);
    }
    const auto member_of_interval = [&](std::size_t i) {
      return first + (is_distinct ? static_cast<std::int32_t>(i) : traced_pieces.piece_of_interval[i]);
    };
    result.crossed_index[f] = static_cast<std::int32_t>(result.first_interval.size() / 3);
    // A halfedge begins in the interval after the last crossing before it. Each crossing on it begins another interval.
    std::int32_t current = member_of_interval(boundary.size() - 1);
    std::size_t next = 0;
    for (int corner = 0; corner < 3; ++corner) {
      all.sets.unite(current, member_of(mesh.vertices(f)[corner]));
      result.first_interval.push_back(static_cast<std::int32_t>(result.pieces.size()));
      result.pieces.push_back(current);
      for (; next < boundary.size() && boundary[next].corner == corner; ++next) {
        result.pieces.push_back(current = member_of_interval(next));
      }
    }
  }
  return result;
}

/// Unites the pieces on the two sides of each label interval of the crossed edges.
void unite_across_edges(const Mesh& mesh, const Crossings& crossings, const PieceMembers& pieces, UnionFind& sets) {
  const std::vector<Crossing>& items = crossings.items();
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (i > 0 && items[i - 1].edge == items[i].edge) continue;
    const HalfedgeId h = mesh.halfedge(items[i].edge), twin = mesh.twin(h);
    if (!twin.valid()) continue;
    const std::int32_t last = crossings.count(items[i].edge);
    for (std::int32_t k = 0; k <= last; ++k) sets.unite(pieces.along(h, k), pieces.along(twin, last - k));
  }
}

}  // namespace

CellComponents find_cell_components(const WorkingMesh& working, const TracedDiagram& traced) {
  const Mesh& mesh = working.mesh();
  const IdVector<VertexId, GeneratorId>& label = traced.labels.label;
  MemberSets all;
  for (const GeneratorId g : working.generator_vertices().ids()) all.add(g, FaceId());
  std::map<VertexId, std::int32_t> unanchored = find_unanchored_vertices(working, traced);
  for (auto& [v, member] : unanchored) member = all.add(label[v], Mesh::face(mesh.halfedge(v)));
  const auto member_of = [&](VertexId v) {
    const auto it = unanchored.find(v);
    return it == unanchored.end() ? label[v].value() : it->second;
  };
  const PieceMembers pieces = add_pieces(mesh, traced, member_of, all);
  for (const auto& [v, member] : unanchored) {
    for_each_neighbour(mesh, v, [&, v = v, member = member](VertexId u, HalfedgeId h) {
      const bool is_crossed = traced.crossings.count(mesh.edge(h)) > 0;
      if (!is_crossed && label[u] == label[v]) all.sets.unite(member, member_of(u));
    });
  }
  unite_across_edges(mesh, traced.crossings, pieces, all.sets);

  CellComponents result;
  result.count.assign(working.generator_vertices().size(), 0);
  for (int i = 0; i < std::ssize(all.members); ++i) {
    const auto& [generator, face] = all.members[i];
    result.count[generator] += all.sets.find(i) == i;
    if (all.sets.find(i) == generator.value()) continue;
    for (const HalfedgeId h : Mesh::halfedges(face)) result.island_edges.push_back(mesh.edge(h));
  }
  sort_unique(result.island_edges);
  for (const auto& [v, member] : unanchored) {
    if (all.sets.find(member) != label[v].value()) result.island_vertices.push_back(v);
  }
  return result;
}

}  // namespace gvd
