#include <cstring>
#include <sstream>
#include <streambuf>
#include <string>

#include "gvd/error.hpp"
#include "io/fixture.hpp"
#include "io/writers/format_writers.hpp"
#include "support/catch.hpp"
#include "support/meshes.hpp"

namespace gvd::test_mesh_writer {

using namespace test;

constexpr std::array kAllFormats{MeshFormat::ply, MeshFormat::obj, MeshFormat::off, MeshFormat::coff, MeshFormat::stl,
                                 MeshFormat::vtp, MeshFormat::vtu, MeshFormat::glb, MeshFormat::json};

ErrorCode code_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.code();
  }
  FAIL("nothing was thrown");
  return {};
}

/// A stream that refuses everything after `capacity` bytes.
class FullBuffer : public std::streambuf {
 public:
  explicit FullBuffer(std::streamsize capacity) : left_(capacity) {}
  std::streamsize xsputn(const char*, std::streamsize count) override {
    const std::streamsize taken = std::min(count, left_);
    left_ -= taken;
    return taken;
  }

 private:
  std::streamsize left_;
};

TEST_CASE("the extension names the format") {
  CHECK(output_format("a/b.ply") == MeshFormat::ply);
  CHECK(output_format("B.GLB") == MeshFormat::glb);
  CHECK(parse_output_format("vtp") == MeshFormat::vtp);
  CHECK(parse_output_format(".Json") == MeshFormat::json);
  CHECK_FALSE(parse_output_format(""));
  for (const char* name : {"a", "a.txt", "", ".ply", "a.ply.gz"}) {
    CHECK(code_of([&] { output_format(name); }) == ErrorCode::invalid_option);
  }
}

TEST_CASE("two writes give the same bytes, to a stream and to a file") {
  const Labelled labelled;
  const TemporaryFolder folder;
  for (const MeshFormat format : kAllFormats) {
    CHECK(to_bytes(labelled.view(), format) == to_bytes(Labelled().view(), format));
  }
  for (const char* name : {"a.ply", "a.off", "a.coff", "a.stl", "a.vtp", "a.vtu", "a.glb", "a.json"}) {
    write_mesh(folder / name, labelled.view());
    CHECK(read_bytes(folder / name) == to_bytes(labelled.view(), output_format(name)));
  }
}

TEST_CASE("an OBJ comes with its materials, and the old pair stays where it can't") {
  const Labelled labelled;
  const TemporaryFolder folder;
  write_mesh(folder / "a.obj", labelled.view());
  CHECK(folder.names() == std::vector<std::string>{"a.mtl", "a.obj"});
  const std::string text = read_bytes(folder / "a.obj"), materials = read_bytes(folder / "a.mtl");
  CHECK(text.starts_with("mtllib a.mtl\n"));
  for (const char* name : {"region_0", "region_1", "region_2", "unlabelled"}) {
    CHECK(text.find(std::string("\ng ") + name + "\nusemtl " + name + "\nf ") != std::string::npos);
    CHECK(materials.find(std::string("newmtl ") + name + "\nKd ") != std::string::npos);
  }
  const Progress cancel = [](std::string_view, double) { return false; };
  const Mesh large = make_sphere(6);
  const IdVector<FaceId, GeneratorId> labels(static_cast<std::size_t>(large.face_count()), GeneratorId(1));
  LabelledMesh view{large};
  view.face_label = &labels;
  CHECK(code_of([&] { write_mesh(folder / "a.obj", view, cancel); }) == ErrorCode::interrupted);
  CHECK(read_bytes(folder / "a.obj") == text);
  CHECK(read_bytes(folder / "a.mtl") == materials);
  CHECK(folder.names() == std::vector<std::string>{"a.mtl", "a.obj"});
}

TEST_CASE("a plain mesh has no labels, colours or materials in any format") {
  const Mesh mesh = make_sphere(1);
  const TemporaryFolder folder;
  write_mesh(folder / "a.obj", LabelledMesh{mesh});
  CHECK(folder.names() == std::vector<std::string>{"a.obj"});
  const std::string obj = read_bytes(folder / "a.obj");
  CHECK(obj.find("g ") == std::string::npos);
  CHECK(obj.find("mtl") == std::string::npos);
  for (const MeshFormat format :
       {MeshFormat::ply, MeshFormat::coff, MeshFormat::vtp, MeshFormat::vtu, MeshFormat::glb}) {
    const std::string bytes = to_bytes(LabelledMesh{mesh}, format);
    for (const char* word : {"abel\"", " label", "istance", "uchar red", "region", "bisectors", "COFF"}) {
      CHECK(bytes.find(word) == std::string::npos);
    }
  }
}

