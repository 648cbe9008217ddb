// The command lines of the programs of this folder: their meshes, and how they report an error.
//
// Without a mesh, data/figure.obj is measured. A program that fails writes one line on stderr.
#include "command_line.hpp"

#include <exception>
#include <filesystem>
#include <iostream>

#include "gvd/soup.hpp"

namespace gvd::bench {

void add_mesh_arguments(CLI::App& app, std::vector<std::string>& meshes) {
  meshes = {GVD_SOURCE_DIR "/data/figure.obj"};  // CLI11 clears it before it adds the first path
  app.add_option("meshes", meshes, "OBJ, PLY, OFF or STL files (default: data/figure.obj)")->check(CLI::ExistingFile);
}

NamedMesh read_named_mesh(const std::string& path) {
  return {std::filesystem::path(path).stem().string(), build_mesh(read_soup(path)).mesh};
}

int run_program(const std::string& name, int (*run)(int, char**), int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << name << ": " << error.what() << "\n";
    return 1;
  }
}

}  // namespace gvd::bench
