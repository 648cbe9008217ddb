#include "diagram/growth/check_growth.hpp"

#include <utility>

#include "diagram/growth/check_gap_arcs.hpp"
#include "diagram/growth/check_gap_nodes.hpp"
#include "diagram/growth/gap_edges.hpp"
#include "diagram/growth/gap_labels.hpp"

namespace gvd {

bool check_growth(const WorkingMesh& working, const NearestLabels& labels, const Crossings& crossings, const Gap& gap,
                  GrownGap& grown) {
  const GapEdges edges(working.mesh(), crossings, gap, grown);
  if (!check_gap_nodes(working.mesh(), crossings, gap, edges, grown) || !edges.are_consistent()) return false;
  auto moved = find_moved_labels(working, labels, edges);
  if (!moved || !check_gap_arcs(working.mesh(), crossings, grown)) return false;
  grown.labels = std::move(*moved);
  return true;
}

}  // namespace gvd
