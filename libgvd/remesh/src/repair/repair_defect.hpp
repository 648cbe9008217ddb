#pragma once

#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/dual.hpp"
#include "gvd/mesh.hpp"
#include "repair/added_generators.hpp"
#include "repair/boundary_arcs.hpp"
#include "repair/cell_loops.hpp"
#include "repair/tip_rings.hpp"

namespace gvd {

/// Adds the generators that repair one defect of a dual. The table in propose_generators.hpp says where they go.
class DefectRepair {
 public:
  /// All three must outlive the repair.
  DefectRepair(const Mesh& mesh, const Diagram& diagram, AddedGenerators& added)
      : mesh_(mesh), diagram_(diagram), added_(added) {}

  /// Adds nothing where no candidate is far enough from the other generators.
  void repair(const DualDefect& defect);

  /// The tip at which the defect can't be repaired, because the surface round it is too narrow.
  std::optional<NarrowTip> find_narrow_tip(const DualDefect& defect);

 private:
  void add_to_component(std::int32_t component);
  void split_loop(GeneratorId g);
  void split_boundary_arcs(GeneratorId g);
  void split_bisector(const Bisector& b);
  void split_pair(GeneratorId a, GeneratorId b);
  void split_triple(BranchPointId branch);
  void split_polygon(BranchPointId branch);
  void add_farthest(GeneratorId g);

  CellLoops* cell_loops();
  const TipRings& rings();
  /// Euclidean, from a generator of the diagram.
  double distance(const SurfacePoint& point, GeneratorId g) const {
    return (position(mesh_, point) - added_.position_of(g)).norm();
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  AddedGenerators& added_;
  std::optional<TipRings> rings_;
  std::optional<CellLoops> loops_;
  bool can_cut_ = true;  // the mesh can be cut along the bisectors, as far as is known
  std::optional<std::vector<BoundaryArc>> arcs_;
};

}  // namespace gvd
