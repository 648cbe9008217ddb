#include "common/options/check_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "common/options/check_outputs.hpp"
#include "common/options/file_extension.hpp"
#include "common/options/option_text.hpp"
#include "common/options/parse_number.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"

namespace gvd::app {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ErrorCode::invalid_option, message); }

void check_generator_source(const GeneratorOptions& generators) {
  if (generators.count || !generators.file.empty() || generators.vertices || generators.radius) return;
  if (generators.target_edge || generators.error) return;
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

/// What a word on the command line may have been meant for, though it is no file. `follows`: another INPUT.
std::string describe_stray(const std::string& word, bool follows, const Options& options,
                           const OutputFormats& formats) {
  std::error_code ignored;
  if (word.starts_with('-')) return "is no file; options go before --";
  if (std::filesystem::is_directory(word, ignored)) {
    return fmt::format("is a directory; did you mean --output-dir {}?", word);
  }
  if (parse_number<std::int64_t>(word)) {
    if (options.generators.vertices) return "is no file; --vertices has commas and no blanks: 3,17,99";
    if (!options.generators.count) return fmt::format("is no file; did you mean -n {}?", word);
  }
  const auto& known = formats.extensions;
  const bool output = std::find(known.begin(), known.end(), file_extension(word)) != known.end();
  return follows && output ? fmt::format("is no file; did you mean -o {}?", word)
                           : "is no file; options have dashes in front";
}

bool may_be_read(const std::string& path) {
  std::error_code ignored;
  return path == "-" || (std::filesystem::exists(path, ignored) && !std::filesystem::is_directory(path, ignored));
}

/// Refuses several inputs without a folder for their outputs. A word that is no file is no input either.
[[noreturn]] void refuse_several(const Options& options, const OutputFormats& formats) {
  const std::vector<std::string>& paths = options.input.paths;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    if (may_be_read(paths[i])) continue;
    const std::string word = printable(paths[i]);
    refuse(fmt::format("unexpected: '{}' {}", word, describe_stray(word, i > 0, options, formats)));
  }
  const std::string others = paths.size() == 2 ? paths.back() : fmt::format("{} others", paths.size() - 1);
  refuse(fmt::format("{} inputs, {} and {}: name a folder for their outputs with --output-dir", paths.size(),
                     paths.front(), others));
}

/// Several inputs need a folder for their outputs, in which standard input has no name.
void check_inputs(const Options& options, const OutputFormats& formats) {
  const std::vector<std::string>& paths = options.input.paths;
  const OutputOptions& output = options.output;
  const bool piped = std::find(paths.begin(), paths.end(), "-") != paths.end();
  if (output.folder.empty() && paths.size() > 1) refuse_several(options, formats);
  if (!output.folder.empty() && piped) {
    refuse("--output-dir: standard input has no name for its outputs; write them with -o");
  }
  if (!output.folder.empty() && options.generators.file == "-" && paths.size() > 1) {
    refuse("--generators -: standard input can be read for one input only; name a file");
  }
  if (output.folder.empty() && output.formats.size() > 1) {
    refuse("--output-format: -o - writes one format; choose one");
  }
}

}  // namespace

void check_options(const Options& options, const OutputFormats& formats) {
  if (options.input.path == "-" && options.input.format.empty()) {
    refuse("standard input has no extension: name its format with --input-format obj, ply, off or stl");
  }
  if (options.input.path == "-" && options.generators.file == "-") {
    refuse("INPUT and --generators are both standard input, which holds one of them: name a file for the other");
  }
  check_inputs(options, formats);
  check_generator_source(options.generators);
  check_chord_tolerance(options.compute);
  check_build(options);
  check_outputs(options, formats);
}

}  // namespace gvd::app
