#include "common/options/check_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/options/check_outputs.hpp"
#include "gvd/error.hpp"
#include "gvd/io/view.hpp"

namespace gvd::app {
namespace {

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

/// Several inputs need a folder for their outputs, in which standard input has no name.
void check_inputs(const Options& options) {
  const std::vector<std::string>& paths = options.input.paths;
  const OutputOptions& output = options.output;
  const bool piped = std::find(paths.begin(), paths.end(), "-") != paths.end();
  if (output.folder.empty() && paths.size() > 1) {
    refuse(fmt::format("{} inputs, {} and others: name a folder for their outputs with --output-dir", paths.size(),
                       paths.front()));
  }
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
  check_inputs(options);
  check_generator_source(options.generators);
  check_chord_tolerance(options.compute);
  check_build(options);
  check_outputs(options, formats);
}

}  // namespace gvd::app
