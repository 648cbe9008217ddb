// How gvd-remesh relaxes: listed generators stay where the user has put them, and sampled ones move to the centroids of
// their cells, since random samples make poor triangles.

#include "remesh/relax_options.hpp"

#include <fmt/format.h>

#include "common/options/register_options.hpp"
#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr Range<std::int32_t> kIterations{0, 1000000, "a whole number from 0 to 1000000 or 'none'"};

}  // namespace

void register_relaxation(CLI::App& app, RelaxOptions& options) {
  const auto store = [&options](const std::string& text) {
    const std::optional<std::int32_t> value = text == "none" ? 0 : parse_number_in(text, kIterations);
    if (value) options.iterations = *value;
    return value ? "" : fmt::format("'{}' is not {}", text, kIterations.text);
  };
  app.option_defaults()->group("Relaxation");
  add_parsed(app, "--relax", "N|none", store,
             fmt::format("Iterations that first move the generators to the centroids of their cells; 'none' leaves "
                         "them in place (default: {}; none with --generators and --vertices)",
                         kDefaultRelaxation));
  register_constraints(app, options.constraints);
  add_flag(app, "--loose-boundary", options.loose_boundary,
           "Put no generators on the boundary; the outline then runs through generators beside it (default with -n and "
           "--radius: --keep-boundary, if it takes at most four fifths of the generators)")
      ->excludes("--keep-boundary");
}

std::int32_t relax_iterations(const RelaxOptions& options, const GeneratorOptions& generators) {
  return options.iterations.value_or(generators.are_listed() ? 0 : kDefaultRelaxation);
}

void check_relaxation(const RelaxOptions& options, const GeneratorOptions& generators) {
  if (relax_iterations(options, generators) > 0) return;
  const char* idle = !options.constraints.density.empty() ? "--density"
                     : !options.constraints.fixed.empty() ? "--fixed"
                                                          : nullptr;
  if (!idle) return;
  throw Error(ErrorCode::invalid_option, fmt::format("{}: no generator is moved; {}", idle,
                                                     options.iterations ? "leave it out, or leave out --relax none"
                                                                        : "ask for it with --relax N"));
}

}  // namespace gvd::app
