#include "pieces/collect_pieces.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "base/barycentric.hpp"
#include "pieces/chain_segments.hpp"
#include "pieces/islands.hpp"

namespace gvd::paper {
namespace {

/// Moves corners onto the sides and vertices of their face that they are next to. Where a bisector runs through a
/// vertex or along an edge, rounding leaves slivers there, which would tear it.
void snap_corners(Pieces& pieces) {
  for (FacePiece& piece : pieces) {
    for (Bary& corner : piece.corners) {
      double sum = 0;
      for (double& b : corner) sum += b = b > kLeastContact ? b : 0;
      for (double& b : corner) b /= sum;
    }
  }
}

/// A vertex takes the label of the first piece that has it as a corner.
void label_vertices(const Mesh& mesh, const Pieces& pieces, Diagram& diagram) {
  diagram.vertex_label.assign(static_cast<std::size_t>(mesh.vertex_count()), GeneratorId());
  for (const FacePiece& piece : pieces) {
    for (const Bary& corner : piece.corners) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (corner[i] != 1) continue;
        GeneratorId& label = diagram.vertex_label[mesh.vertices(piece.face)[i]];
        if (!label.valid()) label = piece.generator;
      }
    }
  }
}

void trace_contacts(const Mesh& mesh, const Pieces& pieces, const std::vector<Contact>& contacts,
                    Comparison& comparison) {
  std::vector<Segment> segments;
  for (const Contact& c : contacts) {
    const GeneratorId left = pieces[c.left].generator;
    const GeneratorId right = pieces[c.right].generator;
    if (left == right || !left.valid() || !right.valid()) continue;
    Segment segment{left, right, {c.face, c.begin}, {c.face, c.end}};
    if (right < left) segment = {right, left, {c.face, c.end}, {c.face, c.begin}};
    segments.push_back(segment);
    comparison.diagram.length += (position(mesh, segment.end) - position(mesh, segment.begin)).norm();
  }
  Chains chains = chain_segments(mesh, segments);
  for (Bisector& bisector : chains.bisectors) comparison.diagram.bisectors.push_back(std::move(bisector));
  comparison.faults.open_ends += chains.open_ends;
}

void count_faults(const CellParts& parts, std::size_t generators, Comparison& comparison) {
  std::set<GeneratorId> found;
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    const GeneratorId g = parts.generator[i];
    if (!g.valid()) comparison.faults.unowned_area += parts.area[i];
    if (parts.has_generator[i] != 0) found.insert(g);
    if (!parts.is_island(static_cast<std::int32_t>(i))) continue;
    ++comparison.faults.islands;
    comparison.faults.island_area += parts.area[i];
  }
  comparison.faults.lost_generators += static_cast<std::int64_t>(generators - found.size());
}

void fill_cells(const CellParts& parts, Diagram& diagram) {
  diagram.cells.resize(diagram.generators.size());
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const GeneratorId g(i);
    diagram.cells[g].generator = g;
  }
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    if (!parts.generator[i].valid()) continue;
    Cell& cell = diagram.cells[parts.generator[i]];
    cell.area += parts.area[i];
    ++cell.components;
  }
  for (const Bisector& b : diagram.bisectors) {
    diagram.cells[b.left].neighbours.push_back(b.right);
    diagram.cells[b.right].neighbours.push_back(b.left);
  }
  for (Cell& cell : diagram.cells) {
    std::sort(cell.neighbours.begin(), cell.neighbours.end());
    cell.neighbours.erase(std::unique(cell.neighbours.begin(), cell.neighbours.end()), cell.neighbours.end());
  }
}

/// Faces that are not cut get a label, the other ones keep their pieces.
void store_pieces(const Mesh& mesh, Pieces pieces, Diagram& diagram) {
  diagram.face_label.assign(static_cast<std::size_t>(mesh.face_count()), GeneratorId());
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t j = i;
    while (j < pieces.size() && pieces[j].face == pieces[i].face) ++j;
    if (j == i + 1) {
      diagram.face_label[pieces[i].face] = pieces[i].generator;
    } else {
      std::move(pieces.begin() + static_cast<std::ptrdiff_t>(i), pieces.begin() + static_cast<std::ptrdiff_t>(j),
                std::back_inserter(diagram.pieces));
    }
    i = j;
  }
}

}  // namespace

void collect_pieces(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Pieces pieces,
                    Comparison& comparison) {
  snap_corners(pieces);
  const std::vector<Contact> contacts = find_contacts(mesh, pieces);
  const CellParts parts = find_cell_parts(mesh, generators, pieces, contacts);
  comparison.diagram.generators = generators;
  label_vertices(mesh, pieces, comparison.diagram);
  trace_contacts(mesh, pieces, contacts, comparison);
  count_faults(parts, generators.size(), comparison);
  fill_cells(parts, comparison.diagram);
  store_pieces(mesh, std::move(pieces), comparison.diagram);
}

double sum_areas(const Mesh& mesh, const Pieces& pieces) {
  double sum = 0;
  for (const FacePiece& piece : pieces) sum += mesh.area(piece.face) * area_share(piece.corners);
  return sum;
}

}  // namespace gvd::paper
