#include "label_components.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"
#include "support/random.hpp"
#include "support/tiny_meshes.hpp"

namespace gvd::test_label_components {

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

}  // namespace gvd::test_label_components
