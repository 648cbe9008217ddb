#include "apps/common/steps/run_fixture.hpp"
#include "common/steps/build_diagram.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_build_diagram {

using namespace app;
using gvd::test::QuietRun;

TEST_CASE("a diagram is computed as the options say, timed and reported") {
  const Mesh mesh = test::make_torus(24, 12);
  const std::vector<SurfacePoint> generators{vertex_point(mesh, VertexId(0)), vertex_point(mesh, VertexId(40)),
                                             vertex_point(mesh, VertexId(150))};
  for (const Method method : {Method::exact, Method::gbgvd}) {
    Options options;
    options.compute.method = method;
    QuietRun quiet(options);
    const Diagram diagram = build_diagram(quiet.run, mesh, generators);
    DiagramOptions expected;
    expected.method = method;
    CHECK(diagram.length == compute_diagram(mesh, generators, expected).length);
    const auto report = quiet.report();
    CHECK(report["diagram"]["cells"] == 3);
    CHECK(report["diagram"]["length"] == diagram.length);
    CHECK(report["timings_ms"].contains("diagram"));
  }
}

}  // namespace gvd::test_build_diagram
