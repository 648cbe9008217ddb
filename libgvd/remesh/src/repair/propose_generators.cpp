#include "repair/propose_generators.hpp"

#include <algorithm>

#include "repair/added_generators.hpp"
#include "repair/mesh_part.hpp"
#include "repair/repair_defect.hpp"

namespace gvd {
namespace {

bool any_set(const CellFlags& flags, const std::vector<GeneratorId>& cells) {
  return std::any_of(cells.begin(), cells.end(), [&](GeneratorId g) { return flags[g] != 0; });
}

/// Whether this call has repaired a defect of the same cells already. A cell with too few neighbours also waits for the
/// repairs of its neighbours.
bool is_repaired(const CellFlags& repaired, const Diagram& diagram, const DualDefect& defect) {
  return any_set(repaired, defect.cells) || (defect.property == DualProperty::enough_neighbours &&
                                             any_set(repaired, diagram.cells[defect.cells[0]].neighbours));
}

}  // namespace

ProposedGenerators propose_generators(const Mesh& mesh, const Diagram& diagram, const std::vector<DualDefect>& defects,
                                      std::size_t max_count) {
  ProposedGenerators proposed;
  AddedGenerators added(mesh, diagram.generators, max_count);
  DefectRepair repair(mesh, diagram, added);
  CellFlags repaired(diagram.generators.size(), 0);
  for (const DualDefect& defect : defects) {
    if (added.is_full()) break;
    if (is_repaired(repaired, diagram, defect)) continue;
    const std::size_t before = added.size();
    proposed.narrow = repair.find_narrow_tip(defect);
    if (proposed.narrow) return proposed;
    repair.repair(defect);
    if (added.size() == before) continue;
    for (const GeneratorId g : defect.cells) repaired[g] = 1;
  }
  proposed.points = added.take();
  return proposed;
}

}  // namespace gvd
