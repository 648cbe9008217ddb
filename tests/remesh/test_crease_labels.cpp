// The labels along edges, on every mesh of the family.
#include <algorithm>

#include "edge_labels.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_crease_labels {

TEST_CASE("edge labels: they cover every edge from both faces, and agree with the vertices") {
  for (const auto& [name, mesh] : test::small_family()) {
    INFO(name);
    const Diagram diagram = compute_diagram(mesh, test::random_generators(mesh, 12, 2));
    for (std::int32_t i = 0; i < mesh.edge_count(); ++i) {
      const HalfedgeId h = mesh.halfedge(EdgeId(i));
      const std::vector<LabelInterval> parts = label_edge(mesh, diagram, EdgeId(i));
      if (parts.empty()) {
        CHECK_FALSE(diagram.vertex_label[mesh.from(h)].valid());
        continue;
      }
      double sum = 0;
      for (const LabelInterval& part : parts) {
        sum += part.end - part.begin;
        CHECK(part.cell.valid());
      }
      CHECK(sum == Approx(mesh.twin(h).valid() ? 2 : 1).epsilon(1e-9));
      const GeneratorId first = diagram.vertex_label[mesh.from(h)];
      const auto begins_with = [first](const LabelInterval& part) { return part.begin == 0 && part.cell == first; };
      CHECK(std::any_of(parts.begin(), parts.end(), begins_with));
    }
  }
}

}  // namespace gvd::test_crease_labels
