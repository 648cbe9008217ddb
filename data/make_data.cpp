// Writes the meshes of data/, or checks that the files there are the ones it would write.
#include <array>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "encode_mesh.hpp"
#include "figure.hpp"
#include "gvd/mesh.hpp"
#include "marching_tetrahedra.hpp"
#include "remesh_isotropic.hpp"
#include "support/meshes.hpp"

namespace gvd::data {
namespace {

struct NamedFile {
  std::string name;
  std::string bytes;
};

Mesh make_figure() {
  constexpr double kSpacing = 0.05, kEdgeLength = 0.078;
  constexpr int kRounds = 10;
  const Grid grid{{-2, -0.2, -0.7}, kSpacing, {82, 62, 28}};
  const Triangles coarse = polygonise(figure_value, grid);
  const Triangles regular = remesh_isotropic(coarse, kEdgeLength, kRounds, project_to_figure);
  std::vector<std::array<VertexId, 3>> faces;
  for (const auto& [a, b, c] : regular.faces) faces.push_back({VertexId(a), VertexId(b), VertexId(c)});
  return Mesh(regular.positions, faces);
}

std::vector<NamedFile> make_files() {
  const std::string origin = "written by make_data, see README.md";
  return {{"figure.obj", encode_obj(make_figure(), origin)},
          {"torus.ply", encode_binary_ply(test::make_torus(40, 20), origin)},
          {"half_sphere.off", encode_off(test::make_half_sphere(3), origin)},
          {"plate.stl", encode_binary_stl(test::make_plate(12, 0.05))}};
}

void write(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw std::runtime_error("could not write " + path.string());
  std::cout << path.string() << ": " << bytes.size() << " bytes\n";
}

bool same_as_written(const std::filesystem::path& path, const std::string& bytes) {
  std::ifstream file(path, std::ios::binary);
  const std::string found{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if (found == bytes) return true;
  std::cout << path.string() << " is not what make_data writes (" << found.size() << " bytes, expected " << bytes.size()
            << ")\n";
  return false;
}

int run(int argc, char** argv) {
  const bool check = argc > 1 && std::string_view(argv[1]) == "--check";
  const char* folder = argv[argc - 1];
  if (argc != (check ? 3 : 2) || !std::filesystem::is_directory(folder)) {
    std::cerr << "Usage: make_data [--check] FOLDER\n"
                 "Writes the meshes of data/ into FOLDER, which must exist. With --check it writes nothing and fails "
                 "where a file differs.\n";
    return 2;
  }

  bool same = true;
  for (const NamedFile& file : make_files()) {
    const std::filesystem::path path = std::filesystem::path(folder) / file.name;
    if (check) {
      same = same_as_written(path, file.bytes) && same;
    } else {
      write(path, file.bytes);
    }
  }
  return same ? 0 : 1;
}

}  // namespace
}  // namespace gvd::data

int main(int argc, char** argv) {
  try {
    return gvd::data::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "make_data: " << error.what() << "\n";
    return 1;
  }
}
