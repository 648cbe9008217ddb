// The dual near some cells of a diagram, after generators have been removed and added there.
//
// Only the faces of these cells and of two rings of cells round them are computed again. The result is trusted for the
// inner cells: those that meet no face of the part's fringe, in which other cells begin. If a new cell reaches the
// fringe, the part can't tell, and there is no result. docs/developer/proofs.md has the proof.

#include "repair/local_dual.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "diagram/cell_parts.hpp"
#include "diagram/diagram_windows.hpp"
#include "dual/dual_defects.hpp"

namespace gvd {

CellFlags grow_rings(const Diagram& diagram, const std::vector<GeneratorId>& cells, int rings) {
  CellFlags flags(diagram.cells.size(), 0);
  std::vector<GeneratorId> last = cells;
  for (const GeneratorId g : cells) flags[g] = 1;
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<GeneratorId> next;
    for (const GeneratorId g : last) {
      for (const GeneratorId n : diagram.cells[g].neighbours) {
        if (flags[n]) continue;
        flags[n] = 1;
        next.push_back(n);
      }
    }
    last = std::move(next);
  }
  return flags;
}

CellPart cut_out_cells(const Mesh& mesh, const Diagram& diagram, const CellFlags& in_part) {
  IdVector<FaceId, char> meets(mesh.face_count(), 0), meets_others(mesh.face_count(), 0);
  for_each_cell_part(diagram,
                     [&](const FacePart& part) { (in_part[part.generator] ? meets : meets_others)[part.face] = 1; });
  std::vector<FaceId> faces;
  IdVector<FaceId, char> is_fringe;
  for (const FaceId f : mesh.faces()) {
    if (!meets[f]) continue;
    bool ends = meets_others[f] != 0;
    for (const HalfedgeId h : Mesh::halfedges(f)) {
      const HalfedgeId twin = mesh.twin(h);
      ends |= twin.valid() && !meets[Mesh::face(twin)];
    }
    faces.push_back(f);
    is_fringe.push_back(ends ? 1 : 0);
  }
  return {make_submesh(mesh, std::move(faces)), std::move(is_fringe)};
}

namespace {

/// One ring for the cells that a change alters, and one more so that these cells have all their neighbours.
constexpr int kRings = 2;

bool are_all(const CellFlags& flags, const std::vector<GeneratorId>& cells) {
  return std::all_of(cells.begin(), cells.end(), [&](GeneratorId g) { return flags[g] != 0; });
}

}  // namespace

LocalDual::LocalDual(const Mesh& mesh, const Diagram& diagram, const std::vector<GeneratorId>& cells,
                     const std::vector<GeneratorId>& removed, const DiagramOptions& options)
    : LocalDual(mesh, diagram, grow_rings(diagram, cells, kRings), removed, options) {}

LocalDual::LocalDual(const Mesh& mesh, const Diagram& diagram, CellFlags stays, const std::vector<GeneratorId>& removed,
                     const DiagramOptions& options)
    : diagram_(diagram), part_(cut_out_cells(mesh, diagram, stays)), options_(options) {
  // The tolerance is a multiple of the mean edge length; it must be the same length in the part as in the whole mesh.
  options_.chord_tolerance =
      std::max(kLeastChordTolerance, options.chord_tolerance * mesh.mean_edge_length() / part_.mesh.mean_edge_length());
  for (const GeneratorId g : removed) stays[g] = 0;
  for (const Cell& cell : diagram.cells) {
    if (stays[cell.generator]) kept_.push_back(cell.generator);
  }
}

std::optional<LocalDual::Result> LocalDual::compute(const std::vector<SurfacePoint>& added) const {
  std::vector<SurfacePoint> generators;
  if (!add_generators(added, generators)) return std::nullopt;
  auto computed = try_to_compute_diagram(part_.mesh, generators, options_);
  if (std::holds_alternative<Error>(computed)) return std::nullopt;  // a point coincides with a generator
  Result result;
  result.diagram = std::get<Diagram>(std::move(computed));
  result.inner = find_inner_cells(result.diagram);
  for (std::size_t i = kept_.size(); i < generators.size(); ++i) {
    if (!result.inner[GeneratorId(i)]) return std::nullopt;
  }
  result.defects = find_defects(result);
  if (!result.defects.empty() && result.defects.front().cells.empty()) return std::nullopt;
  return result;
}

bool LocalDual::add_generators(const std::vector<SurfacePoint>& added, std::vector<SurfacePoint>& generators) const {
  const auto add = [&](const SurfacePoint& point) {
    const auto in_part = part_.to_part(point);
    if (in_part) generators.push_back(*in_part);
    return in_part.has_value();
  };
  return std::all_of(kept_.begin(), kept_.end(), [&](GeneratorId g) { return add(diagram_.generators[g.index()]); }) &&
         std::all_of(added.begin(), added.end(), add) && !generators.empty();
}

CellFlags LocalDual::find_inner_cells(const Diagram& diagram) const {
  CellFlags inner(diagram.generators.size(), 1);
  for_each_cell_part(diagram, [&](const FacePart& part) {
    if (part_.is_fringe[part.face]) inner[part.generator] = 0;
  });
  return inner;
}

std::vector<DualDefect> LocalDual::find_defects(const Result& result) const {
  const DualMesh dual = build_dual(part_.mesh, result.diagram);
  std::vector<DualDefect> defects = check_dual(part_.mesh, result.diagram, dual);
  std::erase_if(defects, [&](const DualDefect& d) { return !are_all(result.inner, d.cells); });
  if (!defects.empty()) return defects;
  for (const std::size_t i : find_flipped_triangles(part_.mesh, result.diagram, dual)) {
    DualDefect defect = triangle_defect(result.diagram, dual, i, "is flipped");
    if (are_all(result.inner, defect.cells)) defects.push_back(std::move(defect));
  }
  return defects;
}

}  // namespace gvd
