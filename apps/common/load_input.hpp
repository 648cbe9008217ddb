#pragma once

#include <string>

#include "common/run.hpp"
#include "gvd/mesh_objects.hpp"
#include "gvd/read_soup.hpp"

namespace gvd::app {

/// Notes something about the input, after its name. With --output-dir the console's lines already begin with that name.
void note_on_input(Run& run, const std::string& message);

/// The bytes of standard input or a pipe, which can be read only once.
struct PipedInput {
  std::string bytes;  ///< empty if INPUT is a file
  MeshFormat format{};
};

/// Reads and checks the mesh of INPUT, and the files that options name, so that operations find values. Notes each
/// repair in one line, and reports the mesh and its defects.
///
/// Throws Error{unreadable_input} or Error{precondition} with the name of the input; Error{unreadable_input} with the
/// option whose name is neither a file nor a property; Error{unwritable_output} if an output format can't hold the
/// coordinates of the mesh; and what `check_referred_files` and the readers throw. `piped`, if not null, receives the
/// bytes of INPUT if it is standard input or a pipe.
MeshPtr load_input(Run& run, PipedInput* piped = nullptr);

}  // namespace gvd::app
