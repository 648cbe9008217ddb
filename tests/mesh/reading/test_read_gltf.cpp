#include <fmt/format.h>

#include "gvd/soup.hpp"
#include "gvd/text.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"

namespace gvd::test_read_gltf {

using namespace test;

PolygonSoup parse(const std::string& description) {
  return parse_soup(glb_of(description, glb_numbers()), MeshFormat::glb, "file");
}

TEST_CASE("glb: indices of 8, 16 and 32 bits, and none") {
  for (const int indices : {1, 2, 3}) {
    INFO(indices);
    require_tetrahedron(parse(glb_description(indices)));
  }
  // Without indices each three vertices are a triangle.
  const PolygonSoup soup =
      parse(replaced(replaced(glb_description(1), ",\"indices\":1", ""), "\"count\":4", "\"count\":3"));
  CHECK(soup.corners == std::vector<std::int32_t>{0, 1, 2});
}

TEST_CASE("glb: nodes move their meshes, by matrices and by translation, rotation and scale") {
  // A quarter turn about z takes (1, 1, 0) to (-1, 1, 0); doubled it is (-2, 2, 0), and the parent moves it by (0, 0,
  // 5).
  const std::string nodes = R"([{"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,5,1],"children":[1]},)"
                            R"({"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,2,2]}])";
  const PolygonSoup soup = parse(glb_description(2, nodes));
  REQUIRE(soup.positions.size() == 4);
  CHECK((soup.positions[1] - Vec3(-2, 2, 5)).norm() < 1e-12);
  CHECK((soup.positions[2] - Vec3(0, 2, 7)).norm() < 1e-12);
}

TEST_CASE("glb: a mesh in two nodes comes twice, and a mirror turns its triangles round") {
  const std::string nodes = R"([{"children":[1,2]},{"mesh":0},{"mesh":0,"translation":[9,0,0],"scale":[-1,1,1]}])";
  const PolygonSoup soup = parse(glb_description(2, nodes));
  REQUIRE(soup.polygon_count() == 8);
  CHECK(soup.positions[5] == Vec3(8, 1, 0));
  CHECK(std::vector(soup.polygon(4).begin(), soup.polygon(4).end()) == std::vector<std::int32_t>{4, 6, 5});
  CHECK(compute_mesh_summary(build_mesh(soup).mesh).components == 2);
}

TEST_CASE("glb: strips and fans become triangles, points and lines are left out") {
  const auto with_mode = [](int mode) {
    return replaced(glb_description(1), "\"indices\":1", "\"mode\":" + std::to_string(mode));
  };
  CHECK(parse(with_mode(5)).corners == std::vector<std::int32_t>{0, 1, 2, 1, 3, 2});
  CHECK(parse(with_mode(6)).corners == std::vector<std::int32_t>{0, 1, 2, 0, 2, 3});
  const PolygonSoup soup = parse(
      replaced(glb_description(1), "\"indices\":1}", "\"indices\":1},{\"attributes\":{\"POSITION\":0},\"mode\":1}"));
  require_tetrahedron(soup);
  CHECK(soup.notes == std::vector<std::string>{"1 list of points or lines is left out"});
}

TEST_CASE("glb: a scene chooses its nodes, without scenes all are roots") {
  const std::string unscened = replaced(glb_description(1), R"("scenes":[{"nodes":[0]}],)", "");
  require_tetrahedron(parse(unscened));
  require_tetrahedron(parse(replaced(unscened, R"("nodes":[{"mesh":0}],)", "")));
  require_refused(glb_of(replaced(glb_description(1), R"({"nodes":[0]})", "{}"), glb_numbers()), MeshFormat::glb,
                  "no face");
}

TEST_CASE("glb: quantized and interleaved positions are read") {
  // Positions as normalized 16-bit numbers, 8 bytes from one to the next.
  std::string numbers;
  for (const Vec3& p : parse_soup(kOff, MeshFormat::off, "off").positions) {
    for (const double x : p) numbers += bytes_of(static_cast<std::uint16_t>(x * 65535));
    numbers += "..";
  }
  std::string description =
      replaced(glb_description(1), R"("componentType":5126)", R"("componentType":5123,"normalized":true)");
  description = replaced(description, R"("byteLength":48})", R"("byteLength":32,"byteStride":8})");
  require_tetrahedron(parse_soup(glb_of(description, numbers + std::string(16, '\0') + glb_numbers().substr(48)),
                                 MeshFormat::glb, "file"));
}

