#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "gvd/diagram.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"
#include "io/view/view_blobs.hpp"
#include "io/view/view_sample.hpp"
#include "io/view/view_template.hpp"
#include "io/view/view_triangulate.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test {
namespace {

double area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return 0.5 * ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()));
}

double area(const std::vector<Vec2>& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += area(Vec2(0, 0), polygon[i], polygon[(i + 1) % polygon.size()]);
  return sum;
}

/// Checks that the triangles are positive and add up to the polygon's area; returns them.
std::vector<std::array<std::uint32_t, 3>> check_triangles(const std::vector<Vec2>& polygon) {
  const auto triangles = io::triangulate_polygon(polygon);
  double sum = 0;
  for (const auto& [i, j, k] : triangles) {
    const double a = area(polygon[i], polygon[j], polygon[k]);
    CHECK(a > 0);
    sum += a;
  }
  CHECK(sum == Approx(area(polygon)).margin(1e-13));
  return triangles;
}

nlohmann::json read_manifest(const std::string& page) {
  const std::string opening = "<script type=\"application/json\" id=\"manifest\">";
  const std::size_t first = page.find(opening) + opening.size();
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

/// The error that refuses the scene; one of a code that make_view_page never uses where it is taken.
Error refusal(const ViewScene& scene) {
  try {
    make_view_page(scene);
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::interrupted, "");
}

ErrorCode code_of(const ViewScene& scene) { return refusal(scene).code(); }

}  // namespace

TEST_CASE("polygons without area have no triangles") {
  CHECK(io::triangulate_polygon({}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {1, 0}}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {1, 0}, {0.5, 0}}).empty());
  CHECK(io::triangulate_polygon({{0, 0}, {0, 0}, {0, 0}, {0, 0}}).empty());
}

TEST_CASE("simple polygons are covered by their triangles") {
  CHECK(check_triangles({{0, 0}, {1, 0}, {0, 1}}).size() == 1);
  CHECK(check_triangles({{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}).size() == 2);
  CHECK(check_triangles({{0, 0}, {0.8, 0}, {0.8, 0.2}, {0.2, 0.2}, {0.2, 0.8}, {0, 0.8}}).size() == 4);  // an L
  CHECK(check_triangles({{0, 0}, {1, 0}, {0.3, 0.3}, {0, 1}}).size() == 2);  // an arrow head
}

TEST_CASE("corners on a straight side and repeated corners keep their triangles") {
  CHECK(check_triangles({{0, 0}, {0.25, 0}, {0.5, 0}, {0.75, 0}, {1, 0}, {0, 1}}).size() == 4);
  CHECK(check_triangles({{0, 0}, {0.5, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}}).size() == 2);
}

TEST_CASE("a polygon that is bridged to its hole is covered") {
  check_triangles({{0, 0}, {0.9, 0}, {0, 0.9}, {0, 0}, {0.1, 0.1}, {0.1, 0.3}, {0.3, 0.1}, {0.1, 0.1}});
}

TEST_CASE("random star-shaped polygons are covered by their triangles") {
  std::mt19937 random(3);
  const auto uniform = [&] { return double(random()) / double(std::mt19937::max()); };
  for (int round = 0; round < 200; ++round) {
    const int n = 3 + round % 40;
    std::vector<Vec2> polygon;
    for (int i = 0; i < n; ++i) {
      const double r = 0.05 + 0.25 * uniform(), angle = 2 * 3.14159265358979 * (i + 0.8 * uniform()) / n;
      polygon.emplace_back(0.3 + r * std::cos(angle), 0.3 + r * std::sin(angle));
    }
    check_triangles(polygon);
  }
}

TEST_CASE("the pieces of diagrams are covered by their triangles") {
  for (const auto& [name, mesh] : small_family()) {
    for (const Method method : {Method::exact, Method::gbgvd}) {
      for (const int count : {3, 50, 800}) {
        INFO(name << ", " << count << " generators, exact: " << (method == Method::exact));
        DiagramOptions options;
        options.method = method;
        double worst = 0;
        for (const FacePiece& piece : compute_diagram(mesh, random_generators(mesh, count, 6), options).pieces) {
          std::vector<Vec2> polygon;
          for (const auto& corner : piece.corners) polygon.emplace_back(corner[1], corner[2]);
          double sum = 0;
          for (const auto& [i, j, k] : io::triangulate_polygon(polygon))
            sum += area(polygon[i], polygon[j], polygon[k]);
          worst = std::max(worst, std::abs(sum - area(polygon)));
        }
        CHECK(worst < 1e-12);
      }
    }
  }
}

TEST_CASE("base64 is that of RFC 4648") {
  CHECK(io::encode_base64("") == "");
  CHECK(io::encode_base64("f") == "Zg==");
  CHECK(io::encode_base64("fo") == "Zm8=");
  CHECK(io::encode_base64("foobar") == "Zm9vYmFy");
  CHECK(io::encode_base64("\xFF\xFE\xFD") == "//79");
}

TEST_CASE("arrays are little-endian, narrow, and stored once") {
  io::ViewBlobs blobs;
  CHECK(blobs.add_integers({1, 255}) == nlohmann::json({{"blob", 0}, {"type", "u8"}, {"count", 2}}));
  CHECK(blobs.add_integers({1, 256}) == nlohmann::json({{"blob", 1}, {"type", "u16"}, {"count", 2}}));
  CHECK(blobs.add_integers({65536}) == nlohmann::json({{"blob", 2}, {"type", "u32"}, {"count", 1}}));
  CHECK(blobs.add_floats({1.0f}) == nlohmann::json({{"blob", 3}, {"type", "f32"}, {"count", 1}}));
  CHECK(blobs.add_integers({1, 256})["blob"] == 1);
  CHECK(blobs.html().find("id=\"blob-1\">" + io::encode_base64(std::string("\1\0\0\1", 4)) + "</script>") !=
        std::string::npos);
  CHECK(blobs.html().find("blob-4") == std::string::npos);
}

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
  CHECK(page.find("<link") == std::string::npos);
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

TEST_CASE("a page of a large mesh takes less than 40 bytes a face") {
  if (!has_viewer_or_skip()) return;
  const Mesh mesh = make_sphere(6);
  ViewScene scene = make_view_scene("", mesh, make_sphere_sample(mesh, 30));
  const std::size_t size = make_view_page(scene).size() - io::view_template().size();
  INFO("bytes a face: " << double(size) / mesh.face_count());
  CHECK(size < 40u * static_cast<std::size_t>(mesh.face_count()));
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

TEST_CASE("a scene whose parts do not fit is refused") {
  if (!has_viewer_or_skip()) return;
  const Mesh mesh = make_sphere(1);
  const ViewScene good = make_view_scene("", mesh, make_sphere_sample(mesh, 4));
  CHECK_NOTHROW(make_view_page(good));
  CHECK_THROWS_AS(make_view_page(std::vector<ViewScene>{}), Error);
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

// Hidden: web/test/run asks for it, to open the page in a browser.
TEST_CASE("write a page with three scenes to the file that GVD_VIEW_SAMPLE names", "[.sample]") {
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
  ViewOptions options;
  options.title = "A sample <of the viewer>";
  std::ofstream(file, std::ios::binary) << make_view_page({first, second, third}, options);
}

}  // namespace gvd::test
