// The cells of a traced diagram: labels of faces, pieces, areas, Euler characteristics, boundary loops and neighbours.
//
// Several threads take chunks of faces. Each sums up the shares of the cells in its chunk (CellShares), and the shares
// are added in the order of the chunks, so that every sum has the same bits for any number of threads.
// A cell's Euler characteristic is counted over its open interior: along its closed boundary curves vertices and edges
// cancel. So neither bisectors nor the mesh's boundary are counted. The boundary loops are counted on their own, by
// union-find over the sides of arcs; tests compare the two.
// Source: not in the paper, which stops at the bisectors. Cost: O(n) for n faces, of which only those with arcs are cut.
#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <span>

#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "diagram/finish_diagram.hpp"
#include "diagram/graph/face_diagram.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Faces in a chunk. Some are cut into pieces, which takes longer than a look-up.
constexpr std::size_t kChunkFaces = 1 << 11;

constexpr std::int32_t kNoPiece = -1;

/// Unites the sides of arcs and the label intervals of boundary edges that follow each other around a cell: every set
/// is a loop.
class LoopCounter {
 public:
  LoopCounter(const WorkingMesh& working, const TracedDiagram& traced)
      : mesh_(working.mesh()),
        traced_(traced),
        loops_(working.generator_vertices().size(), 0),
        sets_(0),
        at_crossing_(traced.crossings.size(), {kNoPiece, kNoPiece}),
        at_branch_(traced.faces.branches.size()) {}

  IdVector<GeneratorId, std::int32_t> count() {
    for (const FaceArc& arc : traced_.faces.arcs) {
      add_side(arc, arc.left);
      add_side(arc, arc.right);
    }
    for (const EdgeId e : mesh_.edges()) {
      if (mesh_.is_boundary(e)) add_boundary_edge(e);
    }
    for (int i = 0; i < std::ssize(label_); ++i) {
      if (label_[i].valid() && sets_.find(i) == i) ++loops_[label_[i]];
    }
    return std::move(loops_);
  }

 private:
  std::int32_t add(GeneratorId g) {
    label_.push_back(g);
    return sets_.add();
  }

  // The cells at a crossing or at a branch point differ, so the end and the cell of a side determine what follows it.
  void add_side(const FaceArc& arc, GeneratorId g) {
    const std::int32_t side = add(g);
    for (const ArcEnd& end : {arc.begin, arc.end}) {
      if (end.crossing.valid()) {
        unite_at(end.crossing, g, side);
      } else {
        unite(at_branch_[end.branch].try_emplace(g, kNoPiece).first->second, side);
      }
    }
  }

  void add_boundary_edge(EdgeId e) {
    const HalfedgeId h = mesh_.halfedge(e);
    GeneratorId g = traced_.labels.label[mesh_.from(h)];
    std::int32_t interval = add(g);
    unite(at_vertex_.try_emplace(mesh_.from(h), kNoPiece).first->second, interval);
    for (std::int32_t k = 0; k < traced_.crossings.count(e); ++k) {
      const CrossingId id(traced_.crossings.first(e).value() + k);
      unite_at(id, g, interval);
      g = traced_.crossings[id].after;
      interval = add(g);
      unite_at(id, g, interval);
    }
    unite(at_vertex_.try_emplace(mesh_.to(h), kNoPiece).first->second, interval);
  }

  void unite_at(CrossingId id, GeneratorId g, std::int32_t member) {
    unite(at_crossing_[id][traced_.crossings[id].before == g ? 0 : 1], member);
  }

  void unite(std::int32_t& first, std::int32_t member) {
    if (first == kNoPiece) first = member;
    sets_.unite(first, member);
  }

  const Mesh& mesh_;
  const TracedDiagram& traced_;
  IdVector<GeneratorId, std::int32_t> loops_;
  UnionFind sets_;
  std::vector<GeneratorId> label_;
  IdVector<CrossingId, std::array<std::int32_t, 2>> at_crossing_;
  IdVector<BranchPointId, std::map<GeneratorId, std::int32_t>> at_branch_;
  std::map<VertexId, std::int32_t> at_vertex_;
};

