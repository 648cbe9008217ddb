#include "remesh/carry.hpp"

#include <algorithm>

#include "common/options/file_extension.hpp"
#include "gvd/error.hpp"

namespace gvd::app {

void check_carry(const Run& run) {
  const OutputOptions& output = run.options().output;
  const bool has_ply = std::any_of(output.files.begin(), output.files.end(), [&](const std::string& file) {
    return (file == "-" ? stdout_format(output) : file_extension(file)) == "ply";
  });
  if (!has_ply) {
    throw Error(ErrorCode::invalid_option, "--carry: only PLY files hold properties; write one, such as -o FILE.ply");
  }
  if (run.options().input.path == "-") {
    throw Error(ErrorCode::invalid_option, "--carry: standard input is read once; name a file as input");
  }
}

std::vector<MeshProperty> carry(Run& run, const CheckedMesh& input, const RemeshResult& result) {
  const std::string& path = run.options().input.path;
  std::vector<MeshProperty> carried =
      run.timed("carry", [&] { return carry_properties(input, read_mesh_properties(path), result); });
  if (carried.empty()) run.console().note(path + ": no properties of vertices or faces to carry over");
  return carried;
}

}  // namespace gvd::app
