#include <clocale>

#include "io/generators/generator_fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test {

TEST_CASE("a written list reads back bit by bit") {
  std::setlocale(LC_ALL, "de_DE.UTF-8");
  std::mt19937 random(5);
  for (const auto& [name, mesh] : small_family()) {
    CAPTURE(name);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 100; ++i) points.push_back(random_point(mesh, random));
    points.push_back(vertex_point(mesh, VertexId(3)));
    for (const GeneratorFormat format : {GeneratorFormat::text, GeneratorFormat::csv, GeneratorFormat::json}) {
      const GeneratorList list = parse(format_generators(mesh, points, format), format);
      CHECK(resolve_generators(mesh, list).points == points);
    }
  }
  std::setlocale(LC_ALL, "C");
}

}  // namespace gvd::test
