#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/view_sample.hpp"
#include "io/view/view_template.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_view_page {

using namespace test;

nlohmann::json read_manifest(const std::string& page) {
  const std::string tag = "<script type=\"application/json\" id=\"manifest\">";
  const std::size_t first = page.find(tag) + tag.size();
  return nlohmann::json::parse(page.substr(first, page.find("</script>", first) - first));
}

bool has_viewer_or_skip() {
  if (!has_viewer()) WARN("skipped: built without the viewer");
  return has_viewer();
}

std::string with_title(const std::string& title) {
  const Mesh mesh = make_sphere(0);
  ViewScene scene;
  scene.mesh = &mesh;
  ViewOptions options;
  options.title = title;
  return make_view_page(scene, options);
}

/// The error that refuses the scene; `interrupted`, which make_view_page never throws, where none does.
Error refusal(const ViewScene& scene) {
  try {
    make_view_page(scene);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::interrupted, "");
}

ErrorCode code_of(const ViewScene& scene) { return refusal(scene).code(); }

TEST_CASE("a build without the viewer says so") {
  if (has_viewer()) return;
  const Mesh mesh = make_sphere(0);
  ViewScene scene;
  scene.mesh = &mesh;
  CHECK(code_of(scene) == ErrorCode::invalid_option);
  CHECK(std::string(refusal(scene).what()).find("built without the viewer") != std::string::npos);
}

TEST_CASE("a page is self-contained and carries the licence of what it is made of") {
  if (!has_viewer_or_skip()) return;
  const std::string page = with_title("A title");
  CHECK(page.find("<title>A title</title>") != std::string::npos);
  CHECK(page.find(io::kViewTitleMark) == std::string::npos);
  CHECK(page.find(io::kViewDataMark) == std::string::npos);
  CHECK(page.find("default-src 'none'") != std::string::npos);
  CHECK(page.find("<link", page.find("<link rel=\"icon\" href=\"data:") + 1) == std::string::npos);
  CHECK(page.find("<script src") == std::string::npos);
  CHECK(page.find("Permission is hereby granted, free of charge") != std::string::npos);
}

TEST_CASE("a title can't break out of the page") {
  if (!has_viewer_or_skip()) return;
  const std::string title = "a & b</title></script><b>\"'<!--", page = with_title(title);
  CHECK(page.find("</title></script>") == std::string::npos);
  CHECK(read_manifest(page)["title"] == title);
  CHECK(read_manifest(with_title("\xC3\x28"))["title"] == "\xEF\xBF\xBD(");
}

TEST_CASE("the same diagram gives the same bytes, and its figures") {
  if (!has_viewer_or_skip()) return;
  const Mesh mesh = make_sphere(3);
  const Diagram diagram = make_sphere_sample(mesh, 24);
  const std::string page = make_view_page(make_view_scene("Sphere", mesh, diagram));
  CHECK(page == make_view_page(make_view_scene("Sphere", mesh, diagram)));
  const nlohmann::json manifest = read_manifest(page), scene = manifest["scenes"][0];
  CHECK(manifest["schema"] == "gvd-view/1");
  CHECK(scene["faces"]["count"] == 3 * mesh.face_count());
  CHECK(scene["positions"]["count"] == 3 * mesh.vertex_count());
  CHECK(scene["cells"].size() == 24);
  CHECK(scene["bisectors"]["counts"]["count"] == 66);
  CHECK(scene["figures"].front() == nlohmann::json({"Faces", "1280"}));
  CHECK(scene["figures"].back() == nlohmann::json({"Euler count", "44 of 44"}));
}

TEST_CASE("scenes on one mesh share its arrays") {
  if (!has_viewer_or_skip()) return;
  const Mesh mesh = make_sphere(3);
  const ViewScene first = make_view_scene("24", mesh, make_sphere_sample(mesh, 24));
  const ViewScene second = make_view_scene("12", mesh, make_sphere_sample(mesh, 12));
  const nlohmann::json scenes = read_manifest(make_view_page({first, second}))["scenes"];
  CHECK(scenes[0]["positions"] == scenes[1]["positions"]);
  CHECK(scenes[0]["faces"] == scenes[1]["faces"]);
  CHECK(scenes[0]["codes"] != scenes[1]["codes"]);
}

