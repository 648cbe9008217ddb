#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/options/options.hpp"
#include "common/run.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/option_list.hpp"
#include "gvd/relaxation_start.hpp"
#include "gvd/soup.hpp"

// The start of a relaxation, the relaxation, and words of its report, for gvd-lloyd and gvd-remesh.
namespace gvd::app {

/// Files that restrict and weigh a relaxation.
struct ConstraintFiles {
  std::string fixed;    ///< a list of generators that stay; empty: none
  std::string density;  ///< "curvature", a file, or a property of the input; empty: uniform
};

void describe(OptionList& list, ConstraintFiles& files);

/// The options for the start of a relaxation, with the generators, and what is in the files. Throws what
/// make_generators, read_density and read_generators throw, and Error{unreadable_input} where --density names neither
/// a file nor a property.
RelaxationStartOptions make_start_options(Run& run, const CheckedMesh& input, const ConstraintFiles& files,
                                          RelaxationStartOptions options);

/// The density that `option` names: none for an empty name. Throws what read_density throws, and
/// Error{unreadable_input} where it names neither a file nor a property.
Density find_density(Run& run, const CheckedMesh& input, const std::string& option, const std::string& name);

/// Notes how many of a start's generators are fixed, on creases and free, what they do not follow, and why a
/// copy that was asked for is not used.
void report_start(Run& run, const Mesh& mesh, const RelaxationStart& start, const RelaxationStartOptions& options);

/// Shows iteration and energy in the bar from now on.
void show_iteration(Run& run, std::int64_t iterations, double energy);

/// Notes what was done on a copy of the mesh. `copy_faces`: of the copy of the start; 0: there was none.
void note_copy(Run& run, const CoarseRelaxation& used, const RelaxationStart& start, bool ends_on_copy);

/// The part of a relaxation on a copy of the mesh, for reports; null where there was none.
nlohmann::ordered_json describe_copy(const CoarseRelaxation& copy);

}  // namespace gvd::app
