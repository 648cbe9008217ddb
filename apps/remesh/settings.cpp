// The options of gvd-remesh. Listed generators stay where the user has put them, and sampled ones move to the centroids
// of their cells, since random samples make poor triangles.

#include "remesh/settings.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "common/options/register_options.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr Range<std::int32_t> kIterations{0, 1000000, "a whole number from 0 to 1000000 or 'none'"};
constexpr Range<double> kShapes{0, 1, "a number from 0 to 1"};
constexpr Range<std::int64_t> kMaxAdded{0, 1000000000, "a whole number from 0 to 1000000000"};

/// A number above 0, or percents of the diagonal.
std::optional<ErrorBound> parse_error_bound(std::string text) {
  const bool percent = text.ends_with('%');
  if (percent) text.pop_back();
  const std::optional<double> value = parse_number_in(text, kPositive);
  if (!value) return std::nullopt;
  return ErrorBound{percent ? *value / 100 : *value, percent};
}

void register_sizes(CLI::App& line, GeneratorOptions& generators) {
  line.option_defaults()->group("Sizes (in place of these four)");
  add_number(line, "--target-edge", generators.target_edge, kPositive,
             "Sample as many generators as give edges of this average length, in mesh units");
  const auto store = [&generators](const std::string& text) {
    generators.error = parse_error_bound(text);
    return generators.error ? "" : fmt::format("'{}' is neither a finite number above 0 nor one with a %", text);
  };
  add_parsed(line, "--error", "NUMBER[%]", store,
             "Use the fewest generators whose mesh stays within this distance of the input, in mesh units or in "
             "percent of the bounding box's diagonal; takes up to 17 remeshes")
      ->excludes("--target-edge");
  for (const char* size : {"--target-edge", "--error"}) {
    line.get_option(size)->excludes("--count", "--radius", "--generators", "--vertices", "--merge-coincident");
  }
}

void register_relaxation(CLI::App& line, Settings& settings) {
  const auto store = [&settings](const std::string& text) {
    const std::optional<std::int32_t> value = text == "none" ? 0 : parse_number_in(text, kIterations);
    if (value) settings.relaxation = *value;
    return value ? "" : fmt::format("'{}' is not {}", text, kIterations.text);
  };
  line.option_defaults()->group("Relaxation");
  add_parsed(line, "--relax", "N|none", store,
             fmt::format("Iterations that first move the generators to the centroids of their cells; 'none' leaves "
                         "them in place (default: {}; none with --generators and --vertices)",
                         kRemeshRelaxation));
  register_coarse(line, settings.constraints);
  settings.constraints.auto_features = true;
  register_constraints(line, settings.constraints);
  add_flag(line, "--loose-boundary", settings.loose_boundary,
           "Put no generators on the boundary; the outline then runs through generators beside it (default with -n and "
           "--radius: --keep-boundary, if it takes at most half of the generators)")
      ->excludes("--keep-boundary");
}

void register_remesh(CLI::App& line, Settings& settings) {
  line.option_defaults()->group("Remesh");
  add_number(line, "--max-added", settings.remesh.max_added, kMaxAdded,
             "Largest number of generators to add (default: ten for each given generator, component, boundary loop and "
             "handle, plus 100)");
  add_flag(line, "--no-refine", settings.no_refine,
           "Add no generators; fail if the given ones are too few for a valid mesh")
      ->excludes("--max-added");
  add_flag(line, "--exact-count", settings.exact_count,
           "Exactly as many vertices as asked for, or no mesh: leave out a generator where the mesh can do without it "
           "for each one that is added (generators of a list stay: the same as --no-refine)")
      ->excludes("--no-refine");
  add_choice(line, "--place", settings.place, kPlacementNames,
             "Where to put vertices: at the generators, at the best points for the planes of their cells, or fitted to "
             "the surface (default: fit; generator with --generators and --vertices)");
  add_number(line, "--shape", settings.shape, kShapes,
             fmt::format("With --place fit: from 0, the nearest to the surface, to 1, the best triangles (default: {})",
                         PlacementOptions().shape));
  add_flag(line, "--allow-intersections", settings.remesh.allow_intersections,
           "Accept triangles that intersect each other instead of adding generators there");
  add_flag(line, "--carry", settings.carry,
           "Carry over the colours and other properties of a PLY input to PLY output, texture coordinates to PLY, OBJ "
           "and GLB output, and materials to OBJ output");
}

/// Refuses an option that does nothing because no generator is relaxed.
void check_relaxation(const Settings& settings, const GeneratorOptions& generators) {
  if (settings.relaxation.value_or(generators.are_listed() ? 0 : kRemeshRelaxation) > 0) return;
  const char* idle = !settings.constraints.density.empty()         ? "--density"
                     : !settings.constraints.fixed.empty()         ? "--fixed"
                     : settings.constraints.coarse.value_or(0) > 0 ? "--coarse"
                                                                   : nullptr;
  if (!idle) return;
  throw Error(ErrorCode::invalid_option, fmt::format("{}: no generator is moved; {}", idle,
                                                     settings.relaxation ? "leave it out, or leave out --relax none"
                                                                         : "ask for it with --relax N"));
}

/// Refuses a shape where no vertex is fitted.
void check_shape(const Settings& settings, const GeneratorOptions& generators) {
  const Placement usual = generators.are_listed() ? Placement::generator : Placement::fit;
  if (!settings.shape || settings.place.value_or(usual) == Placement::fit) return;
  throw Error(ErrorCode::invalid_option,
              fmt::format("--shape: no vertex is fitted; {}",
                          settings.place ? "leave it out, or take --place fit" : "ask for it with --place fit"));
}

}  // namespace

void register_settings(Command& command, Settings& settings) {
  register_sizes(command.line(), command.options().generators);
  register_relaxation(command.line(), settings);
  register_remesh(command.line(), settings);
}

void check_settings(const Options& options, const Settings& settings) {
  if (options.output.no_curves) {
    throw Error(ErrorCode::invalid_option, "--no-curves: the files of gvd-remesh have no curves; leave it out");
  }
  const std::vector<std::string> written = written_formats(options.output);
  if (settings.carry && !contains(written, "ply") && !contains(written, "obj") && !contains(written, "glb")) {
    throw Error(ErrorCode::invalid_option,
                "--carry: only PLY, OBJ and GLB files hold what is carried over; write one, such as -o FILE.ply");
  }
  check_relaxation(settings, options.generators);
  check_shape(settings, options.generators);
}

}  // namespace gvd::app
