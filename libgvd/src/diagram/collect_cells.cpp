#include <algorithm>
#include <span>

#include "diagram/area_share.hpp"
#include "diagram/cell_topology.hpp"
#include "diagram/diagram_graph.hpp"
#include "diagram/face_pieces.hpp"

namespace gvd {
namespace {

using Bary = std::array<double, 3>;

class CellCollector {
 public:
  CellCollector(const WorkingMesh& working, const TracedDiagram& traced, Diagram& diagram)
      : working_(working), mesh_(working.mesh()), traced_(traced), diagram_(diagram) {}

  void collect() {
    const auto n = working_.generator_vertices().size();
    diagram_.cells.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      const GeneratorId g(static_cast<std::int64_t>(i));
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
  // The Euler characteristic of a cell as a surface with boundary is the count over its open inside, for along its
  // closed boundary curves vertices and edges cancel: so neither bisectors nor the mesh's boundary are counted.
  void count_vertices() {
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      const VertexId v(i);
      if (!mesh_.is_boundary(v) && traced_.labels.label[v].valid()) {
        ++diagram_.cells[traced_.labels.label[v]].euler_characteristic;
      }
    }
  }

  void count_edges() {
    for (std::int32_t i = 0; i < mesh_.edge_count(); ++i) {
      const GeneratorId first = traced_.labels.label[mesh_.from(mesh_.halfedge(EdgeId(i)))];
      if (first.valid() && !mesh_.is_boundary(EdgeId(i))) --diagram_.cells[first].euler_characteristic;
    }
    for (const Crossing& c : traced_.crossings.items()) {
      if (!mesh_.is_boundary(c.edge)) --diagram_.cells[c.after].euler_characteristic;
    }
  }

  void collect_faces() {
    std::size_t arc = 0;
    for (std::int32_t i = 0; i < mesh_.face_count(); ++i) {
      const FaceId f(i);
      const std::size_t begin = arc;
      while (arc < traced_.faces.arcs.size() && traced_.faces.arcs[arc].face == f) ++arc;
      if (begin == arc) {
        take_whole(f);
      } else {
        take_pieces(f, std::span(traced_.faces.arcs).subspan(begin, arc - begin));
      }
    }
  }

  void take_whole(FaceId f) {
    const GeneratorId g = traced_.labels.label[mesh_.vertices(f)[0]];
    if (!g.valid()) return;
    ++diagram_.cells[g].euler_characteristic;
    diagram_.cells[g].area += mesh_.area(f);
    if (working_.is_split(f)) {
      add_piece(f, g, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    } else {
      diagram_.face_label[f] = g;
    }
  }

  void take_pieces(FaceId f, std::span<const FaceArc> arcs) {
    const double area = mesh_.area(f);
    boundary_crossings(mesh_, traced_.crossings, f, boundary_);
    trace_pieces(boundary_, arcs, traced_.faces, pieces_);
    for (WorkingPiece& piece : pieces_.pieces) {
      Cell& owner = diagram_.cells[piece.generator];
      ++owner.euler_characteristic;
      owner.area += area * std::max(0.0, area_share(piece.corners));  // rounding, where a piece is no more than a line
      add_piece(f, piece.generator, std::move(piece.corners));
    }
  }

  void add_piece(FaceId f, GeneratorId g, std::vector<Bary> corners) {
    for (Bary& corner : corners) corner = working_.parent_bary(f, corner);
    diagram_.pieces.push_back({working_.parent(f), g, std::move(corners)});
  }

  /// Only the faces that generators split are out of order.
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
  Diagram& diagram_;
  std::vector<BoundaryCrossing> boundary_;  // of the face at work
  WorkingPieces pieces_;                    // and its parts
};

}  // namespace

void collect_cells(const WorkingMesh& working, const TracedDiagram& traced, Diagram& diagram) {
  CellCollector(working, traced, diagram).collect();
}

}  // namespace gvd