/// What the faces of a chunk give: the shares of cells, and the pieces of faces that are cut.
struct CollectedFaces {
  CellShares shares;
  std::vector<FacePiece> pieces;
  std::ptrdiff_t known = 0;                ///< number of the known piece after the last one that was taken
  std::vector<BoundaryCrossing> boundary;  ///< of the current face
  WorkingPieces working_pieces;            ///< of the current face
};

class CellCollector {
 public:
  CellCollector(const WorkingMesh& working, const TracedDiagram& traced, const FinishingTools& tools, Diagram& diagram)
      : working_(working),
        mesh_(working.mesh()),
        traced_(traced),
        parallel_(tools.parallel),
        diagram_(diagram),
        known_(tools.known) {}

  void collect() {
    diagram_.cells.resize(working_.generator_vertices().size());
    diagram_.face_label.resize(working_.input().face_count());
    count_vertices();
    count_edges();
    collect_faces();
    sort_pieces();
    find_neighbours(diagram_);
    const auto loops = count_boundary_loops(working_, traced_);
    for (const GeneratorId g : diagram_.cells.ids()) {
      diagram_.cells[g].generator = g;
      diagram_.cells[g].components = traced_.cell_components[g];
      diagram_.cells[g].boundary_loops = loops[g];
    }
  }

 private:
  void count_vertices() {
    count(mesh_.vertex_count(), 1, [&](std::size_t i) {
      const VertexId v(i);
      return mesh_.is_boundary(v) ? GeneratorId() : traced_.labels.label[v];
    });
  }

  void count_edges() {
    count(mesh_.edge_count(), -1, [&](std::size_t i) {
      const HalfedgeId h = mesh_.halfedge(EdgeId(i));
      return mesh_.twin(h).valid() ? traced_.labels.label[mesh_.from(h)] : GeneratorId();
    });
    for (const Crossing& c : traced_.crossings.items()) {
      if (!mesh_.is_boundary(c.edge)) --diagram_.cells[c.after].euler_characteristic;
    }
  }

