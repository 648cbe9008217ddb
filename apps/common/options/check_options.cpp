// Refuses options before any work starts if the run could not succeed: words that are no input, options that this build
// lacks, and outputs that can't be written or would replace a file that is read. A folder for outputs is made last,
// when nothing else is wrong. Targets are compared as files and not as names, so that links and "./" can't hide that
// two are the same.

#include "common/options/check_options.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <map>
#include <set>
#include <utility>
#include <variant>

#include "gvd/error.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/write_file.hpp"
#include "gvd/option_text.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

[[noreturn]] void refuse_target(const Target& target, const std::string& reason) {
  throw Error(ErrorCode::unwritable_output, fmt::format("{}: {}", name_of(target), reason));
}

/// Describes what a word on the command line that is no file may have been meant for. `follows`: whether it follows
/// another INPUT.
std::string describe_stray(const std::string& word, bool follows, const Options& options,
                           const OutputFormats& formats) {
  std::error_code ignored;
  if (word.starts_with('-')) {
    return parse_number<double>(word) ? "is not a file; a value follows the name of its option"
                                      : "is not a file; put options before --";
  }
  if (fs::is_directory(word, ignored))
    return fmt::format("is a directory; did you mean {}?", placeholder("output_dir", word));
  if (word == "%") return "is not a file; a percentage has no blank before %";
  if (parse_number<std::int64_t>(word)) {
    for (const char* const name : {"vertices", "from"}) {
      if (!options.given->has(name)) continue;
      return fmt::format("is not a file; {} takes commas without blanks, as in 3,17,99", placeholder(name));
    }
    if (options.list->find("count") != nullptr && !options.given->has("count")) {
      return fmt::format("is not a file; did you mean {}?", placeholder("count", word));
    }
  }
  return follows && contains(formats.extensions, file_extension(word))
             ? fmt::format("is not a file; did you mean {}?", placeholder("output", word))
             : "is not a file; options begin with a dash";
}

bool may_be_read(const std::string& path) {
  std::error_code ignored;
  return path == "-" || (fs::exists(path, ignored) && !fs::is_directory(path, ignored));
}

/// Refuses several inputs without a folder for their outputs, or a word among them that is no file.
[[noreturn]] void refuse_several(const Options& options, const OutputFormats& formats) {
  const std::vector<std::string>& paths = options.input.paths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (may_be_read(paths[i])) continue;
    const std::string word = user_text(paths[i]);
    refuse(fmt::format("unexpected: '{}' {}", word, describe_stray(word, i > 0, options, formats)));
  }
  const std::string others = paths.size() == 2 ? paths.back() : fmt::format("{} others", paths.size() - 1);
  // If there are two words and the second is an output of an earlier run, it was probably meant as the output.
  const bool names_output =
      paths.size() == 2 && contains(formats.extensions, file_extension(others)) && options.output.files.empty();
  refuse(fmt::format("{} inputs, {} and {}: name a folder for their outputs with \1output_dir\2{}", paths.size(),
                     paths.front(), others,
                     names_output ? ", or write " + placeholder("output", others) + " for an output" : ""));
}

/// Refuses words that are commands in other programs.
void check_commands(const std::string& path) {
  if ((path == "help" || path == "version") && !may_be_read(path)) {
    refuse(fmt::format("unexpected: '{}' is not a file; did you mean {}?", path, placeholder(path)));
  }
}

/// The names that an option reads: files, or properties and the like that it takes in place of files.
std::vector<std::string> list_read(const Field& field) {
  using Names = std::vector<std::string>;
  return std::visit(Overload{[&](const File& file) {
                               const bool is_read = file.use == File::Use::read;
                               return is_read ? write_option(field).value_or(Names()) : Names();
                             },
                             [](const PointList& list) { return Names{list.value->file}; },
                             [](const Curves& curves) { return Names{curves.value->name}; },
                             [](const ValueSource& values) { return Names{values.value->name}; },
                             [](const auto&) { return Names(); }},
                    field);
}

/// The files that options name besides INPUT and --config; empty names for options that are not given.
std::vector<std::string> list_read_files(const Options& options) {
  std::vector<std::string> files;
  for (const Option* const option : options.list->options()) {
    if (option->spec.positional || option->name == "config") continue;
    for (std::string& name : list_read(option->field)) files.push_back(std::move(name));
  }
  return files;
}

}  // namespace

