// The elements that formats share: regions, bisectors as lines, vertices with normals.
#include <algorithm>
#include <cmath>

#include "io/fixture.hpp"
#include "io/writers/format_writers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_mesh_elements {

using namespace io;
using namespace test;

TEST_CASE("regions are ordered by label, the faces without a label come last") {
  const Labelled labelled;
  const std::vector<io::Region> regions = io::collect_regions(labelled.view());
  REQUIRE(regions.size() == 4);
  for (int i = 0; i < 3; ++i) CHECK(regions[std::size_t(i)].label == GeneratorId(i));
  CHECK(!regions[3].label.valid());
  std::size_t faces = 0;
  for (const io::Region& region : regions) {
    CHECK(std::is_sorted(region.faces.begin(), region.faces.end()));
    for (const FaceId f : region.faces) CHECK(labelled.face_label[f] == region.label);
    faces += region.faces.size();
  }
  CHECK(faces == labelled.face_label.size());
}

TEST_CASE("a mesh without labels is one region of all faces") {
  const Labelled labelled;
  const std::vector<io::Region> regions = io::collect_regions({labelled.mesh});
  REQUIRE(regions.size() == 1);
  CHECK(!regions[0].label.valid());
  CHECK(regions[0].faces.size() == static_cast<std::size_t>(labelled.mesh.face_count()));
}

TEST_CASE("regions are named by their label") {
  CHECK(io::region_name(GeneratorId(12)) == "region_12");
  CHECK(io::region_name(GeneratorId()) == "unlabelled");
}

TEST_CASE("a line has the points of its bisector, and a closed one repeats the first") {
  const Labelled labelled;
  const auto lines = io::collect_lines(labelled.view());
  REQUIRE(lines.size() == labelled.diagram.bisectors.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Bisector& bisector = labelled.diagram.bisectors[BisectorId(std::int64_t(i))];
    CHECK(lines[i].left == bisector.left);
    CHECK(lines[i].right == bisector.right);
    REQUIRE(lines[i].points.size() == bisector.points.size() + bisector.closed);
    REQUIRE(lines[i].distance.size() == lines[i].points.size());
    CHECK(lines[i].points.front() == position(labelled.mesh, bisector.points.front()));
    if (bisector.closed) CHECK(lines[i].points.back() == lines[i].points.front());
  }
}

TEST_CASE("the distance is linear in the face, and a vertex without weight has no influence") {
  const Mesh mesh = make_grid(1, 1);
  Diagram diagram;
  diagram.vertex_distance = IdVector<VertexId, double>(std::vector<double>(4, INFINITY));
  const auto& [a, b, c] = mesh.vertices(FaceId(0));
  diagram.vertex_distance[a] = 2;
  diagram.vertex_distance[b] = 6;
  Bisector bisector;
  bisector.points = {make_surface_point(FaceId(0), {0.75, 0.25, 0}), make_surface_point(FaceId(0), {0.5, 0.25, 0.25})};
  diagram.bisectors.push_back(bisector);
  LabelledMesh labelled{mesh};
  labelled.diagram = &diagram;
  const auto distance = io::collect_lines(labelled).at(0).distance;
  CHECK(distance[0] == 3);
  CHECK(distance[1] == INFINITY);
  diagram.vertex_distance = {};
  CHECK(io::collect_lines(labelled).at(0).distance[0] == INFINITY);
}

TEST_CASE("bisectors of one point are left out, and without a diagram there are no lines") {
  Labelled labelled;
  labelled.diagram.bisectors[BisectorId(1)].points.resize(1);
  CHECK(io::collect_lines(labelled.view()).size() == labelled.diagram.bisectors.size() - 1);
  CHECK(io::collect_lines({labelled.mesh}).empty());
}

ShadingVertices split(const Mesh& mesh, const IdVector<FaceId, GeneratorId>* label = nullptr) {
  return split_shading_vertices({mesh, label});
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
  for (std::int32_t i = 0; i < mesh.halfedge_count(); ++i) {
    const HalfedgeId h(i);
    const std::uint32_t index = result.of_corner[h];
    CHECK(result.vertices[index].label == label[Mesh::face(h)]);
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
  std::uint32_t next = 0;
  for (const std::uint32_t index : result.of_corner) {
    CHECK(index <= next);
    next = std::max(next, index + 1);
  }
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

}  // namespace gvd::test_mesh_elements
