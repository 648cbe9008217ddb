#include <limits>
#include <string>

#include "gvd/error.hpp"
#include "io/view/view_page.hpp"
#include "io/view/view_sample.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_view_page_checks {

using namespace test;

/// The code of the error that refuses the scene; `interrupted`, which no check uses, where none does.
ErrorCode code_of(const ViewScene& scene) {
  try {
    io::check_view_scene(scene);
  } catch (const Error& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return error.code();
  }
  return ErrorCode::interrupted;
}

TEST_CASE("a scene whose parts do not fit is refused") {
  const Mesh mesh = make_sphere(1);
  const ViewScene good = make_view_scene("", mesh, make_sphere_sample(mesh, 4));
  CHECK_NOTHROW(io::check_view_scene(good));
  CHECK(code_of(ViewScene{}) == ErrorCode::precondition);
  ViewScene bad = good;
  bad.vertex_distance.resize(3);
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.face_label.resize(3);
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.face_label[FaceId(0)] = GeneratorId(4);
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.texture.resize(3);
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.pieces.front().face = FaceId(mesh.face_count());
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.pieces.front().corners.front()[1] = std::numeric_limits<double>::quiet_NaN();
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.added_generators.emplace_back(0, std::numeric_limits<double>::quiet_NaN(), 0);
  CHECK(code_of(bad) == ErrorCode::precondition);
  bad = good;
  bad.bisectors.front().front().x() = std::numeric_limits<double>::infinity();
  CHECK(code_of(bad) == ErrorCode::precondition);
}

TEST_CASE("a scene whose distances from another surface do not fit is refused") {
  const Mesh mesh = make_sphere(0);
  ViewScene good;
  good.mesh = &mesh;
  DistanceSamples& samples = good.surface_distance.emplace().samples;
  samples.at_vertex = IdVector<VertexId, double>(12, 1.0);
  samples.steps = IdVector<FaceId, std::int32_t>(20, 1);
  samples.steps[FaceId(3)] = 2;
  samples.lattice.resize(6, 0.5);
  good.surface_distance->reference = good.surface_distance->scale_end = 1;
  CHECK_NOTHROW(io::check_view_scene(good));
  const auto refused = [&](const auto& change) {
    ViewScene bad = good;
    change(bad, bad.surface_distance->samples);
    return code_of(bad) == ErrorCode::precondition;
  };
  CHECK(refused([](ViewScene&, DistanceSamples& s) { s.at_vertex.resize(3); }));
  CHECK(refused([](ViewScene&, DistanceSamples& s) { s.steps.resize(3); }));
  CHECK(refused([](ViewScene&, DistanceSamples& s) { s.steps[FaceId(0)] = 0; }));
  CHECK(refused([](ViewScene&, DistanceSamples& s) { s.lattice.pop_back(); }));
  CHECK(refused([](ViewScene&, DistanceSamples& s) { s.lattice[2] = -1; }));
  CHECK(refused(
      [](ViewScene&, DistanceSamples& s) { s.at_vertex[VertexId(2)] = std::numeric_limits<double>::infinity(); }));
  CHECK(refused([](ViewScene& bad, DistanceSamples&) { bad.surface_distance->scale_end = 0; }));
  CHECK(refused([](ViewScene& bad, DistanceSamples&) { bad.pieces.push_back({FaceId(0), GeneratorId(0), {}}); }));
  CHECK(refused([](ViewScene& bad, DistanceSamples&) { bad.overlay.emplace(); }));
  CHECK(refused([](ViewScene& bad, DistanceSamples&) { bad.vertex_generators.resize(5, Vec3(0, 0, 0)); }));
}

TEST_CASE("the error names the face that does not fit") {
  const Mesh mesh = make_sphere(1);
  ViewScene scene = make_view_scene("", mesh, make_sphere_sample(mesh, 4));
  scene.face_label[FaceId(17)] = GeneratorId(9);
  try {
    io::check_view_scene(scene);
    FAIL("it was taken");
  } catch (const Error& error) {
    CHECK(error.element() == 17);
    CHECK_THAT(error.what(), Catch::Matchers::Contains("face 17") && Catch::Matchers::Contains("label 9"));
  }
}

}  // namespace gvd::test_view_page_checks
