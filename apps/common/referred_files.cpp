// Compares the files to which inputs refer with the outputs before anything is written. For several inputs that happens
// before the first run, because an output of one run may be a file of a later run. The files are compared by path,
// because a named file need not exist yet, and by identity, because links may lead to it.
#include "common/referred_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "common/outcome.hpp"
#include "gvd/error.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/option_text.hpp"
#include "gvd/referred_files.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

/// The identity of a file, whatever its names; nothing if it does not exist.
std::optional<std::pair<dev_t, ino_t>> identity_of(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return std::nullopt;
  return std::pair(found.st_dev, found.st_ino);
}

/// All files that a run writes, including files of materials.
std::vector<Target> list_written(const OutputOptions& output) {
  std::vector<Target> files;
  for (const Target& target : list_targets(output)) {
    if (target.path == "-") continue;
    files.push_back(target);
    const bool may_have_materials = target.option == "output" || target.option == "output_dir";
    const auto materials = may_have_materials ? materials_file(target.path) : std::nullopt;
    if (materials) files.push_back({target.option, materials->string(), true});
  }
  if (!output.summary.empty()) files.push_back({"summary", output.summary});
  return files;
}

/// The files to which meshes refer, with the meshes. Cost: O(log n) for each file.
class ReferredFiles {
 public:
  /// `file`: the path relative to the folder of the mesh.
  void add(const std::string& mesh, const fs::path& file) {
    const fs::path path = fs::path(mesh).parent_path() / file;
    meshes_at_[one_name(path.string())].push_back(mesh);
    if (const auto identity = identity_of(path)) meshes_of_[*identity].push_back(mesh);
  }

  /// Throws Error{invalid_option} if a mesh other than `excepted` refers to the target.
  void check(const Target& target, const std::string& excepted = "") const {
    refuse_any(target, meshes_at_, one_name(target.path), excepted);
    if (const auto identity = identity_of(target.path)) refuse_any(target, meshes_of_, *identity, excepted);
  }

 private:
  template <class Key>
  using Meshes = std::map<Key, std::vector<std::string>>;

  template <class Key>
  static void refuse_any(const Target& target, const Meshes<Key>& meshes, const Key& key, const std::string& excepted) {
    const auto found = meshes.find(key);
    if (found == meshes.end()) return;
    for (const std::string& mesh : found->second) {
      if (mesh == excepted) continue;
      throw Error(ErrorCode::invalid_option,
                  fmt::format("{}: {} refers to this file; name another one", name_of(target), mesh));
    }
  }

  Meshes<std::string> meshes_at_;              // by path
  Meshes<std::pair<dev_t, ino_t>> meshes_of_;  // by identity, for files that exist
};

}  // namespace

void check_referred_files(const Options& options, const Appearance& input) {
  const std::string& mesh = options.input.path;
  if (is_read_once(mesh)) return;  // it has no folder
  std::vector<Target> written = list_written(options.output);
  ReferredFiles materials, others;
  for (const fs::path& file : list_material_files(mesh, input.material_files)) materials.add(mesh, file);
  for (const Target& file : written) {
    if (!file.has_materials) materials.check(file);
  }
  // Buffers and images that do not exist can't be lost.
  std::error_code ignored;
  std::erase_if(written, [&](const Target& file) { return !fs::is_regular_file(file.path, ignored); });
  if (written.empty() || !input.material_files.empty()) return;
  for (const fs::path& file : list_referred_files(mesh, options.input.format)) others.add(mesh, file);
  for (const Target& file : written) others.check(file);
}

void check_referred_files(const std::vector<Options>& runs) {
  ReferredFiles referred;
  for (const Options& run : runs) {
    const std::string& mesh = run.input.path;
    if (is_read_once(mesh)) continue;
    // If an input can't be read, its own run reports that.
    run_guarded([&] {
      for (const fs::path& file : list_referred_files(mesh, run.input.format)) referred.add(mesh, file);
    });
  }
  for (const Options& run : runs) {
    for (const Target& file : list_written(run.output)) {
      referred.check(file, file.has_materials ? run.input.path : "");
    }
  }
}

void check_material_files(Run& run, const Appearance& appearance, bool drops_materials) {
  const OutputOptions& output = run.options().output;
  if (!appearance.material.empty() && !output.region_materials && !drops_materials) return;  // no .mtl is written
  const std::string& input = run.options().input.path;
  for (const std::string& path : output.files) {
    const auto made = materials_file(path);
    if (!made) continue;
    for (const fs::path& name : list_material_files(input, appearance.material_files)) {
      const fs::path named = fs::path(input).replace_filename(name);
      std::error_code ignored;
      if (one_name(made->string()) != one_name(named.string()) && !fs::equivalent(*made, named, ignored)) continue;
      throw Error(ErrorCode::invalid_option,
                  fmt::format("{}: its materials would replace {}, which {} names; choose another name",
                              placeholder("output", path), user_text(name.string()), input));
    }
  }
}

void note_material_files(Run& run, const std::string& path, const Appearance& appearance) {
  const std::string& input = run.options().input.path;
  const auto folder_of = [](const std::string& file) {
    std::error_code ignored;
    return one_name(fs::absolute(file, ignored).parent_path().string());
  };
  if (appearance.material_files.empty() || input == "-" || folder_of(path) == folder_of(input)) return;
  run.console().note(fmt::format("{} names the materials of {}, which is beside {}: copy it together with its images",
                                 path, user_text(fmt::format("{}", fmt::join(appearance.material_files, ", "))),
                                 input));
}

}  // namespace gvd::app
