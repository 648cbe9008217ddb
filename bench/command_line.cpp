// The command lines of the programs of this folder: their meshes, their lists, and how they report an error.
//
// Without a mesh, data/figure.obj is measured, so that every program runs from a fresh checkout. Values out of range
// are refused by CLI11's own validators before any measurement starts. A program that fails writes one line on stderr.
#include "command_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>

#include "gvd/error.hpp"
#include "gvd/read_soup.hpp"
#include "gvd/soup.hpp"

namespace gvd::bench {

void add_mesh_arguments(CLI::App& app, std::vector<std::string>& meshes) {
  meshes = {GVD_SOURCE_DIR "/data/figure.obj"};  // CLI11 clears it before it adds the first path
  app.add_option("meshes", meshes, "OBJ, PLY, OFF or STL files (default: data/figure.obj)")->check(CLI::ExistingFile);
}

void add_choice(CLI::App& app, const std::string& name, std::vector<std::string>& chosen,
                const std::vector<std::string>& words, const std::string& what) {
  app.add_option(name, chosen, what)->delimiter(',')->check(CLI::IsMember(words));
}

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

NamedMesh read_named_mesh(const std::string& path) {
  return {std::filesystem::path(path).stem().string(), build_mesh(read_soup(path)).mesh};
}

void write_file(const std::string& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) throw Error(ErrorCode::unwritable_output, fmt::format("could not write {}", path));
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
