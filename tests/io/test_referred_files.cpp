// The files that a mesh refers to: buffers and images of a glTF, and materials of an OBJ.
#include <filesystem>
#include <fstream>
#include <random>

#include "gvd/referred_files.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_referred_files {

using namespace test;
namespace fs = std::filesystem;
using Paths = std::vector<fs::path>;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("gvd_referred_" + std::to_string(std::random_device()()));

  Folder() { fs::create_directories(path); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { fs::remove_all(path); }

  fs::path write(const char* name, const std::string& bytes) const {
    std::ofstream(path / name, std::ios::binary) << bytes;
    return path / name;
  }
};

TEST_CASE("referred files: buffers and images of a glTF are listed, and no other addresses") {
  const Folder at;
  const std::string mesh = gltf_of(glb_description(2), "sub%20folder/n%231%2520.bin");
  CHECK(list_referred_files(at.write("mesh.gltf", mesh)) == Paths{"sub folder/n#1%20.bin"});
  const std::string painted =
      replaced(gltf_of(glb_description(2), "numbers.bin"), "\"buffers\"",
               R"("images":[{"uri":"paint%20er.png"},{"uri":"data:image/png;base64,AA=="},{"bufferView":0},)"
               R"({"uri":"../up.png"},{"uri":"https://a.org/b.png"},{"uri":7}],"buffers")");
  CHECK(list_referred_files(at.write("painted.gltf", painted)) == Paths{"numbers.bin", "paint er.png"});
  CHECK(list_referred_files(at.write("blanks.gltf", std::string(5000, ' ') + painted)).size() == 2);
  const std::string packed = glb_of(gltf_of(glb_description(2), "numbers.bin"), "");
  CHECK(list_referred_files(at.write("packed.glb", packed)) == Paths{"numbers.bin"});
  CHECK(list_referred_files(at.write("mesh.gltf", kGltf)).empty());
  CHECK_THAT(
      refusal([&] { list_referred_files(at.write("cut.gltf", kGltf.substr(0, 40))); }, ErrorCode::unreadable_input),
      Catch::Matchers::Contains("cut.gltf: the scene's description is damaged"));
}

TEST_CASE("referred files: materials of an OBJ are whole lines, and words where there is no such file") {
  const Folder at;
  const fs::path mesh = at.write("mesh.obj",
                                 "# mtllib comment.mtl\nmtllib red paint.mtl\r\n\tmtllib  two.mtl \t\n"
                                 "usemtl mtllib x\nmtllibs no.mtl\nv 0 0 0\nmtllib\nmtllib last.mtl");
  CHECK(list_referred_files(mesh) == Paths{"red paint.mtl", "red", "paint.mtl", "two.mtl", "last.mtl"});
  at.write("red paint.mtl", "newmtl red\n");
  CHECK(list_referred_files(mesh) == Paths{"red paint.mtl", "two.mtl", "last.mtl"});
  CHECK(list_referred_files(mesh, MeshFormat::ply).empty());
  CHECK(list_referred_files(at.write("mesh.off", "OFF\nmtllib a.mtl\n")).empty());
  CHECK_THAT(refusal([&] { list_referred_files(at.path / "none.obj"); }, ErrorCode::unreadable_input),
             Catch::Matchers::Contains("none.obj: there is no such file"));
}

TEST_CASE("referred files: of an OBJ, those are listed that its reader finds") {
  const Folder at;
  for (const char* text : {"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                           "\xEF\xBB\xBFmtllib a.mtl\rv 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
                           " mtllib\ta.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nmtllib b.mtl"}) {
    const fs::path mesh = at.write("mesh.obj", text);
    CHECK(list_material_files(mesh, read_soup(mesh).appearance.material_files) == list_referred_files(mesh));
  }
}

}  // namespace gvd::test_referred_files
