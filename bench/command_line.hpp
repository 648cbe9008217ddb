#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"

// What the command lines of the programs of this folder share.

namespace gvd::bench {

/// Adds the paths of meshes to the command line; without any, `meshes` becomes data/figure.obj.
void add_mesh_arguments(CLI::App& app, std::vector<std::string>& meshes);

struct NamedMesh {
  std::string name;  ///< the file's, without folder and extension
  Mesh mesh;
};

/// Throws Error if the file is no mesh.
NamedMesh read_named_mesh(const std::string& path);

/// Runs a program of this folder. An exception becomes a line on stderr that begins with `name`, and the status 1.
int run_program(const std::string& name, int (*run)(int, char**), int argc, char** argv);

}  // namespace gvd::bench