TEST_CASE("a failing stream is an error in every format, wherever it fails") {
  const Labelled labelled;
  for (const MeshFormat format : kAllFormats) {
    const auto size = static_cast<std::streamsize>(to_bytes(labelled.view(), format).size());
    for (const std::streamsize capacity : {std::streamsize{0}, size / 2, size - 1}) {
      FullBuffer buffer(capacity);
      std::ostream out(&buffer);
      CHECK(code_of([&] { write_mesh(out, labelled.view(), format); }) == ErrorCode::unwritable_output);
    }
  }
}

TEST_CASE("what does not fit together is refused, and no file appears") {
  const Labelled labelled;
  const TemporaryFolder folder;
  const IdVector<FaceId, GeneratorId> short_labels(3);
  const IdVector<VertexId, double> short_distances(3);
  LabelledMesh view{labelled.mesh};
  view.face_label = &short_labels;
  CHECK(code_of([&] { write_mesh(folder / "a.ply", view); }) == ErrorCode::precondition);
  view.face_label = nullptr;
  view.vertex_distance = &short_distances;
  CHECK(code_of([&] { write_mesh(folder / "a.vtp", view); }) == ErrorCode::precondition);
  CHECK(code_of([&] { write_mesh(folder / "a.json", LabelledMesh{labelled.mesh}); }) == ErrorCode::invalid_option);
  CHECK(code_of([&] { write_mesh(folder / "none/a.ply", labelled.view()); }) == ErrorCode::unwritable_output);
  CHECK(folder.names().empty());
}

TEST_CASE("coordinates beyond a 32-bit float are refused where the format has no other") {
  const Mesh mesh({{0, 0, 0}, {1e39, 0, 0}, {0, 1e39, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::glb}) {
    CHECK(code_of([&] { to_bytes(LabelledMesh{mesh}, format); }) == ErrorCode::unwritable_output);
    CHECK(code_of([&] { check_format(mesh, format); }) == ErrorCode::unwritable_output);
  }
  CHECK(to_bytes(LabelledMesh{mesh}, MeshFormat::off).find("1e+39 0 0") != std::string::npos);
  CHECK_NOTHROW(check_format(mesh, MeshFormat::ply));
}

TEST_CASE("a mesh that falls between two 32-bit floats is refused where the format has no other") {
  const auto triangle = [](double at, double size) {
    return Mesh({{at, 0, 0}, {at + size, 0, 0}, {at, size, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  };
  CHECK(code_of([&] { check_format(triangle(1e9, 1), MeshFormat::stl); }) == ErrorCode::unwritable_output);
  CHECK_NOTHROW(check_format(triangle(1e9, 1), MeshFormat::glb));  // which has a translation
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::glb}) {
    CHECK(code_of([&] { check_format(triangle(0, 1e-50), format); }) == ErrorCode::unwritable_output);
    CHECK_NOTHROW(check_format(triangle(1e9, 1e3), format));
    CHECK_NOTHROW(check_format(triangle(0, 1e-30), format));
  }
  CHECK_NOTHROW(check_format(triangle(1e9, 1), MeshFormat::off));
}

Mesh triangle(double size, double shift) {
  return Mesh({{shift, 0, 0}, {shift + size, 0, 0}, {shift, size, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
}

std::string float_refusal(const Mesh& mesh) {
  try {
    check_format(mesh, MeshFormat::stl);
  } catch (const Error& error) {
    CHECK(error.code() == ErrorCode::unwritable_output);
    return error.what();
  }
  return "";
}

TEST_CASE("meshes that 32-bit floats hold are taken") {
  for (const double size : {1e-30, 1e-3, 1.0, 1e38}) CHECK(float_refusal(triangle(size, 0)).empty());
  CHECK(float_refusal(triangle(1, 1e6)).empty());
}

TEST_CASE("a coordinate beyond a float's range is refused") {
  using Catch::Matchers::Contains;
  CHECK_THAT(float_refusal(triangle(1e39, 0)), Contains(".stl holds 32-bit floats") && Contains("too large"));
  CHECK_THAT(float_refusal(triangle(-1e39, 0)), Contains("too large"));
}

TEST_CASE("a mesh smaller than the step of floats is refused") {
  using Catch::Matchers::Contains;
  CHECK_THAT(float_refusal(triangle(1, 1e9)), Contains("smaller than the distance between neighbouring floats") &&
                                                  Contains("choose .ply, .obj, .off, .coff, .vtp or .vtu"));
  CHECK_THAT(float_refusal(triangle(1e-40, 0)), Contains("smaller than the distance between neighbouring floats"));
}

}  // namespace gvd::test_mesh_writer