TEST_CASE("glb: normalized signed numbers are clamped to -1") {
  std::string numbers;
  for (const std::array<std::int16_t, 3>& p : std::vector<std::array<std::int16_t, 3>>{
           {-32768, 0, 0}, {-32767, 32767, 0}, {0, 0, 32767}, {16384, 0, -32768}}) {
    for (const std::int16_t x : p) numbers += bytes_of(x);
    numbers += "..";
  }
  std::string description =
      replaced(glb_description(1), R"("componentType":5126)", R"("componentType":5122,"normalized":true)");
  description = replaced(description, R"("byteLength":48})", R"("byteLength":32,"byteStride":8})");
  const PolygonSoup soup = parse_soup(glb_of(description, numbers + std::string(16, '\0') + glb_numbers().substr(48)),
                                      MeshFormat::glb, "file");
  REQUIRE(soup.positions.size() == 4);
  CHECK(soup.positions[0] == Vec3(-1, 0, 0));
  CHECK(soup.positions[1] == Vec3(-1, 1, 0));
  CHECK(soup.positions[3] == Vec3(16384.0 / 32767, 0, -1));
}

TEST_CASE("glb: what is not read is refused in one clear line") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(glb_of(replaced(glb_description(1), from, to), glb_numbers()), MeshFormat::glb, part);
  };
  refused(R"({"asset")", R"({"extensionsRequired":["KHR_draco_mesh_compression"],"asset")",
          "KHR_draco_mesh_compression");
  refused(R"("indices":1)", R"("indices":1,"extensions":{"KHR_draco_mesh_compression":{}})", "compressed by Draco");
  refused(R"("count":4)", R"("count":4,"sparse":{})", "accessor 0 is sparse");
  refused(R"("bufferView":0,)", "", "accessor 0 has no numbers");
  refused(R"({"asset")", R"({"extensionsRequired":["VENDOR_fold"],"asset")",
          "the mesh needs glTF's extension VENDOR_fold, which is not read; export it without");
  refused(R"("buffers":[{)", R"("buffers":[{"uri":"a.bin",)", "buffer 0, 'a.bin', is not in the file");
  refused(R"({"buffer":0,"byteLength":48})", R"({"buffer":1,"byteLength":48})", "there is no item 1 of buffers");
  refused(R"({"version":"2.0"})", R"({"version":"1.0"})", "the file has version '1.0' of glTF, and only 2.0 is read");
  refused(R"({"version":"2.0"})", R"({"version":"2.1","minVersion":"2.1"})", "the file has version '2.1' of glTF");
  refused(R"("count":4)", R"("count":5)", "accessor 0 has 5 elements, and its view has 48 bytes");
  refused(R"("count":4)", R"("count":4000000000000000000)", "accessor 0 has 4000000000000000000 elements");
  refused(R"("count":4)", R"("count":-1)", "'count' is not an index or count");
  refused(R"("count":4)", R"("count":3)", "an index is 3, and there are 3 vertices");
  refused(R"("byteOffset":48)", R"("byteOffset":123)", "view 1 has 12 bytes from 123 on, and buffer 0 has 132");
  refused(R"("POSITION":0)", R"("POSITION":9)", "there is no item 9 of accessors");
  refused(R"("POSITION":0)", R"("NORMAL":0)", "'POSITION' is not an index or count");
  refused(R"("primitives")", R"("primitive")", "the scene's description is damaged");
  refused(R"([{"mesh":0}])", R"([{"mesh":0,"children":[0]}])", "node 0 has two parents");
  refused(R"([{"mesh":0}])", R"([{"mesh":0,"matrix":[1,2]}])", "the scene's description is damaged");
  const auto refused_node = [&](const std::string& member, const std::string& part) {
    refused(R"([{"mesh":0}])", R"([{"mesh":0,)" + member + "}]", part);
  };
  refused_node(R"("rotation":[0,0,0,1,0])",
               "node 0 has a rotation of 5 numbers, and it needs 4; export the file again");
  refused_node(R"("rotation":[])", "node 0 has a rotation of 0 numbers, and it needs 4; export");
  refused_node(R"("translation":[1,2,3,4])", "node 0 has a translation of 4 numbers, and it needs 3; export");
  refused_node(R"("scale":2)", "node 0 has a scale of 1 number, and it needs 3; export");
  refused_node(R"("scale":["a","b","c"])", "the scene's description is damaged");
  refused(R"({"asset")", R"("asset")", "the scene's description is damaged");
  const std::string whole = glb_of(glb_description(1), glb_numbers());
  require_refused(replaced(whole, std::string("glTF\2", 5), std::string("glTF\1", 5)), MeshFormat::glb,
                  "version 1 of glTF");
  for (const std::uint32_t length : {0U, 1U, 11U, 12U}) {
    std::string shortened = whole;
    shortened.replace(8, 4, bytes_of(length));
    require_refused(shortened, MeshFormat::glb,
                    fmt::format("file: the header says that the file has {}, which is no more than the header itself; "
                                "export the file again",
                                counted(length, "byte", "bytes")));
  }
  require_refused(whole.substr(0, whole.size() - 1), MeshFormat::glb,
                  "a chunk should have 132 bytes, and the file has 131");
  std::string infinite = glb_numbers();
  infinite.replace(12, 4, bytes_of(std::numeric_limits<float>::infinity()));
  require_refused(glb_of(glb_description(1), infinite), MeshFormat::glb,
                  "a coordinate of vertex 1 is not a finite number", ErrorCode::precondition);
}

