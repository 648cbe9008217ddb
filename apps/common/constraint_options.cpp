#include "common/constraint_options.hpp"

#include <fmt/format.h>

#include <limits>

#include "common/options/typed_options.hpp"

namespace gvd::app {

void register_constraints(CommandLine& line, ConstraintOptions& options) {
  constexpr Range<double> kAngle{std::numeric_limits<double>::min(), 180, "above 0 and at most 180"};
  constexpr Range<double> kGradation{std::numeric_limits<double>::min(), std::numeric_limits<double>::max(), "above 0"};
  const auto text = [](const char* name, const char* type, const std::string& description) {
    return OptionText{name, type, description, "Constraints"};
  };
  add_file(line, text("--fixed", "FILE", "List of generators that stay where they are; -n counts them, too"),
           options.fixed);
  add_number(line,
             text("--features", "",
                  "Put generators on corners and creases first and keep them there; a crease is an edge between faces "
                  "whose normals differ by more than this many degrees"),
             options.features, kAngle);
  line.add_flag(text("--keep-boundary", "", "Put generators on the boundary first and keep them there"),
                options.keep_boundary);
  add_text(line,
           text("--density", "WHAT",
                "Weight of the surface, > 0; cells are smaller where it is large: 'curvature', a file with a number "
                "for each vertex or each face, or the name of a property of a PLY input"),
           options.density);
  add_number(line,
             text("--gradation", "",
                  fmt::format("With --density curvature, the largest change of the size per length (default: {})",
                              options.gradation)),
             options.gradation, kGradation);
}

}  // namespace gvd::app