  /// Adds `sign` to the Euler characteristic of label_of(i)'s cell for every i below `items`.
  template <class LabelOf>
  void count(std::int32_t items, std::int32_t sign, const LabelOf& label_of) {
    const auto count_chunk = [&](const Chunk& chunk) {
      CellShares shares;
      for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
        const GeneratorId g = label_of(i);
        if (g.valid()) shares[g].euler_characteristic += sign;
      }
      return shares.take();
    };
    for (const auto& shares :
         parallel_.map(cut_into_chunks(items, kScanChunk), steps::kVerticesAndEdges, count_chunk)) {
      add(shares);
    }
  }

  void collect_faces() {
    const auto chunks = cut_into_chunks(mesh_.face_count(), kChunkFaces);
    const auto collect_chunk = [&](const Chunk& chunk) { return collect_faces(chunk); };
    for (CollectedFaces& faces : parallel_.map(chunks, steps::kPieces, collect_chunk)) {
      add(faces.shares.take());
      std::move(faces.pieces.begin(), faces.pieces.end(), std::back_inserter(diagram_.pieces));
    }
  }

  /// Labels the faces of a chunk, and cuts those with arcs into pieces. Writes labels of its own faces only.
  CollectedFaces collect_faces(const Chunk& chunk) {
    CollectedFaces faces;
    const std::vector<FaceArc>& arcs = traced_.faces.arcs;
    auto arc = std::ranges::lower_bound(arcs, FaceId(chunk.begin), {}, &FaceArc::face);
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      const auto begin = arc;
      while (arc != arcs.end() && arc->face == f) ++arc;
      if (begin == arc) {
        collect_whole(f, faces);
      } else if (known_ != nullptr && known_->is_known[f] != 0 && !working_.is_split(f)) {
        collect_known(f, faces);
      } else {
        collect_cut(f, std::span(std::to_address(begin), std::to_address(arc)), faces);
      }
    }
    return faces;
  }

  void collect_whole(FaceId f, CollectedFaces& faces) {
    const GeneratorId g = traced_.labels.label[mesh_.vertices(f)[0]];
    if (!g.valid()) return;
    CellShare& share = faces.shares[g];
    ++share.euler_characteristic;
    share.area += mesh_.area(f);
    if (working_.is_split(f)) {
      add_piece(f, g, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, faces);
    } else {
      diagram_.face_label[f] = g;
    }
  }

  void collect_cut(FaceId f, std::span<const FaceArc> arcs, CollectedFaces& faces) const {
    const double area = mesh_.area(f);
    boundary_crossings(mesh_, traced_.crossings, f, faces.boundary);
    trace_pieces(faces.boundary, arcs, traced_.faces, faces.working_pieces);
    for (WorkingPiece& piece : faces.working_pieces.pieces) {
      CellShare& share = faces.shares[piece.generator];
      ++share.euler_characteristic;
      share.area += area * std::max(0.0, area_share(piece.corners));  // negative only by rounding
      add_piece(f, piece.generator, std::move(piece.corners), faces);
    }
  }

  void collect_known(FaceId f, CollectedFaces& faces) const {
    const double area = mesh_.area(f);
    auto piece = known_->pieces.begin() + faces.known;
    if (piece == known_->pieces.end() || piece->face != f) {
      piece = std::ranges::lower_bound(known_->pieces, f, {}, &FacePiece::face);
    }
    for (; piece != known_->pieces.end() && piece->face == f; ++piece) {
      CellShare& share = faces.shares[piece->generator];
      ++share.euler_characteristic;
      share.area += area * std::max(0.0, area_share(piece->corners));
      faces.pieces.push_back(std::move(*piece));
    }
    faces.known = piece - known_->pieces.begin();
  }

  void add_piece(FaceId f, GeneratorId g, std::vector<Bary> corners, CollectedFaces& faces) const {
    for (Bary& corner : corners) corner = working_.parent_bary(f, corner);
    faces.pieces.push_back({working_.parent(f), g, std::move(corners)});
  }

  void add(const std::vector<CellShare>& shares) {
    for (const CellShare& share : shares) {
      Cell& cell = diagram_.cells[share.generator];
      cell.euler_characteristic += share.euler_characteristic;
      cell.area += share.area;
    }
  }

  /// Only the pieces of parts that generators made are out of order. They come last.
  void sort_pieces() {
    std::vector<FacePiece>& pieces = diagram_.pieces;
    const auto by_face = [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; };
    const auto last = std::is_sorted_until(pieces.begin(), pieces.end(), by_face);
    std::stable_sort(last, pieces.end(), by_face);
    std::inplace_merge(pieces.begin(), last, pieces.end(), by_face);
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  const ParallelChunks& parallel_;
  Diagram& diagram_;
  KnownPieces* known_;  // null without any
};

}  // namespace

void find_neighbours(Diagram& diagram) {
  for (const Bisector& b : diagram.bisectors) {
    if (b.left == b.right) continue;
    diagram.cells[b.left].neighbours.push_back(b.right);
    diagram.cells[b.right].neighbours.push_back(b.left);
  }
  for (Cell& c : diagram.cells) {
    std::sort(c.neighbours.begin(), c.neighbours.end());
    c.neighbours.erase(std::unique(c.neighbours.begin(), c.neighbours.end()), c.neighbours.end());
  }
}

IdVector<GeneratorId, std::int32_t> count_boundary_loops(const WorkingMesh& working, const TracedDiagram& traced) {
  return LoopCounter(working, traced).count();
}

void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const FinishingTools& tools,
                   Diagram& diagram) {
  CellCollector(working, traced, tools, diagram).collect();
}

}  // namespace gvd
