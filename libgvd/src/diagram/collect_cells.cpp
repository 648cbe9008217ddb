#include "diagram/collect_cells.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <span>

#include "base/barycentric.hpp"
#include "diagram/cell_shares.hpp"
#include "diagram/graph/boundary_loops.hpp"
#include "diagram/graph/face_pieces.hpp"
#include "gvd/diagram_steps.hpp"

namespace gvd {
namespace {

/// Faces in a chunk. Some are cut into pieces, which takes longer than a look-up.
constexpr std::size_t kChunkFaces = 1 << 11;

/// Labels the faces of a chunk, and cuts those with arcs into pieces.
class FaceCollector {
 public:
  FaceCollector(const WorkingMesh& working, const TracedDiagram& traced, IdVector<FaceId, GeneratorId>& face_label)
      : working_(working), mesh_(working.mesh()), traced_(traced), face_label_(face_label) {}

  void collect(const Chunk& faces) {
    const std::vector<FaceArc>& arcs = traced_.faces.arcs;
    const FaceId first(faces.begin), last(static_cast<std::int64_t>(faces.end));
    auto arc = std::partition_point(arcs.begin(), arcs.end(), [&](const FaceArc& a) { return a.face < first; });
    for (FaceId f = first; f < last; f = FaceId(f.value() + 1)) {
      const auto begin = arc;
      while (arc != arcs.end() && arc->face == f) ++arc;
      if (begin == arc) {
        collect_whole(f);
      } else {
        collect_cut(f, std::span(begin, arc));
      }
    }
  }

  struct Result {
    std::vector<CellShare> shares;
    std::vector<FacePiece> pieces;
  };
  Result take_result() { return {shares_.take(), std::move(pieces_)}; }

 private:
  void collect_whole(FaceId f) {
    const GeneratorId g = traced_.labels.label[mesh_.vertices(f)[0]];
    if (!g.valid()) return;
    CellShare& share = shares_[g];
    ++share.euler_characteristic;
    share.area += mesh_.area(f);
    if (working_.is_split(f)) {
      add_piece(f, g, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    } else {
      face_label_[f] = g;
    }
  }

  void collect_cut(FaceId f, std::span<const FaceArc> arcs) {
    const double area = mesh_.area(f);
    boundary_crossings(mesh_, traced_.crossings, f, boundary_);
    trace_pieces(boundary_, arcs, traced_.faces, working_pieces_);
    for (WorkingPiece& piece : working_pieces_.pieces) {
      CellShare& share = shares_[piece.generator];
      ++share.euler_characteristic;
      share.area += area * std::max(0.0, area_share(piece.corners));  // negative only by rounding
      add_piece(f, piece.generator, std::move(piece.corners));
    }
  }

  void add_piece(FaceId f, GeneratorId g, std::vector<Bary> corners) {
    for (Bary& corner : corners) corner = working_.parent_bary(f, corner);
    pieces_.push_back({working_.parent(f), g, std::move(corners)});
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  IdVector<FaceId, GeneratorId>& face_label_;
  CellShares shares_;
  std::vector<FacePiece> pieces_;
  std::vector<BoundaryCrossing> boundary_;  // of the current face
  WorkingPieces working_pieces_;            // of the current face
};

class CellCollector {
 public:
  CellCollector(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                Diagram& diagram)
      : working_(working), mesh_(working.mesh()), traced_(traced), parallel_(parallel), diagram_(diagram) {}

  void collect() {
    const auto n = working_.generator_vertices().size();
    diagram_.cells.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const GeneratorId g(i);
      diagram_.cells[g].generator = g;
    }
    diagram_.face_label.resize(static_cast<std::size_t>(working_.input().face_count()));
    count_vertices();
    count_edges();
    collect_faces();
    sort_pieces();
    find_neighbours();
    const auto loops = count_boundary_loops(working_, traced_);
    for (Cell& c : diagram_.cells) {
      c.components = traced_.cell_components[c.generator];
      c.boundary_loops = loops[c.generator];
    }
  }

 private:
  // A cell's Euler characteristic is counted over its open interior: along its closed boundary curves vertices and
  // edges cancel. So neither bisectors nor the mesh's boundary are counted.
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
    const auto chunks = cut_into_chunks(static_cast<std::size_t>(items), kScanChunk);
    for (const auto& shares : parallel_.map(chunks, steps::kVerticesAndEdges, [&](const Chunk& chunk) {
           CellShares list;
           for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
             const GeneratorId g = label_of(i);
             if (g.valid()) list[g].euler_characteristic += sign;
           }
           return list.take();
         })) {
      add(shares);
    }
  }

  void collect_faces() {
    const auto chunks = cut_into_chunks(static_cast<std::size_t>(mesh_.face_count()), kChunkFaces);
    for (FaceCollector::Result& result : parallel_.map(chunks, steps::kPieces, [&](const Chunk& chunk) {
           FaceCollector faces(working_, traced_, diagram_.face_label);
           faces.collect(chunk);
           return faces.take_result();
         })) {
      add(result.shares);
      diagram_.pieces.insert(diagram_.pieces.end(), std::make_move_iterator(result.pieces.begin()),
                             std::make_move_iterator(result.pieces.end()));
    }
  }

  void add(const std::vector<CellShare>& shares) {
    for (const CellShare& share : shares) {
      Cell& cell = diagram_.cells[share.generator];
      cell.euler_characteristic += share.euler_characteristic;
      cell.area += share.area;
    }
  }

  /// Only the pieces of faces that generators split are out of order.
  void sort_pieces() {
    const auto by_face = [](const FacePiece& a, const FacePiece& b) { return a.face < b.face; };
    if (std::is_sorted(diagram_.pieces.begin(), diagram_.pieces.end(), by_face)) return;
    std::stable_sort(diagram_.pieces.begin(), diagram_.pieces.end(), by_face);
  }

  void find_neighbours() {
    for (const Bisector& b : diagram_.bisectors) {
      if (b.left == b.right) continue;
      diagram_.cells[b.left].neighbours.push_back(b.right);
      diagram_.cells[b.right].neighbours.push_back(b.left);
    }
    for (Cell& c : diagram_.cells) {
      std::sort(c.neighbours.begin(), c.neighbours.end());
      c.neighbours.erase(std::unique(c.neighbours.begin(), c.neighbours.end()), c.neighbours.end());
    }
  }

  const WorkingMesh& working_;
  const Mesh& mesh_;
  const TracedDiagram& traced_;
  const ParallelChunks& parallel_;
  Diagram& diagram_;
};

}  // namespace

void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, const ParallelChunks& parallel,
                   Diagram& diagram) {
  CellCollector(working, traced, parallel, diagram).collect();
}

}  // namespace gvd
