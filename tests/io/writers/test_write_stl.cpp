#include "io/fixture.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_write_stl {

using namespace test;

Vec3 take_vector(const std::string& bytes, std::size_t& offset) {
  const double x = take<float>(bytes, offset), y = take<float>(bytes, offset), z = take<float>(bytes, offset);
  return {x, y, z};
}

TEST_CASE("a binary STL has the size, normals and colours that it should") {
  const Labelled labelled;
  const std::string bytes = to_bytes(labelled.view(), MeshFormat::stl);
  CHECK_FALSE(bytes.starts_with("solid"));
  std::size_t offset = 80;
  CHECK(take<std::uint32_t>(bytes, offset) == 24);
  REQUIRE(bytes.size() == 84 + 24 * 50);
  for (int f = 0; f < 24; ++f) {
    CHECK((take_vector(bytes, offset) - Vec3(0, 0, 1)).norm() < 1e-6);
    for (const VertexId v : labelled.mesh.vertices(FaceId(f))) {
      CHECK(take_vector(bytes, offset) == labelled.mesh.position(v).cast<float>().cast<double>());
    }
    const int attribute = take<std::uint16_t>(bytes, offset);
    const Rgb color = color_in(labelled.view(), labelled.face_label[FaceId(f)]);
    CHECK((attribute & 0x8000) != 0);
    CHECK((attribute >> 10 & 31) == color.red / 8);
    CHECK((attribute >> 5 & 31) == color.green / 8);
    CHECK((attribute & 31) == color.blue / 8);
  }
}

TEST_CASE("tiny and flat faces get a finite normal") {
  // Beside a face that floats can tell apart.
  const Mesh mesh({{0, 0, 0}, {1e-200, 0, 0}, {0, 1e-200, 0}, {-1e-200, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 0}},
                  {{VertexId(0), VertexId(1), VertexId(2)},
                   {VertexId(1), VertexId(0), VertexId(3)},
                   {VertexId(4), VertexId(5), VertexId(6)}});
  const std::string bytes = to_bytes(LabelledMesh{mesh}, MeshFormat::stl);
  std::size_t offset = 84;
  CHECK(take_vector(bytes, offset) == Vec3(0, 0, 1));
  offset = 84 + 50;
  CHECK(take_vector(bytes, offset) == Vec3(0, 0, 0));
  offset = 84 + 48;
  CHECK(take<std::uint16_t>(bytes, offset) == 0);
}

}  // namespace gvd::test_write_stl