// Several inputs need a folder for their outputs, and standard input would have no name there.
void check_inputs(const Options& options, const OutputFormats& formats) {
  const std::vector<std::string>& paths = options.input.paths;
  std::vector<std::string> piped;  // the options that read standard input
  for (const Option* const option : options.list->options()) {
    const bool reads = option->spec.positional ? options.input.path == "-" : contains(list_read(option->field), "-");
    if (reads && option->name != "config") piped.push_back(option->name);
  }
  const bool into_folder = !options.output.folder.empty();
  check_commands(options.input.path);
  if (options.input.path == "-" && !options.input.format) {
    refuse("standard input has no extension: name its format with " + input_format_option());
  }
  if (piped.size() > 1) {
    refuse(fmt::format("{} and {} are both standard input, which holds one of them: name a file for the other",
                       placeholder(piped[0]), placeholder(piped[1])));
  }
  if (!into_folder && paths.size() > 1) refuse_several(options, formats);
  if (into_folder && contains(paths, "-")) {
    refuse("\1output_dir\2: standard input has no name for its outputs; write them with \1output\2");
  }
  if (!into_folder || paths.size() == 1) return;
  if (!piped.empty()) {
    refuse(fmt::format("{}: standard input can be read for one input only; name a file", placeholder(piped[0], "-")));
  }
  for (const std::string& file : list_read_files(options)) {
    if (is_read_once(file)) refuse(fmt::format("{}: a pipe can be read for one input only; name a file", file));
  }
}

namespace {

/// Refuses options of features that this build lacks.
void check_build(const Options& options) {
#ifndef GVD_HAS_VERIFY
  if (options.compute.verify) refuse("\1verify\2: not part of this build; configure it with -DGVD_WITH_CGAL_GPL=ON");
#endif
  if ((!options.output.view.empty() || options.output.views) && !has_viewer()) {
    refuse(placeholder(options.output.open ? "open" : "view") +
           ": the viewer is not part of this build; configure it with -DGVD_WITH_VIEWER=ON");
  }
}

/// Refuses a target that the run also reads, because it may be the only copy of a mesh. Compares files and not names,
/// so that symbolic and hard links are recognised.
void check_not_read(const Target& target, const Options& options) {
  std::error_code ignored;
  if (!fs::is_regular_file(target.path, ignored)) return;
  std::vector<std::string> all = options.input.paths;
  const std::vector<std::string> named = list_read_files(options);
  all.insert(all.end(), named.begin(), named.end());
  all.push_back(options.general.config);
  for (const std::string& read : all) {
    if (read.empty() || !fs::equivalent(target.path, read == "-" ? "/dev/stdin" : read, ignored)) continue;
    refuse(name_of(target) + ": the run reads this file; name another one");
  }
}

void check_standard_output(const OutputOptions& output) {
  const int flags = ::fcntl(STDOUT_FILENO, F_GETFL);
  if (flags == -1 || (flags & O_ACCMODE) == O_RDONLY) {
    refuse_target({"output", "-"}, "standard output is closed; redirect it to a file or a pipe");
  }
  const std::string format = format_of(output, "-");
  const Format* const row = find_output(format);
  const bool is_text = row == nullptr || !row->is_binary || (row->id == MeshFormat::ply && output.ascii_ply);
  if (!is_text && ::isatty(STDOUT_FILENO) == 1) {
    refuse(
        fmt::format("\1output=-\2: .{0} is binary, and standard output is a terminal; redirect it, as in > a.{0}, or "
                    "choose text with \1output_format\2",
                    format));
  }
}

/// Says why nothing can be created in what should be a folder, and what to do.
std::string describe_missing(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder, ignored) ? fmt::format("{} is not a directory; choose another one", folder.string())
                                     : fmt::format("there is no directory {}; create it first", folder.string());
}

/// Refuses a target that can't be written, as far as that follows from its folder.
void check_target(const Target& target) {
  std::error_code ignored;
  const fs::path path(target.path), folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (fs::is_directory(path, ignored)) refuse_target(target, "is a directory; name a file");
  if (!fs::is_directory(folder, ignored)) refuse_target(target, describe_missing(folder));
}

/// The targets of a run, each of which may be claimed only once.
class Targets {
 public:
  explicit Targets(const Options& options) : options_(options) {}

  void claim(const Target& target) {
    const std::string& path = target.path;
    if (path.empty()) return;
    if (!names_.insert(path == "-" ? path : one_name(path)).second) {
      refuse(name_of(target) + ": two outputs go there; choose another name");
    }
    if (path == "-") {
      if (target.option != "output") {
        refuse(name_of(target) + ": only \1output\2 can write to standard output; name a file");
      }
      return check_standard_output(options_.output);
    }
    check_target(target);
    check_not_read(target, options_);
    check_writable(path);
  }

