#include "common/options/check_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "common/options/file_extension.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

void check_generator_source(const GeneratorOptions& generators) {
  if (generators.count || !generators.file.empty() || generators.vertices || generators.radius) return;
  refuse("no generators: give one of -n, --generators, --vertices or --radius");
}

void check_chord_tolerance(const ComputeOptions& compute) {
  if (!compute.chord_tolerance || *compute.chord_tolerance >= kLeastChordTolerance) return;
  refuse(fmt::format("--chord-tolerance {}: a bisector is known to {} mean edge lengths only; give at least that",
                     *compute.chord_tolerance, kLeastChordTolerance));
}

/// Refuses options of features that this build lacks.
void check_build(const Options& options) {
#ifndef GVD_HAS_VERIFY
  if (options.compute.verify) refuse("--verify: this build lacks it; configure with -DGVD_WITH_CGAL_GPL=ON");
#endif
  if (!options.output.view.empty() && !has_viewer()) {
    refuse("--view: this build lacks the viewer; configure with -DGVD_WITH_VIEWER=ON");
  }
}

/// Refuses, before the run starts, a target that can't be written.
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

/// The same name for every spelling of a path ("a.ply", "./a.ply", a link to it): no target may overwrite another.
std::string one_name(const std::string& path) {
  std::error_code failed;
  const fs::path target = fs::weakly_canonical(fs::absolute(path, failed), failed);
  return failed ? path : target.string();
}

/// Refuses a target that the run reads: it may be the only copy of a mesh. Files are compared and not names, so that
/// symbolic and hard links are found.
void check_not_read(const std::string& option, const std::string& path, const Options& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return;
  for (const std::string& read : {options.input.path, options.generators.file}) {
    if (read.empty() || !fs::equivalent(path, read == "-" ? "/dev/stdin" : read, ignored)) continue;
    refuse(fmt::format("{} {}: this is the file that is read; name another one", option, path));
  }
}

/// The targets of a run: each one is claimed once.
class Targets {
 public:
  explicit Targets(const Options& options) : options_(options) {}

  void claim(const std::string& option, const std::string& path) {
    if (path.empty()) return;
    if (!names_.insert(path == "-" ? path : one_name(path)).second) {
      refuse(fmt::format("{} {}: two options name this file; name another one", option, path));
    }
    if (path != "-") {
      check_target(option, path);
      check_not_read(option, path, options_);
    } else if (option != "-o") {
      refuse(fmt::format("{} -: only -o can write to standard output; name a file", option));
    }
  }

 private:
  const Options& options_;
  std::set<std::string> names_;
};

void check_format(const std::string& file, const std::vector<std::string>& formats) {
  if (file.empty()) refuse("-o: the file name is empty; name a file");
  if (file == "-" || std::find(formats.begin(), formats.end(), file_extension(file)) != formats.end()) return;
  refuse(fmt::format("-o {}: the extension must be one of .{}", file, fmt::join(formats, ", .")));
}

/// Whether a file or standard output gets one of the formats.
bool writes_any(const OutputOptions& output, const std::vector<std::string>& formats) {
  return std::any_of(output.files.begin(), output.files.end(), [&](const std::string& file) {
    const std::string format = file == "-" ? output.stdout_format : file_extension(file);
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  });
}

/// Refuses options of formats that the run does not write.
void check_format_options(const OutputOptions& output) {
  if (output.no_curves && !writes_any(output, {"obj", "vtp", "glb"})) {
    refuse("--no-curves: only .obj, .vtp and .glb hold curves; write one of them with -o or leave --no-curves out");
  }
  if (output.ascii_ply && !writes_any(output, {"ply"})) {
    refuse("--ascii-ply: no .ply is written; write one with -o or leave --ascii-ply out");
  }
}

void check_output(const Options& options, const std::vector<std::string>& formats) {
  const OutputOptions& output = options.output;
  Targets targets(options);
  for (const std::string& file : output.files) {
    check_format(file, formats);
    targets.claim("-o", file);
  }
  check_format_options(output);
  targets.claim("--report", output.report);
  targets.claim("--diagram", output.diagram);
  targets.claim("--view", output.view);
}

}  // namespace

void check_options(const Options& options, const std::vector<std::string>& output_formats) {
  if (options.input.path == "-" && options.input.format.empty()) {
    refuse("standard input has no extension: name its format with --input-format obj, ply, off or stl");
  }
  if (options.input.path == "-" && options.generators.file == "-") {
    refuse("INPUT and --generators are both standard input, which holds one of them: name a file for the other");
  }
  check_generator_source(options.generators);
  check_chord_tolerance(options.compute);
  check_build(options);
  check_output(options, output_formats);
}

}  // namespace gvd::app
