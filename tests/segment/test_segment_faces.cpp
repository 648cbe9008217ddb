#include "segment_faces.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_segment_faces {

IdVector<FaceId, GeneratorId> make_labels(const std::vector<int>& labels) {
  IdVector<FaceId, GeneratorId> result;
  for (const int label : labels) result.push_back(GeneratorId(label));
  return result;
}

TEST_CASE("label components: faces without a label belong to none") {
  const Mesh mesh = test::make_triangle();
  const LabelComponents found = find_label_components(mesh, make_labels({-1}));
  CHECK(found.components.empty());
  CHECK(found.component[FaceId(0)] == -1);
}

TEST_CASE("label components: a common vertex does not connect faces") {
  // Two squares of two faces each; faces 0 and 2 share a vertex, and no edge.
  const Mesh mesh = test::make_grid(2, 1);
  REQUIRE(mesh.face_count() == 4);
  const LabelComponents split = find_label_components(mesh, make_labels({7, 2, 7, 2}));
  int sevens = 0;
  for (const auto& c : split.components) sevens += c.label == GeneratorId(7);
  CHECK(sevens == 2);
  CHECK(split.component[FaceId(0)] == 0);
  const LabelComponents whole = find_label_components(mesh, make_labels({7, 7, 7, 7}));
  REQUIRE(whole.components.size() == 1);
  CHECK(whole.components[0].area == Approx(2));
}

TEST_CASE("label components: on every family, areas sum up and adjacent faces of one label share a component") {
  for (const auto& [name, mesh] : test::small_family()) {
    CAPTURE(name);
    test::Random random(4);
    IdVector<FaceId, GeneratorId> label;
    for (int f = 0; f < mesh.face_count(); ++f) label.push_back(GeneratorId(random.below(4) - 1));
    const LabelComponents found = find_label_components(mesh, label);
    double area = 0, labelled = 0;
    for (const auto& c : found.components) area += c.area;
    std::int32_t seen = -1;
    for (int f = 0; f < mesh.face_count(); ++f) {
      const std::int32_t c = found.component[FaceId(f)];
      REQUIRE((c >= 0) == label[FaceId(f)].valid());
      if (c < 0) continue;
      labelled += mesh.area(FaceId(f));
      CHECK(found.components[c].label == label[FaceId(f)]);
      CHECK(c <= seen + 1);  // numbered in the order of their first face
      seen = std::max(seen, c);
      for (int corner = 0; corner < 3; ++corner) {
        const HalfedgeId twin = mesh.twin(Mesh::halfedge(FaceId(f), corner));
        if (!twin.valid() || label[Mesh::face(twin)] != label[FaceId(f)]) continue;
        CHECK(found.component[Mesh::face(twin)] == c);
      }
    }
    CHECK(area == Approx(labelled));
  }
}

/// A diagram without pieces, and a segmentation that gives every face to `label`.
struct Case {
  Mesh mesh;
  Diagram diagram;
  Segmentation result;

  Case(Mesh m, const std::vector<SurfacePoint>& generators, int label) : mesh(std::move(m)) {
    diagram.generators = generators;
    diagram.face_label.assign(static_cast<std::size_t>(mesh.face_count()), GeneratorId(label));
    result.face_label = diagram.face_label;
  }
  void run() { assign_missing_faces(mesh, diagram, FaceShares(diagram), result); }
};

TEST_CASE("missing faces: nothing changes where every generator owns a face") {
  const Mesh grid = test::make_grid(1, 1);
  Case c(grid, {vertex_point(grid, VertexId(0))}, 0);
  c.run();
  CHECK(c.result.face_label == c.diagram.face_label);
  CHECK(c.result.given_faces == 0);
  CHECK(c.result.without_face.empty());
}

TEST_CASE("missing faces: a label's only face is not taken") {
  const Mesh triangle = test::make_triangle();
  Case c(triangle, {vertex_point(triangle, VertexId(0)), vertex_point(triangle, VertexId(1))}, 1);
  c.run();
  CHECK(c.result.face_label[FaceId(0)] == GeneratorId(1));
  CHECK(c.result.without_face == std::vector<GeneratorId>{GeneratorId(0)});
}

TEST_CASE("missing faces: a generator gets the face that it lies in") {
  const Mesh grid = test::make_grid(3, 3);
  const FaceId own(7);
  Case c(grid, {vertex_point(grid, VertexId(0)), make_surface_point(own, {0.2, 0.3, 0.5})}, 0);
  c.run();
  CHECK(c.result.face_label[own] == GeneratorId(1));
  CHECK(c.result.given_faces == 1);
}

TEST_CASE("missing faces: a face whose loss would disconnect its label is not taken") {
  // A strip of faces: every inner one connects the two sides.
  const Mesh strip = test::make_grid(4, 1);
  for (int f = 0; f < strip.face_count(); ++f) {
    int neighbours = 0;
    for (int corner = 0; corner < 3; ++corner) neighbours += strip.twin(Mesh::halfedge(FaceId(f), corner)).valid();
    CAPTURE(f, neighbours);
    Case c(strip, {vertex_point(strip, VertexId(0)), make_surface_point(FaceId(f), {0.2, 0.3, 0.5})}, 0);
    c.run();
    CHECK((c.result.face_label[FaceId(f)] == GeneratorId(1)) == (neighbours == 1));
    CHECK(c.result.without_face.empty() == (neighbours == 1));
  }
}

TEST_CASE("missing faces: on a closed surface the label stays connected round the other side") {
  const Mesh mesh = test::make_tetrahedron();
  std::vector<SurfacePoint> generators;
  for (int f = 0; f < 4; ++f) generators.push_back(make_surface_point(FaceId(f), {0.2, 0.3, 0.5}));
  Case c(mesh, generators, 3);
  c.run();
  for (int f = 0; f < 4; ++f) CHECK(c.result.face_label[FaceId(f)] == GeneratorId(f));
  CHECK(c.result.given_faces == 3);
}

TEST_CASE("missing faces: without its own face a generator gets that of its largest share that can be given") {
  // Faces 1 0 3 2 are a strip. The generator lies in face 0, whose loss would disconnect the strip, as that of face 3
  // would; of the two ends, face 2 has the larger share.
  const Mesh grid = test::make_grid(2, 1);
  Case c(grid, {vertex_point(grid, VertexId(0)), make_surface_point(FaceId(0), {0.2, 0.3, 0.5})}, 0);
  const auto share = [](int face, double t) {
    return FacePiece{FaceId(face), GeneratorId(1), {{1, 0, 0}, {1 - t, t, 0}, {1 - t, 0, t}}};
  };
  c.diagram.pieces = {share(0, 0.2), share(1, 0.3), share(2, 0.4), share(3, 0.5)};
  c.run();
  CHECK(c.result.given_faces == 1);
  CHECK(c.result.face_label[FaceId(2)] == GeneratorId(1));
  CHECK(c.result.face_label[FaceId(1)] == GeneratorId(0));
}

}  // namespace gvd::test_segment_faces
