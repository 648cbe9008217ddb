// Buffers of glTF in data URIs and in files: which ones are read, and which ones are not.
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "gvd/read_soup.hpp"
#include "mesh/reading/gltf_buffers.hpp"
#include "mesh/reading/soup_files.hpp"
#include "support/catch.hpp"
#include "support/refusal.hpp"

namespace gvd::test_gltf_buffers {

using namespace test;
namespace fs = std::filesystem;

/// A folder `models` with numbers.bin, a folder below it, and a file outside of it.
struct Models {
  fs::path folder = fs::temp_directory_path() / ("gvd_buffers_" + std::to_string(std::random_device()()));
  fs::path models = folder / "models";

  Models(const Models&) = delete;
  Models& operator=(const Models&) = delete;
  ~Models() { fs::remove_all(folder); }
  Models() {
    fs::create_directories(models / "sub folder");
    for (const fs::path& file :
         {models / "numbers.bin", models / "sub folder" / "n#1%20.bin", folder / "outside.bin"}) {
      write(file, glb_numbers());
    }
  }

  static void write(const fs::path& file, const std::string& bytes) { std::ofstream(file, std::ios::binary) << bytes; }

  PolygonSoup read(const std::string& uri) const {
    write(models / "mesh.gltf", gltf_of(glb_description(2), uri));
    return read_soup(models / "mesh.gltf");
  }