TEST_CASE("distances from another surface have lattices of 16 bits, and overlays share the arrays of their scene") {
  if (!has_viewer_or_skip()) return;
  const Mesh coarse = make_sphere(0), fine = make_sphere(2);
  const std::vector<ViewScene> given{make_remesh_sample(coarse, fine), make_remesh_sample(fine, coarse)};
  const nlohmann::json scenes = read_manifest(make_view_page(given))["scenes"];
  CHECK(scenes[0]["overlay"]["positions"] == scenes[1]["positions"]);
  CHECK(scenes[0]["overlay"]["faces"] == scenes[1]["faces"]);
  CHECK(scenes[1]["overlay"]["positions"] == scenes[0]["positions"]);
  CHECK(scenes[0]["vertex_generators"] == scenes[0]["positions"]);
  const auto& distance = scenes[0]["surface_distance"];
  CHECK(distance["other"] == "the other sphere");
  CHECK(distance["vertices"]["count"] == 12);
  CHECK(distance["steps"]["type"] == "u8");
  CHECK(distance["lattice"]["type"] == "u16");
  CHECK(distance["lattice"]["count"] == given[0].surface_distance->samples.lattice.size());
  CHECK(distance["lattice_unit"].get<double>() * 65535 == Approx(kSampleBump));
}

TEST_CASE("a page of a large mesh takes less than 25 bytes a face") {
  if (!has_viewer_or_skip()) return;
  const Mesh mesh = make_sphere(6);
  ViewScene scene = make_view_scene("", mesh, make_sphere_sample(mesh, 30));
  const std::size_t size = make_view_page(scene).size() - io::view_template().size();
  INFO("bytes a face: " << double(size) / mesh.face_count());
  CHECK(size < 25u * static_cast<std::size_t>(mesh.face_count()));
}

TEST_CASE("meshes of any size and place stay finite in the page") {
  if (!has_viewer_or_skip()) return;
  for (const double scale : {1e-60, 1.0, 1e60}) {
    const Mesh unit = make_sphere(1);
    std::vector<Vec3> positions = unit.positions();
    std::vector<std::array<VertexId, 3>> faces;
    for (Vec3& p : positions) p = scale * (p + Vec3(1000, 0, 0));
    for (int f = 0; f < unit.face_count(); ++f) faces.push_back(unit.vertices(FaceId(f)));
    const Mesh mesh(std::move(positions), std::move(faces));
    ViewScene scene;
    scene.mesh = &mesh;
    const nlohmann::json manifest = read_manifest(make_view_page(scene));
    CHECK(manifest["scale"].get<double>() == Approx(1.7 * scale).epsilon(0.1));
    CHECK(manifest["origin"][0].get<double>() == Approx(1000 * scale));
  }
}

TEST_CASE("a page refuses scenes that do not fit, and no scenes") {
  if (!has_viewer_or_skip()) return;
  CHECK_THROWS_AS(make_view_page(std::vector<ViewScene>{}), Error);
  CHECK(code_of(ViewScene{}) == ErrorCode::precondition);
}

// Hidden: web/test/run asks for it, to open the page in a browser.
TEST_CASE("write a page with four scenes to the file that GVD_VIEW_SAMPLE names", "[.sample]") {
  const char* file = std::getenv("GVD_VIEW_SAMPLE");
  REQUIRE(file != nullptr);
  REQUIRE(has_viewer());
  const Mesh sphere = make_sphere(4), torus = make_torus(16, 8);
  ViewScene first = make_view_scene("24 generators", sphere, make_sphere_sample(sphere, 24));
  ViewScene second = make_view_scene("60 generators", sphere, make_sphere_sample(sphere, 60));
  ViewScene third;
  third.name = "A torus";
  third.mesh = &torus;
  third.wireframe = true;
  third.figures = {{"Faces", "256"}};
  third.generators = {torus.position(VertexId(0)), torus.position(VertexId(40))};
  third.added_generators = {torus.position(VertexId(4))};
  for (int i = 0; i < 128; i += 8)
    third.borders.push_back({torus.position(VertexId(i)), torus.position(VertexId(i + 1))});
  const Mesh coarse = make_sphere(0);
  ViewScene fourth = make_remesh_sample(coarse, sphere);
  fourth.name = "A remesh";
  ViewOptions options;
  options.title = "A sample <of the viewer>";
  std::ofstream(file, std::ios::binary) << make_view_page({first, second, third, fourth}, options);
}

}  // namespace gvd::test_view_page
