#include <clocale>
#include <cstdlib>
#include <fstream>

#include "io/generators/generator_fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_format_generators {

using namespace test;

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

// Hidden: tests/formats/check_schemas.py asks for it.
TEST_CASE("write a list as JSON to the file that GVD_LIST_SAMPLE names", "[.list]") {
  const char* file = std::getenv("GVD_LIST_SAMPLE");
  REQUIRE(file != nullptr);
  const Mesh mesh = make_sphere(1);
  std::ofstream(file) << format_generators(
      mesh, {vertex_point(mesh, VertexId(3)), make_surface_point(FaceId(5), {0.25, 0.25, 0.5})}, GeneratorFormat::json);
}

}  // namespace gvd::test_format_generators