TEST_CASE("glb: lengths, steps and counts that don't fit together are refused, and tell what there is") {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& part) {
    INFO(from << " -> " << to);
    require_refused(glb_of(replaced(glb_description(2), from, to), glb_numbers()), MeshFormat::glb, part);
  };
  const std::string again = "; export the file again";
  refused(R"("byteLength":132})", R"("byteLength":133})", "buffer 0 should have 133 bytes, and has 132" + again);
  refused(R"("byteLength":132})", R"("byteLength":80})", "view 2 has 24 bytes from 60 on, and buffer 0 has 80");
  refused(R"("byteLength":132})", R"("byteLength":-1})", "'byteLength' is not an index or count");
  refused(R"("byteLength":48})", R"("byteLength":47})", "accessor 0 has 4 elements, and its view has 47 bytes");
  refused(R"("byteLength":48})", R"("byteLength":48,"byteStride":8})",
          "accessor 0 has elements of 12 bytes, and its view steps by 8 ('byteStride')" + again);
  refused(
      R"("byteLength":48})", R"("byteLength":56,"byteStride":14})",
      "accessor 0 has numbers of 4 bytes at byte 0 of its buffer and each 14 bytes on, which are no multiples of 4");
  refused(R"({"buffer":0,"byteLength":48})", R"({"buffer":0,"byteOffset":2,"byteLength":50})",
          "accessor 0 has numbers of 4 bytes at byte 2 of its buffer");
  refused(R"("byteOffset":60)", R"("byteOffset":59)", "accessor 2 has numbers of 2 bytes at byte 59 of its buffer");
  refused(R"("componentType":5123,"count":12)", R"("componentType":5123,"count":11)",
          "mesh 0 has a list of triangles with 11 corners, of which the last triangle lacks some" + again);
  refused(R"(,"indices":2)", "", "mesh 0 has a list of triangles with 4 corners, of which");
  refused(R"("componentType":5123,"count":12,"type":"SCALAR")", R"("componentType":5123,"count":4,"type":"VEC3")",
          "accessor 2 has vectors of 3 numbers, and indices are single numbers" + again);
  refused(R"([{"mesh":0}])", R"([{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1, 5]}])",
          "node 0 has a matrix of 17 numbers that is not an affine transform");
  refused(R"([{"mesh":0}])", R"([{"mesh":0,"matrix":[1,0,0,1, 0,1,0,0, 0,0,1,0, 0,0,0,1]}])",
          "node 0 has a matrix of 16 numbers that is not an affine transform: it needs 16, and the last row 0 0 0 1" +
              again);
  refused(R"([{"mesh":0}])", R"([{"mesh":0,"rotation":[0,0,0,0]}])", "node 0 has a rotation of length 0" + again);
  refused(R"("indices":2)", R"("indices":2,"mode":7)", "mesh 0 has the unknown mode 7" + again);
  const auto with_mode = [](int mode, int count) {
    const std::string two =
        replaced(glb_description(2), "\"indices\":2", "\"indices\":2,\"mode\":" + std::to_string(mode));
    return glb_of(
        replaced(two, R"("componentType":5123,"count":12)", R"("componentType":5123,"count":)" + std::to_string(count)),
        glb_numbers());
  };
  require_refused(with_mode(5, 2), MeshFormat::glb, "mesh 0 has a strip of triangles with 2 corners");
  require_refused(with_mode(6, 1), MeshFormat::glb, "mesh 0 has a fan of triangles with 1 corner,");
  std::string longer = glb_of(glb_description(2), glb_numbers());
  longer.replace(8, 4, bytes_of(static_cast<std::uint32_t>(longer.size() + 4)));
  require_refused(longer, MeshFormat::glb,
                  "the header says that the file has " + std::to_string(longer.size() + 4) + " bytes, and it has " +
                      std::to_string(longer.size()) + "; copy it again");
  // A chunk is padded, a file may be followed by other bytes, and a step of 0 is none.
  const std::string whole =
      glb_of(replaced(glb_description(2), R"("byteLength":132})", R"("byteLength":131})"), glb_numbers());
  require_tetrahedron(parse_soup(whole + "more", MeshFormat::glb, "file"));
  require_tetrahedron(parse(replaced(glb_description(2), R"("byteLength":48})", R"("byteLength":48,"byteStride":0})")));
}