  void claim_with_materials(const Target& target, const OutputFormats& formats) {
    claim(target);
    const auto materials = formats.materials ? materials_file(target.path) : std::nullopt;
    if (materials) claim({target.option, materials->string(), true});
  }

 private:
  const Options& options_;
  std::set<std::string> names_;
};

void check_extension(const OutputOptions& output, const std::string& file, const std::vector<std::string>& extensions) {
  if (file.empty()) refuse("\1output\2: the file name is empty; name a file");
  if (file == "-" || contains(extensions, format_of(output, file))) return;
  refuse(fmt::format("{}: the extension must be one of {}", placeholder("output", file),
                     list_extensions(extensions, "or")));
}

/// Refuses inputs with the same name before any work, because the second result would replace the first.
void check_names(const std::vector<Options>& runs) {
  std::map<std::string, std::string> input_of;
  for (const Options& run : runs) {
    for (const std::string& file : run.output.files) {
      const auto [other, is_new] = input_of.emplace(file, run.input.path);
      if (is_new) continue;
      if (one_name(other->second) == one_name(run.input.path)) {
        refuse(placeholder("input", run.input.path) + ": given twice; keep one");
      }
      refuse(fmt::format("\1output_dir\2: {} and {} would both write {}; rename one of them, or run them separately",
                         other->second, run.input.path, file));
    }
  }
}

/// Makes a folder but not its parents, so that a misspelt path is not created.
void make_folder(const std::string& folder) {
  std::error_code failed;
  const fs::path above = fs::absolute(fs::path(folder) / "").parent_path().parent_path();
  if (!fs::is_directory(above, failed)) {
    refuse_target({"output_dir", folder}, describe_missing(above));
  }
  fs::create_directory(folder, failed);
  if (failed) refuse_target({"output_dir", folder}, failed.message() + "; name another one");
}

/// Checks the folder for outputs. A folder that does not exist holds nothing that could be lost. --summary may be in
/// this folder, too.
void check_folder(const Options& options, const OutputFormats& formats) {
  const std::string &folder = options.output.folder, &summary = options.output.summary;
  const std::vector<Options> runs = plan_runs(options);
  check_names(runs);
  Targets targets(options);
  std::error_code ignored;
  const bool is_new = !fs::exists(folder, ignored);
  const bool is_inside = one_name(fs::path(summary).parent_path().string()) == one_name(folder);
  if (!is_new || !is_inside) targets.claim({"summary", summary});
  if (is_new) return make_folder(folder);
  if (!fs::is_directory(folder, ignored)) refuse_target({"output_dir", folder}, "is a file; name a folder");
  for (const Options& run : runs) {
    for (const Target& target : list_targets(run.output)) targets.claim_with_materials(target, formats);
  }
}

/// Checks --view. Only without a folder can the page have a name of its own.
void check_view(const OutputOptions& output) {
  if (output.folder.empty() && output.views) {
    refuse("\1view\2: the name is empty; name a file, as in \1view=page.html\2");
  }
  if (output.folder.empty() || output.view.empty()) return;
  refuse(placeholder("view", output.view) +
         ": with \1output_dir\2, pages are named after the inputs; give \1view\2 without a name");
}

}  // namespace

void check_outputs(const Options& options, const OutputFormats& formats) {
  check_build(options);
  const OutputOptions& output = options.output;
  if (output.folder.empty() && output.formats.size() > 1) {
    refuse("\1output_format\2: \1output=-\2 writes one format; choose one");
  }
  check_view(output);
  if (!output.folder.empty()) return check_folder(options, formats);
  for (const std::string& file : output.files) check_extension(output, file, formats.extensions);
  Targets targets(options);
  for (const Target& target : list_targets(output)) targets.claim_with_materials(target, formats);
}

std::vector<Options> plan_runs(const Options& options) {
  std::vector<Options> runs;
  for (const std::string& path : options.input.paths) {
    Options& run = runs.emplace_back(options);
    run.input.path = path;
    if (options.output.folder.empty()) continue;
    const fs::path name = fs::path(path).filename(), unpacked = file_extension(path) == "gz" ? name.stem() : name;
    const bool is_surface = unpacked.extension() == ".gii" && unpacked.stem().extension() == ".surf";
    const fs::path bare = is_surface ? unpacked.stem().stem() : unpacked.stem();
    const std::string stem = (fs::path(options.output.folder) / bare).string();
    for (const std::string& format : options.output.formats) run.output.files.push_back(stem + '.' + format);
    if (options.output.views) run.output.view = stem + ".html";
  }
  return runs;
}

}  // namespace gvd::app
