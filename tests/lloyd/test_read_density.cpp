#include <array>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>

#include "gvd/density.hpp"
#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "support/catch.hpp"

namespace gvd::test_read_density {

using Catch::Matchers::Contains;

/// A square of two triangles, whose file has properties, and a folder for lists.
struct Files {
  Files() {
    std::filesystem::create_directories(folder);
    std::ofstream(mesh_file) << "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
                                "property float z\nproperty float quality\nelement face 2\n"
                                "property list uchar int vertex_indices\nproperty float weight\nend_header\n"
                                "0 0 0 1\n1 0 0 2\n1 1 0 3\n0 1 0 4\n3 0 1 2 7\n3 0 2 3 8\n";
    input = build_mesh(read_soup(mesh_file));
  }
  ~Files() { std::filesystem::remove_all(folder); }

  std::optional<Density> read(const std::string& name) const { return read_density(input, name, mesh_file); }
  std::string write(const std::string& list) const {
    std::ofstream(folder / "list.txt") << list;
    return (folder / "list.txt").string();
  }

  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("gvd_density_" + std::to_string(std::random_device()()));
  std::filesystem::path mesh_file = folder / "square.ply";
  CheckedMesh input;
};

TEST_CASE("read density: lists and properties give a number for each vertex or each face") {
  const Files files;
  const std::array<double, 3> first_corner{1, 0, 0}, middle{0.25, 0.25, 0.5};
  CHECK(files.read(files.write("1 2\n3.5 4\n"))->at(FaceId(0), middle) == Approx(2.5));
  CHECK(files.read(files.write("1\n5\n"))->at(FaceId(1), middle) == 5);
  CHECK(files.read("quality")->at(FaceId(1), first_corner) == 1);
  CHECK(files.read("weight")->at(FaceId(1), middle) == 8);
}

TEST_CASE("read density: no such name gives nothing, and wrong lists are errors with their names") {
  const Files files;
  CHECK_FALSE(files.read("mass"));
  CHECK_FALSE(read_density(files.input, "weight", ""));
  CHECK_THROWS_WITH(files.read(files.write("1 2 3\n")),
                    Contains("list.txt: 3 numbers; give one for each vertex (4) or each face (2)"));
  CHECK_THROWS_WITH(files.read(files.write("1 0\n")), Contains("list.txt: the density of face 1 is 0"));
}

}  // namespace gvd::test_read_density
