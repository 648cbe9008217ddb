#include <algorithm>

#include "io/writers/shading_vertices.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_shading_vertices {

using namespace io;

ShadingVertices split(const Mesh& mesh, const IdVector<FaceId, GeneratorId>* label = nullptr) {
  LabelledMesh labelled{mesh};
  labelled.face_label = label;
  return split_shading_vertices(mesh, label, collect_regions(labelled));
}

/// Two triangles with a common edge, the second one turned by an angle in degrees.
Mesh make_hinge(double degrees) {
  const double angle = degrees * 3.14159265358979 / 180;
  return Mesh({{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {std::cos(angle), 0, -std::sin(angle)}},
              {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(1), VertexId(0), VertexId(3)}});
}

TEST_CASE("a vertex is split at creases of more than 40 degrees") {
  CHECK(split(make_hinge(0)).vertices.size() == 4);
  CHECK(split(make_hinge(39)).vertices.size() == 4);
  const ShadingVertices sharp = split(make_hinge(41));
  CHECK(sharp.vertices.size() == 6);
  CHECK(sharp.vertices[sharp.of_corner[HalfedgeId(0)]].normal.z() == Approx(1));
  CHECK(sharp.vertices[sharp.of_corner[HalfedgeId(4)]].normal.z() == Approx(std::cos(41 * 3.14159265358979 / 180)));
}

TEST_CASE("regions have vertices of their own with common normals") {
  const Mesh mesh = test::make_sphere(2);
  IdVector<FaceId, GeneratorId> label;
  for (int f = 0; f < mesh.face_count(); ++f) label.push_back(GeneratorId(f % 5));
  const ShadingVertices result = split(mesh, &label);
  REQUIRE(result.first.size() == 6);
  CHECK(result.first.back() == result.vertices.size());
  for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const std::uint32_t index = result.of_corner[h];
    const std::size_t region = label[Mesh::face(h)].index();
    CHECK((result.first[region] <= index && index < result.first[region + 1]));
    CHECK(result.vertices[index].vertex == mesh.from(h));
    // On a fine sphere the normal is the position.
    const Vec3 normal = result.vertices[index].normal.cast<double>();
    CHECK(normal.dot(mesh.position(mesh.from(h)).normalized()) > 0.995);
    for (const ShadingVertex& other : result.vertices) {
      if (other.vertex == mesh.from(h)) CHECK(other.normal == result.vertices[index].normal);
    }
  }
}

TEST_CASE("a mesh with one region keeps its vertices, in the order of its faces") {
  const Mesh mesh = test::make_sphere(2);
  const ShadingVertices result = split(mesh);
  CHECK(result.vertices.size() == mesh.positions().size());
  CHECK(result.first == std::vector<std::uint32_t>{0, static_cast<std::uint32_t>(mesh.vertex_count())});
  CHECK(result.of_corner[HalfedgeId(0)] == 0);
}

TEST_CASE("faces without area have the normals of their neighbours, or the z axis") {
  const Mesh flat({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const ShadingVertex& vertex : split(flat).vertices) CHECK(vertex.normal == Eigen::Vector3f(0, 0, 1));
  const Mesh pair({{0, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0.5, 0}},
                  {{VertexId(0), VertexId(1), VertexId(2)}, {VertexId(1), VertexId(0), VertexId(3)}});
  const ShadingVertices result = split(pair);
  CHECK(result.vertices.size() == 4);
  CHECK(result.vertices[result.of_corner[HalfedgeId(4)]].normal == Eigen::Vector3f(1, 0, 0));
}

}  // namespace gvd::test_shading_vertices
