// The cells of a traced diagram: labels of faces, pieces, areas, Euler characteristics, boundary loops and neighbours.
//
// Several threads take chunks of faces. Each sums up the shares of the cells in its chunk (CellShares), and the shares
// are added in the order of the chunks, so that every sum has the same bits for any number of threads.
// A cell's Euler characteristic is counted over its open interior, because along its closed boundary curves vertices
// and edges cancel. Neither bisectors nor the mesh's boundary are therefore counted. Boundary loops are counted
// separately, by union-find over the sides of arcs; tests compare the two counts.
// Source: not in the paper, which stops at the bisectors. Cost: O(n) for n faces, of which only those with arcs are cut.
#include "diagram/collect_cells.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <span>

#include "base/barycentric.hpp"
#include "base/sort_unique.hpp"
#include "base/union_find.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Number of faces in a chunk. Some faces are cut into pieces, which takes longer than a look-up.
constexpr std::size_t kChunkFaces = 1 << 11;

/// Stands for the first side of a loop at an end as long as there is none.
constexpr std::int32_t kNoSide = -1;

/// The shares of cells in a chunk of faces, and the pieces of the cut faces.
struct CollectedFaces {
  CellShares shares;
  std::vector<FacePiece> pieces;
};

/// The known pieces of face f. `next` is the index after the pieces of the previous face, where the search begins.
std::span<FacePiece> known_pieces_in(std::vector<FacePiece>& pieces, FaceId f, std::size_t& next) {
  if (next == pieces.size() || pieces[next].face != f) {
    next = std::ranges::lower_bound(pieces, f, {}, &FacePiece::face) - pieces.begin();
  }
  const std::size_t first = next;
  while (next < pieces.size() && pieces[next].face == f) ++next;
  return std::span(pieces).subspan(first, next - first);
}

/// Labels the faces of a chunk. Faces with arcs are cut into pieces, or their known pieces are moved to the result.
/// Writes the labels of the chunk's own faces only.
CollectedFaces collect_faces(const WorkingMesh& working, const TracedDiagram& traced, KnownPieces* known,
                             const Chunk& chunk, IdVector<FaceId, GeneratorId>& face_label) {
  const Mesh& mesh = working.mesh();
  CollectedFaces result;
  const auto add_share = [&result](GeneratorId g, double area) {
    CellShare& share = result.shares[g];
    ++share.euler_characteristic;
    share.area += area;
  };
  const auto add_piece = [&](FaceId f, GeneratorId g, std::vector<Bary> corners) {
    for (Bary& corner : corners) corner = working.parent_bary(f, corner);
    result.pieces.push_back({working.parent(f), g, std::move(corners)});
  };
  const auto area_of = [](const std::vector<Bary>& corners) {
    return std::max(0.0, area_share(corners));  // it can be negative by rounding
  };
  std::vector<BoundaryCrossing> boundary;  // of the current face
  WorkingPieces cut;                       // of the current face
  std::size_t next_known = 0;              // the known piece after the last one that was moved
  const std::vector<FaceArc>& arcs = traced.faces.arcs;
  auto arc = std::ranges::lower_bound(arcs, FaceId(chunk.begin), {}, &FaceArc::face);
  for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
    const FaceId f(i);
    const auto begin = arc;
    while (arc != arcs.end() && arc->face == f) ++arc;
    const double area = mesh.area(f);
    if (begin == arc) {
      const GeneratorId g = traced.labels.label[mesh.vertices(f)[0]];
      if (!g.valid()) continue;
      add_share(g, area);
      if (working.is_split(f)) {
        add_piece(f, g, {kWholeTriangle.begin(), kWholeTriangle.end()});
      } else {
        face_label[f] = g;
      }
    } else if (known != nullptr && known->is_known[f] != 0 && !working.is_split(f)) {
      for (FacePiece& piece : known_pieces_in(known->pieces, f, next_known)) {
        add_share(piece.generator, area * area_of(piece.corners));
        result.pieces.push_back(std::move(piece));
      }
    } else {
      boundary_crossings(mesh, traced.crossings, f, boundary);
      trace_pieces(boundary, {std::to_address(begin), std::to_address(arc)}, traced.faces, cut);
      for (WorkingPiece& piece : cut.pieces) {
        add_share(piece.generator, area * area_of(piece.corners));
        add_piece(f, piece.generator, std::move(piece.corners));
      }
    }
  }
  return result;
}

/// Adds `sign` to the Euler characteristic of the cell label_of(i) for each i below `items`, if that is valid.
template <class LabelOf>
void count_items(std::int32_t items, std::int32_t sign, const ParallelChunks& parallel, const LabelOf& label_of,
                 IdVector<GeneratorId, Cell>& cells) {
  const auto count_chunk = [&](const Chunk& chunk) {
    CellShares shares;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const GeneratorId g = label_of(i);
      if (g.valid()) shares[g].euler_characteristic += sign;
    }
    return shares.take();
  };
  const auto chunks = cut_into_chunks(items, kScanChunk);
  for (const CellShare& share : parallel.collect(chunks, steps::kVerticesAndEdges, count_chunk)) {
    cells[share.generator].euler_characteristic += share.euler_characteristic;
  }
}

}  // namespace

