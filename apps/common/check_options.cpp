#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/register_options.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

void check_generator_source(const GeneratorOptions& generators) {
  std::vector<std::string> given;
  if (generators.count) given.push_back("-n");
  if (!generators.file.empty()) given.push_back("--generators");
  if (generators.vertices) given.push_back("--vertices");
  if (generators.radius) given.push_back("--radius");
  if (given.empty()) refuse("no generators: give one of -n, --generators, --vertices or --radius");
  if (given.size() > 1) {
    refuse(fmt::format("generators come from one source, not from {}: keep one", fmt::join(given, " and ")));
  }
}

/// An option of the other method would be ignored: the run would not be what its command line says.
void check_method(const ComputeOptions& compute) {
  if (compute.front && compute.method != Method::gbgvd) {
    refuse("--front: exact distances have no front to choose; add --method gbgvd or leave --front out");
  }
  if (compute.chord_tolerance && compute.method != Method::exact) {
    refuse("--chord-tolerance: bisectors are bent by --method exact only; choose it or leave --chord-tolerance out");
  }
  if (compute.chord_tolerance && *compute.chord_tolerance < kLeastChordTolerance) {
    refuse(
        fmt::format("--chord-tolerance {}: below {} of a mean edge rounding decides where a bisector lies; give at "
                    "least that",
                    *compute.chord_tolerance, kLeastChordTolerance));
  }
}

/// Options that this build may lack.
void check_build(const Options& options) {
#ifndef GVD_HAS_VERIFY
  if (options.compute.verify) refuse("--verify: this build is without it; configure with -DGVD_WITH_CGAL_GPL=ON");
#endif
  if (!options.output.view.empty() && !has_viewer()) {
    refuse("--view: this build is without the viewer; configure with -DGVD_WITH_VIEWER=ON");
  }
}

/// A long run must not end on a target that was never writable.
void check_target(const std::string& option, const std::string& path) {
  std::error_code ignored;
  const fs::path target(path);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  if (fs::is_directory(target, ignored)) {
    throw Error(ErrorCode::unwritable_output, fmt::format("{} {}: is a directory; name a file", option, path));
  }
  if (!fs::is_directory(folder, ignored)) {
    throw Error(ErrorCode::unwritable_output,
                fmt::format("{} {}: there is no directory {}; create it first", option, path, folder.string()));
  }
}

/// One name for every way to spell a path ("a.ply", "./a.ply", a link to it), so that no target overwrites another.
std::string one_name(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : target.string();
}

/// What a run reads is not what it writes: the only copy of a mesh would be gone. By file and not by name, so a link of
/// either kind is seen through.
void check_not_read(const std::string& option, const std::string& path, const Options& options) {
  const std::string input = options.input.path == "-" ? "/dev/stdin" : options.input.path;
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return;
  for (const std::string& read : {input, options.generators.file}) {
    if (read.empty() || !fs::equivalent(path, read, ignored)) continue;
    refuse(fmt::format("{} {}: this is the file that is read; name another one", option, path));
  }
}

void check_output(const Options& options, const std::vector<std::string>& formats) {
  const OutputOptions& output = options.output;
  std::set<std::string> targets;
  const auto claim = [&](const std::string& option, const std::string& path) {
    if (path.empty()) return;
    if (!targets.insert(path == "-" ? path : one_name(path)).second) {
      refuse(fmt::format("{} {}: this file is named twice", option, path));
    }
    if (path != "-") {
      check_target(option, path);
      return check_not_read(option, path, options);
    }
    if (option != "-o") refuse(fmt::format("{} -: only -o can write to standard output; name a file", option));
  };
  for (const std::string& file : output.files) {
    if (file.empty()) refuse("-o: the file name is empty");
    const std::string kind = extension(file);
    if (file != "-" && std::find(formats.begin(), formats.end(), kind) == formats.end()) {
      refuse(fmt::format("-o {}: the extension must be one of .{}", file, fmt::join(formats, ", .")));
    }
    claim("-o", file);
  }
  claim("--report", output.report);
  claim("--diagram", output.diagram);
  claim("--view", output.view);
}

}  // namespace

std::string extension(const std::string& path) {
  std::string text = fs::path(path).extension().string();
  if (!text.empty()) text.erase(0, 1);
  std::transform(text.begin(), text.end(), text.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return text;
}

void check_options(const Options& options, const std::vector<std::string>& output_formats) {
  if (options.input.path == "-" && options.input.format.empty()) {
    refuse("standard input has no extension: name its format with --input-format obj, ply, off or stl");
  }
  check_generator_source(options.generators);
  check_method(options.compute);
  check_build(options);
  check_output(options, output_formats);
}

}  // namespace gvd::app
