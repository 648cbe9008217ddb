// Files that INPUT refers to are compared with the outputs once INPUT is read, before anything is written. They are
// compared as places, since a file that is named need not be there yet, and as files, since links may lead to one.
#include "common/referred_files.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "gvd/error.hpp"
#include "gvd/gltf_files.hpp"
#include "gvd/io/mesh_writer.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

/// The folder of a file, without links.
fs::path folder(const fs::path& file) {
  std::error_code failed;
  return fs::weakly_canonical(fs::absolute(file, failed).parent_path(), failed);
}

bool is_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  return (a.filename() == b.filename() && folder(a) == folder(b)) || fs::equivalent(a, b, ignored);
}

/// The files that a run writes, but those of materials.
std::vector<Target> list_files(const OutputOptions& output) {
  std::vector<Target> targets = list_targets(output);
  if (!output.summary.empty()) targets.push_back({"--summary", output.summary});
  std::erase_if(targets, [](const Target& target) { return target.path == "-"; });
  return targets;
}

}  // namespace

void check_referred_files(const Options& options, const Appearance& input) {
  const std::string& mesh = options.input.path;
  if (is_read_once(mesh)) return;  // and has no folder
  const auto check = [&](const Target& target, const fs::path& name) {
    if (!is_same(target.path, fs::path(mesh).parent_path() / name)) return;
    throw Error(ErrorCode::invalid_option,
                fmt::format("{} {}: {} refers to this file; name another one", target.option, target.path, mesh));
  };
  std::vector<Target> targets = list_files(options.output);
  for (const Target& target : targets) {
    for (const std::string& file : input.material_files) check(target, file);
  }
  for (const std::string& file : options.output.files) {
    const auto materials = materials_file(file);
    if (materials) targets.push_back({"the materials of -o", materials->string()});
  }
  // Buffers and images that are not there can't be lost.
  std::error_code ignored;
  std::erase_if(targets, [&](const Target& target) { return !fs::is_regular_file(target.path, ignored); });
  if (targets.empty()) return;
  for (const fs::path& file : list_gltf_files(mesh)) {
    for (const Target& target : targets) check(target, file);
  }
}

void check_material_files(Run& run, const Appearance& appearance, bool drops_materials) {
  const OutputOptions& output = run.options().output;
  if (!appearance.material.empty() && !output.region_materials && !drops_materials) return;  // no .mtl is written
  const std::string& input = run.options().input.path;
  for (const std::string& path : output.files) {
    const auto made = materials_file(path);
    if (!made) continue;
    // Relative to the input. Several names on one line count as one with blanks, as most programs write a single one.
    for (const fs::path name : appearance.material_files) {
      if (!is_same(*made, fs::path(input).replace_filename(name))) continue;
      throw Error(ErrorCode::invalid_option,
                  fmt::format("-o {}: its materials would replace {}, which {} names; choose "
                              "another name",
                              path, printable(name.string()), input));
    }
  }
}

void note_material_files(Run& run, const std::string& path, const Appearance& appearance) {
  const std::string& input = run.options().input.path;
  if (appearance.material_files.empty() || input == "-" || folder(path) == folder(input)) return;
  run.console().note(fmt::format("{} names the materials of {}, which is beside {}: copy it, with its images", path,
                                 printable(fmt::format("{}", fmt::join(appearance.material_files, ", "))), input));
}

}  // namespace gvd::app