void find_neighbours(Diagram& diagram) {
  for (const Bisector& b : diagram.bisectors) {
    if (b.left == b.right) continue;
    diagram.cells[b.left].neighbours.push_back(b.right);
    diagram.cells[b.right].neighbours.push_back(b.left);
  }
  for (Cell& c : diagram.cells) {
    sort_unique(c.neighbours);
  }
}

/// Unites the sides of arcs and the label intervals of boundary edges that follow each other around a cell, so that
/// each set is a loop.
IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced) {
  const Mesh& mesh = working.mesh();
  const Crossings& crossings = traced.crossings;
  UnionFind sets(0);
  std::vector<GeneratorId> label;  // label of each member
  const auto add = [&](GeneratorId g) {
    label.push_back(g);
    return sets.add();
  };
  // The cells at a crossing or at a branch point differ, so that the end of a side and its cell determine which side
  // follows.
  IdVector<CrossingId, std::array<std::int32_t, 2>> at_crossing(crossings.size(), {kNoSide, kNoSide});
  IdVector<BranchPointId, std::map<GeneratorId, std::int32_t>> at_branch(traced.faces.branches.size());
  std::map<VertexId, std::int32_t> at_vertex;
  const auto unite = [&](std::int32_t& first, std::int32_t member) {
    if (first == kNoSide) first = member;
    sets.unite(first, member);
  };
  const auto unite_at_crossing = [&](CrossingId id, GeneratorId g, std::int32_t member) {
    unite(at_crossing[id][crossings[id].before == g ? 0 : 1], member);
  };
  const auto unite_at_vertex = [&](VertexId v, std::int32_t member) {
    unite(at_vertex.try_emplace(v, kNoSide).first->second, member);
  };
  for (const FaceArc& arc : traced.faces.arcs) {
    for (const GeneratorId g : {arc.left, arc.right}) {
      const std::int32_t side = add(g);
      for (const ArcEnd& end : {arc.begin, arc.end}) {
        if (end.crossing.valid()) {
          unite_at_crossing(end.crossing, g, side);
        } else {
          unite(at_branch[end.branch].try_emplace(g, kNoSide).first->second, side);
        }
      }
    }
  }
  for (const EdgeId e : mesh.edges()) {
    if (!mesh.is_boundary(e)) continue;
    const HalfedgeId h = mesh.halfedge(e);
    GeneratorId g = traced.labels.label[mesh.from(h)];
    std::int32_t interval = add(g);
    unite_at_vertex(mesh.from(h), interval);
    for (std::int32_t k = 0; k < crossings.count(e); ++k) {
      const CrossingId id(crossings.first(e).value() + k);
      unite_at_crossing(id, g, interval);
      g = crossings[id].after;
      interval = add(g);
      unite_at_crossing(id, g, interval);
    }
    unite_at_vertex(mesh.to(h), interval);
  }
  IdVector<GeneratorId, std::int32_t> loops(working.generator_vertices().size(), 0);
  for (int i = 0; i < std::ssize(label); ++i) {
    if (label[i].valid() && sets.find(i) == i) ++loops[label[i]];
  }
  return loops;
}

void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram, KnownPieces* known) {
  const Mesh& mesh = working.mesh();
  const IdVector<VertexId, GeneratorId>& label = traced.labels.label;
  diagram.cells.resize(working.generator_vertices().size());
  diagram.face_label.resize(working.input().face_count());
  const auto inner_vertex = [&](std::size_t i) {
    const VertexId v(i);
    return mesh.is_boundary(v) ? GeneratorId() : label[v];
  };
  const auto first_of_inner_edge = [&](std::size_t i) {
    const HalfedgeId h = mesh.halfedge(EdgeId(i));
    return mesh.twin(h).valid() ? label[mesh.from(h)] : GeneratorId();
  };
  count_items(mesh.vertex_count(), 1, parallel, inner_vertex, diagram.cells);
  count_items(mesh.edge_count(), -1, parallel, first_of_inner_edge, diagram.cells);
  for (const Crossing& c : traced.crossings.items()) {
    if (!mesh.is_boundary(c.edge)) --diagram.cells[c.after].euler_characteristic;
  }
  std::vector<FacePiece>& pieces = diagram.pieces;
  const auto chunks = cut_into_chunks(mesh.face_count(), kChunkFaces);
  const auto collect = [&](const Chunk& chunk) {
    return collect_faces(working, traced, known, chunk, diagram.face_label);
  };
  for (CollectedFaces& faces : parallel.map(chunks, steps::kPieces, collect)) {
    for (const CellShare& share : faces.shares.take()) {
      diagram.cells[share.generator].euler_characteristic += share.euler_characteristic;
      diagram.cells[share.generator].area += share.area;
    }
    std::ranges::move(faces.pieces, std::back_inserter(pieces));
  }
  // Only the pieces of faces that generators split are out of order, and they come last.
  const auto by_face = [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; };
  const auto last = std::is_sorted_until(pieces.begin(), pieces.end(), by_face);
  std::stable_sort(last, pieces.end(), by_face);
  std::inplace_merge(pieces.begin(), last, pieces.end(), by_face);
  find_neighbours(diagram);
  const auto loops = count_boundary_loops(working, traced);
  for (const GeneratorId g : diagram.cells.ids()) {
    diagram.cells[g].generator = g;
    diagram.cells[g].components = traced.cell_components[g];
    diagram.cells[g].boundary_loops = loops[g];
  }
}

}  // namespace gvd
