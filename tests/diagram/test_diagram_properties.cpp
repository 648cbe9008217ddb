// Properties of the diagram over the mesh families and seeded generators.
#include <random>

#include "gvd/check.hpp"
#include "gvd/diagram.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"
#include "support/sanitized.hpp"

namespace gvd::test_diagram_properties {

TEST_CASE("the diagram is complete and sound on every family, for few and for many generators") {
  for (const auto& [name, mesh] : test::small_family()) {
    for (const int count : test::thinned({1, 2, 3, 5, 30, 100, 300})) {
      for (const unsigned seed : test::thinned({0u, 1u, 2u, 3u})) {
        for (const Front front : {Front::circle, Front::planar}) {
          INFO(name << ", " << count << " generators, seed " << seed
                    << (front == Front::circle ? ", circle" : ", planar"));
          const auto generators = test::random_generators(mesh, count, seed);
          DiagramOptions options;
          options.method = Method::gbgvd;
          options.front = front;
          const Diagram diagram = compute_diagram(mesh, generators, options);
          const DiagramCheck check = check_diagram(mesh, diagram);
          for (const std::string& violation : check.violations) UNSCOPED_INFO(violation);
          REQUIRE(check.ok());
        }
      }
    }
  }
}

}  // namespace gvd::test_diagram_properties
