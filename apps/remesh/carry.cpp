#include "remesh/carry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "common/options/options.hpp"
#include "common/steps/standard_input.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

bool writes(const Run& run, std::string_view format) {
  const OutputOptions& output = run.options().output;
  return std::any_of(output.files.begin(), output.files.end(), [&](const std::string& file) {
    return (file == "-" ? stdout_format(output) : file_extension(file)) == format;
  });
}

MeshAttributes read(const InputOptions& input, const std::string& standard_input) {
  const auto format = format_from_extension(input.format);
  if (input.path != "-") return read_mesh_attributes(input.path, format);
  return parse_mesh_attributes(standard_input, *format, kStandardInput);
}

}  // namespace

void check_carry(const Run& run) {
  if (writes(run, "ply") || writes(run, "obj")) return;
  throw Error(ErrorCode::invalid_option,
              "--carry: only PLY and OBJ files hold what is carried over; write one, such as -o FILE.ply");
}

Carried carry(Run& run, const CheckedMesh& input, const RemeshResult& result, const RemeshMap& map,
              const std::string& standard_input) {
  const InputOptions& options = run.options().input;
  Carried carried = run.timed("carry", [&] {
    const MeshAttributes found = read(options, standard_input);
    Carried made{carry_properties(input, found.properties, result, map), {}};
    if (found.texture) made.texture = carry_texture(input, *found.texture, result, map);
    return made;
  });
  const std::string name = options.path == "-" ? kStandardInput : options.path;
  if (carried.properties.empty() && carried.texture.empty()) {
    run.console().note(fmt::format("{}: no properties and no texture coordinates to carry over", name));
  } else if (!carried.properties.empty() && !writes(run, "ply")) {
    run.console().note("--carry: OBJ holds texture coordinates only; properties need -o FILE.ply");
  }
  return carried;
}

}  // namespace gvd::app
