#include "repair/local_dual.hpp"

#include <algorithm>

#include "gvd/error.hpp"

namespace gvd {
namespace {

/// One ring for the cells that a change alters, one more so that these have all their neighbours.
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
    : diagram_(diagram), part_(mesh, diagram, stays), options_(options) {
  // The tolerance is in mean edge lengths: the same length in the part as in the whole mesh.
  options_.chord_tolerance = std::max(
      kLeastChordTolerance, options.chord_tolerance * mesh.mean_edge_length() / part_.mesh().mean_edge_length());
  for (const GeneratorId g : removed) stays[g] = 0;
  for (const Cell& cell : diagram.cells) {
    if (stays[cell.generator]) kept_.push_back(cell.generator);
  }
}

std::optional<LocalDual::Result> LocalDual::compute(const std::vector<SurfacePoint>& added) const {
  std::vector<SurfacePoint> generators;
  if (!add_generators(added, generators)) return std::nullopt;
  Result result;
  try {
    result.diagram = compute_diagram(part_.mesh(), generators, options_);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::precondition) throw;
    return std::nullopt;
  }
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
  for (std::int32_t i = 0; i < part_.mesh().face_count(); ++i) {
    const GeneratorId g = diagram.face_label[FaceId(i)];
    if (g.valid() && part_.is_fringe(FaceId(i))) inner[g] = 0;
  }
  for (const FacePiece& piece : diagram.pieces) {
    if (part_.is_fringe(piece.face)) inner[piece.generator] = 0;
  }
  return inner;
}

std::vector<DualDefect> LocalDual::find_defects(const Result& result) const {
  std::vector<DualDefect> defects = check_dual(part_.mesh(), result.diagram);
  std::erase_if(defects, [&](const DualDefect& d) { return !are_all(result.inner, d.cells); });
  if (!defects.empty()) return defects;
  const DualMesh dual = build_dual(part_.mesh(), result.diagram);
  for (const std::size_t i : find_flipped_triangles(part_.mesh(), result.diagram, dual)) {
    const auto& [a, b, c] = dual.faces[i];
    DualDefect defect;
    defect.property = DualProperty::not_flipped;
    defect.cells = {a, b, c};
    defect.branch_point = dual.branch_points[i];
    if (are_all(result.inner, defect.cells)) defects.push_back(std::move(defect));
  }
  return defects;
}

}  // namespace gvd
