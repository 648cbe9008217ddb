#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"

// What the command lines of the programs of this folder share.

namespace gvd::bench {

/// Adds the paths of meshes to the command line; without any, `meshes` becomes data/figure.obj.
void add_mesh_arguments(CLI::App& app, std::vector<std::string>& meshes);

/// Adds an option for a number above zero, or for several of them with commas. Its default is the present value.
template <class Number>
void add_positive(CLI::App& app, const std::string& name, Number& value, const std::string& what) {
  app.add_option(name, value, what)->check(CLI::PositiveNumber);
}
template <class Number>
void add_positive(CLI::App& app, const std::string& name, std::vector<Number>& values, const std::string& what) {
  app.add_option(name, values, what)->delimiter(',')->check(CLI::PositiveNumber);
}

/// Adds an option for one or several of these words, with commas.
void add_choice(CLI::App& app, const std::string& name, std::vector<std::string>& chosen,
                const std::vector<std::string>& words, const std::string& what);

/// Whether a list has this word.
bool contains(const std::vector<std::string>& words, const std::string& word);

struct NamedMesh {
  std::string name;  ///< the file's, without folder and extension
  Mesh mesh;
};

/// Throws Error if the file is no mesh.
NamedMesh read_named_mesh(const std::string& path);

/// Throws Error{unwritable_output} if the text could not be written.
void write_file(const std::string& path, const std::string& text);

/// Runs a program of this folder. An exception becomes a line on stderr that begins with `name`, and the status 1.
int run_program(const std::string& name, int (*run)(int, char**), int argc, char** argv);

}  // namespace gvd::bench
