#include "common/options/check_outputs.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "common/options/file_extension.hpp"
#include "common/options/plan_runs.hpp"
#include "gvd/error.hpp"
#include "gvd/io/write_file.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse_output(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

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

/// Longest chain of symbolic links that is followed: the limit of Linux.
constexpr int kMaxLinks = 40;

/// The same name for every spelling of a path ("a.ply", "./a.ply", a link to it, whether or not that exists): no target
/// may overwrite another.
std::string one_name(const std::string& path) {
  std::error_code failed;
  fs::path target = fs::absolute(path, failed);
  for (int i = 0; i < kMaxLinks && fs::is_symlink(target, failed); ++i) {
    target = target.parent_path() / fs::read_symlink(target, failed);
  }
  target = fs::weakly_canonical(target, failed);
  return failed ? path : target.string();
}

/// Refuses a target that the run reads: it may be the only copy of a mesh. Files are compared and not names, so that
/// symbolic and hard links are found.
void check_not_read(const std::string& option, const std::string& path, const Options& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) return;
  std::vector<std::string> all = options.input.paths;
  all.insert(all.end(), {options.generators.file, options.config});
  for (const std::string& read : all) {
    if (read.empty() || !fs::equivalent(path, read == "-" ? "/dev/stdin" : read, ignored)) continue;
    refuse_output(fmt::format("{} {}: this is the file that is read; name another one", option, path));
  }
}

bool is_binary(const std::string& format, const OutputOptions& output) {
  return (format == "ply" && !output.ascii_ply) || format == "stl" || format == "glb";
}

void check_standard_output(const OutputOptions& output) {
  const int flags = ::fcntl(STDOUT_FILENO, F_GETFL);
  if (flags == -1 || (flags & O_ACCMODE) == O_RDONLY) {
    throw Error(ErrorCode::unwritable_output, "-o -: standard output is closed; redirect it to a file or a pipe");
  }
  if (is_binary(stdout_format(output), output) && ::isatty(STDOUT_FILENO) == 1) {
    refuse_output(
        fmt::format("-o -: .{} is binary, and standard output is a terminal; redirect it, as in > a.{}, or choose "
                    "text with --output-format",
                    stdout_format(output), stdout_format(output)));
  }
}

/// The targets of a run: each one is claimed once.
class Targets {
 public:
  explicit Targets(const Options& options) : options_(options) {}

  void claim(const std::string& option, const std::string& path) {
    if (path.empty()) return;
    if (!names_.insert(path == "-" ? path : one_name(path)).second) {
      refuse_output(fmt::format("{} {}: two options name this file; name another one", option, path));
    }
    if (path == "-") {
      if (option != "-o") refuse_output(fmt::format("{} -: only -o can write to standard output; name a file", option));
      return check_standard_output(options_.output);
    }
    check_target(option, path);
    check_not_read(option, path, options_);
    check_writable(path);
  }

  void claim_with_materials(const std::string& option, const std::string& path, const OutputFormats& formats) {
    claim(option, path);
    if (!formats.materials || file_extension(path) != "obj") return;
    claim("the materials of " + option, fs::path(path).replace_extension(".mtl").string());
  }

 private:
  const Options& options_;
  std::set<std::string> names_;
};

void check_format(const std::string& file, const std::vector<std::string>& formats) {
  if (file.empty()) refuse_output("-o: the file name is empty; name a file");
  if (file == "-" || std::find(formats.begin(), formats.end(), file_extension(file)) != formats.end()) return;
  refuse_output(fmt::format("-o {}: the extension must be one of .{}", file, fmt::join(formats, ", .")));
}

/// Refuses inputs of one name before the work: the second result would replace the first.
void check_names(const std::vector<Options>& runs) {
  std::map<std::string, std::string> input_of;
  for (const Options& run : runs) {
    for (const std::string& file : run.output.files) {
      const auto [other, is_new] = input_of.emplace(file, run.input.path);
      if (is_new) continue;
      if (one_name(other->second) == one_name(run.input.path)) {
        refuse_output(fmt::format("INPUT {}: is there twice; keep one", run.input.path));
      }
      refuse_output(fmt::format("--output-dir: {} and {} would both write {}; rename one, or run them apart",
                                other->second, run.input.path, file));
    }
  }
}

[[noreturn]] void refuse_folder(const std::string& folder, const std::string& reason) {
  throw Error(ErrorCode::unwritable_output, fmt::format("--output-dir {}: {}", folder, reason));
}

/// Makes one folder, not those above it: a misspelt path is not to be made.
void make_folder(const std::string& folder) {
  std::error_code failed;
  const fs::path above = fs::absolute(fs::path(folder) / "").parent_path().parent_path();
  if (!fs::is_directory(above, failed)) {
    refuse_folder(folder, fmt::format("there is no directory {}; create it first", above.string()));
  }
  fs::create_directory(folder, failed);
  if (failed) refuse_folder(folder, failed.message() + "; name another one");
}

/// The folder is made last, once nothing else is wrong: what is not there holds nothing that could be lost.
void check_folder(const Options& options, const OutputFormats& formats) {
  const std::string& folder = options.output.folder;
  const std::vector<Options> runs = plan_runs(options);
  check_names(runs);
  std::error_code ignored;
  if (!fs::exists(folder, ignored)) return make_folder(folder);
  if (!fs::is_directory(folder, ignored)) refuse_folder(folder, "is a file; name a folder");
  Targets targets(options);
  for (const Options& run : runs) {
    for (const std::string& file : run.output.files) targets.claim_with_materials("--output-dir", file, formats);
  }
}

}  // namespace

void check_outputs(const Options& options, const OutputFormats& formats) {
  const OutputOptions& output = options.output;
  if (!output.folder.empty()) return check_folder(options, formats);
  Targets targets(options);
  for (const std::string& file : output.files) {
    check_format(file, formats.extensions);
    targets.claim_with_materials("-o", file, formats);
  }
  targets.claim("--report", output.report);
  targets.claim("--diagram", output.diagram);
  targets.claim("--view", output.view);
  for (const auto& [option, file] : output.own) targets.claim(option, file);
}

}  // namespace gvd::app