  std::string refused(const std::string& uri) const {
    const std::string message = refusal([&] { read(uri); }, ErrorCode::unreadable_input);
    CHECK(message.find('\n') == std::string::npos);
    return message;
  }
};

TEST_CASE("gltf buffers: a file beside the mesh or below it is read, and percent-encoded names are decoded once") {
  const Models at;
  for (const char* uri :
       {"numbers.bin", "./numbers.bin", "n%75mbers.bin", "sub%20folder/n%231%2520.bin", "sub folder/n#1%2520.bin"}) {
    INFO(uri);
    require_tetrahedron(at.read(uri));
  }
  // A .glb may have its buffers in files, too.
  Models::write(at.models / "mesh.glb", glb_of(gltf_of(glb_description(2), "numbers.bin"), ""));
  require_tetrahedron(read_soup(at.models / "mesh.glb"));
  // The folder of a mesh that is named without one is the current folder.
  const fs::path before = fs::current_path();
  fs::current_path(at.models);
  require_tetrahedron(read_soup("mesh.glb"));
  fs::current_path(before);
}

TEST_CASE("gltf buffers: a buffer that begins as a gzip file does is read as it is") {
  const Models at;
  Models::write(at.models / "packed.bin", "\x1f\x8b\x08");
  CHECK_THAT(at.refused("packed.bin"), Catch::Matchers::Contains("buffer 0 should have 132 bytes, and has 3"));
}

TEST_CASE("gltf buffers: what is not below the folder of the mesh is refused, however its name is written") {
  const Models at;
  const std::string outside = (at.folder / "outside.bin").string();
  for (const std::string& uri :
       {std::string("../outside.bin"), std::string("%2e%2e/outside.bin"), std::string("..%2Foutside.bin"),
        std::string("sub folder/../../outside.bin"), std::string("../models/numbers.bin"), outside,
        "%2F" + outside.substr(1), "/" + outside}) {
    INFO(uri);
    CHECK_THAT(at.refused(uri), Catch::Matchers::Contains("is not in the folder of the mesh"));
  }
  for (const std::string& uri : {"file://" + outside, "FILE:" + outside, std::string("http://localhost/numbers.bin"),
                                 std::string("https:numbers.bin"), std::string("http%3A//localhost/numbers.bin"),
                                 std::string("c:/numbers.bin")}) {
    INFO(uri);
    CHECK_THAT(at.refused(uri),
               Catch::Matchers::Contains("is an address, and only files in the folder of the mesh are read"));
  }
  for (const char* uri : {"", "..\\\\outside.bin", "sub%5Cnumbers.bin", "numbers.bin%00", "%0Anumbers.bin"}) {
    INFO(uri);
    CHECK_THAT(at.refused(uri), Catch::Matchers::Contains("is not the name of a file"));
  }
  for (const char* uri : {"a%2", "a%zz", "%", "%+1"})
    CHECK_THAT(at.refused(uri), Catch::Matchers::Contains("has a '%' without two digits after it"));
}

TEST_CASE("gltf buffers: symbolic links are followed inside of the folder, and not out of it") {
  const Models at;
  fs::create_symlink("numbers.bin", at.models / "inside.bin");
  require_tetrahedron(at.read("inside.bin"));
  fs::create_symlink(at.folder / "outside.bin", at.models / "link.bin");
  CHECK_THAT(at.refused("link.bin"),
             Catch::Matchers::Contains("leads out of the folder of the mesh by a symbolic link"));
  fs::create_directory_symlink("..", at.models / "up");
  CHECK_THAT(at.refused("up/outside.bin"), Catch::Matchers::Contains("leads out of the folder of the mesh"));
  // A folder whose name begins as that of the mesh's folder is another one.
  fs::create_directory(at.folder / "models2");
  Models::write(at.folder / "models2" / "a.bin", glb_numbers());
  fs::create_symlink(at.folder / "models2" / "a.bin", at.models / "other.bin");
  CHECK_THAT(at.refused("other.bin"), Catch::Matchers::Contains("leads out of the folder of the mesh"));
  // A link to the folder of the mesh is no way out of it.
  fs::create_directory_symlink(at.models, at.folder / "linked");
  at.read("numbers.bin");
  require_tetrahedron(read_soup(at.folder / "linked" / "mesh.gltf"));
}

TEST_CASE("gltf buffers: a file that is missing, or is none, is refused") {
  const Models at;
  CHECK_THAT(at.refused("missing.bin"),
             Catch::Matchers::Contains("buffer 0, 'missing.bin', is not there; put it beside the mesh"));
  CHECK_THAT(at.refused("sub folder"), Catch::Matchers::Contains("is not a file"));
  REQUIRE(mkfifo((at.models / "pipe").c_str(), 0600) == 0);
  CHECK_THAT(at.refused("pipe"), Catch::Matchers::Contains("is not a file"));
}

TEST_CASE("gltf buffers: data URIs are Base64, without a folder there is nothing else") {
  const auto refused = [](const std::string& uri, const std::string& part) {
    INFO(uri);
    require_refused(gltf_of(glb_description(2), uri), MeshFormat::gltf, part);
  };
  refused("data:application/octet-stream,abc", "is a data URI without Base64");
  refused("data:", "is a data URI without Base64");
  refused("data:;base64", "buffer 0 should have 132 bytes, and has 0");
  refused("data:;base64,AAAA", "buffer 0 should have 132 bytes, and has 3");
  refused("data:;base64,AA*ABBBB", "is a data URI whose Base64 is damaged");
  refused("numbers.bin", "name the mesh by its path, with the buffer beside it, or export one .glb");
  refused("/etc/hostname", "is not in the file");
  require_tetrahedron(parse_soup(replaced(kGltf, "data:", "DATA:"), MeshFormat::gltf, "file"));
}

TEST_CASE("gltf buffers: a file counts once, and its size among what may be unfolded") {
  const Models at;
  // 2,000,000 bytes that the JSON of some hundred bytes may not unfold to by itself.
  Models::write(at.models / "numbers.bin", glb_numbers() + std::string(2'000'000, '\0'));
  std::string description =
      replaced(glb_description(2), R"("byteOffset":60,"byteLength":24)", R"("byteOffset":132,"byteLength":2000000)");
  description = replaced(description, R"("componentType":5123,"count":12)", R"("componentType":5123,"count":999999)");
  description = replaced(description, R"("byteLength":132}])", R"("byteLength":2000132}])");
  Models::write(at.models / "mesh.gltf", gltf_of(description, "numbers.bin"));
  CHECK(read_soup(at.models / "mesh.gltf").polygon_count() == 333333);
}

}  // namespace gvd::test_gltf_buffers