TEST_CASE("glb: required extensions that leave the triangles as they are do not matter") {
  for (const std::string name : {"KHR_mesh_quantization", "KHR_materials_unlit", "KHR_texture_basisu"}) {
    require_tetrahedron(
        parse(replaced(glb_description(1), R"({"asset")", R"({"extensionsRequired":[")" + name + R"("],"asset")")));
  }
  const PolygonSoup soup =
      parse(replaced(glb_description(1), R"({"asset")", R"({"extensionsUsed":["KHR_texture_transform"],"asset")"));
  CHECK(soup.appearance.unread == std::vector<std::string>{"transforms of texture coordinates"});
}

TEST_CASE("gltf: JSON with its numbers in Base64 is read, and told from other JSON") {
  require_tetrahedron(parse_soup(kGltf, MeshFormat::gltf, "file"));
  require_tetrahedron(parse_soup("\xEF\xBB\xBF \n" + kGltf, MeshFormat::gltf, "file"));
  require_tetrahedron(parse_soup(kGltf, MeshFormat::glb, "file"));
  require_tetrahedron(parse_soup(glb_of(kGltf, ""), MeshFormat::gltf, "file"));
  CHECK(detect_format(kGltf, "a.txt") == MeshFormat::gltf);
  CHECK_FALSE(detect_format("{}", "a.txt"));
  require_refused(glb_description(1), MeshFormat::gltf, "buffer 0 has no address");
  require_refused("glXX", MeshFormat::gltf, "the file begins neither with 'glTF' nor, as JSON, with '{'");
}

TEST_CASE("gltf: several buffers, each in its own way") {
  const std::string first = glb_numbers().substr(0, 48);
  std::string text = replaced(kGltf, R"({"buffer":0,"byteLength":48})", R"({"buffer":1,"byteLength":48})");
  // (0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1)
  text = replaced(
      text, R"("byteLength":132}])",
      R"("byteLength":132},{"uri":"data:;base64,AAAAAAAAAAAAAAAAAACAPwAAgD8AAAAAAACAPwAAAAAAAIA/AAAAAAAAgD8AAIA/","byteLength":48}])");
  REQUIRE(first.size() == 48);
  require_tetrahedron(parse_soup(text, MeshFormat::gltf, "file"));
}

TEST_CASE("glb: instances are counted, so that a small file can't take all memory") {
  std::string nodes = R"([{"children":[)", instances;
  for (int i = 1; i <= 40000; ++i) {
    nodes += (i > 1 ? "," : "") + std::to_string(i);
    instances += R"(,{"mesh":0})";
  }
  // 12 bytes of the binary chunk are a million corners.
  std::string description = glb_description(1, nodes + "]}" + instances + "]");
  description = replaced(description, R"("count":12)", R"("count":100002)");
  description = replaced(description, R"("byteOffset":48,"byteLength":12)", R"("byteOffset":132,"byteLength":100002)");
  description = replaced(description, R"("byteLength":132}])", R"("byteLength":100134}])");
  require_refused(glb_of(description, glb_numbers() + std::string(100002, '\0')), MeshFormat::glb,
                  "expands to more than 200 times its size");
}

}  // namespace gvd::test_read_gltf
