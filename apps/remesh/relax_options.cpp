#include "remesh/relax_options.hpp"

#include <fmt/format.h>

#include "common/options/typed_options.hpp"
#include "gvd/error.hpp"

namespace gvd::app {
namespace {

constexpr Range<std::int32_t> kIterations{0, 1000000, "a whole number from 0 to 1000000, nor 'none'"};

}  // namespace

void register_relaxation(CommandLine& line, RelaxOptions& options) {
  line.add_value(
      {"--relax", "N|none",
       fmt::format("Iterations that move the generators to the centroids of their cells first; 'none' moves none "
                   "(default: {}, for --generators and --vertices none)",
                   kDefaultRelaxation),
       "Relaxation"},
      [&options](const std::string& text) -> std::optional<std::string> {
        const std::optional<std::int32_t> value = text == "none" ? 0 : parse_number_in(text, kIterations);
        if (!value) return fmt::format("'{}' is not {}", text, kIterations.text);
        options.iterations = *value;
        return std::nullopt;
      });
  register_constraints(line, options.constraints);
  line.add_flag({"--loose-boundary",
                 "",
                 "Put no generators on the boundary: the outline then runs through generators beside it (default: "
                 "--keep-boundary for -n and --radius, where it takes at most four fifths of them)",
                 "Constraints",
                 {},
                 {"--keep-boundary"}},
                options.loose_boundary);
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
  throw Error(ErrorCode::invalid_option,
              fmt::format("{}: no generator is moved; {}", idle,
                          options.iterations ? "leave out one of it and --relax none" : "ask for it with --relax N"));
}

}  // namespace gvd::app
