#include "diagram/evaluation/check_bisectors.hpp"
#include "diagram/evaluation/check_generators.hpp"
#include "diagram/evaluation/check_ids.hpp"
#include "diagram/evaluation/check_partition.hpp"
#include "diagram/evaluation/check_topology.hpp"
#include "diagram/evaluation/reached_faces.hpp"
#include "diagram/evaluation/violations.hpp"
#include "gvd/check.hpp"

namespace gvd {

DiagramCheck check_diagram(const Mesh& mesh, const Diagram& diagram) {
  Violations violations;
  check_ids(mesh, diagram, violations);
  if (!violations.empty()) return {violations.take()};
  const ReachedFaces reached(mesh, diagram.generators);
  check_partition(mesh, diagram, reached, violations);
  check_generators(mesh, diagram, violations);
  check_bisectors(mesh, diagram, violations);
  check_topology(mesh, diagram, reached, violations);
  return {violations.take()};
}

}  // namespace gvd
