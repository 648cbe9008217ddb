#pragma once

#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "common/run/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/view.hpp"

// Each function writes where its option is given, and throws Error{unwritable_output} where it can't.
namespace gvd::app {

/// Writes to `-o` in one format.
using OutputWriter = std::function<void(std::ostream&)>;

/// Writes every `-o` file: in the formats of `own_formats`, by extension without its dot, or else `mesh`.
void write_output_files(Run& run, const LabelledMesh& mesh,
                        const std::map<std::string, OutputWriter>& own_formats = {});

/// Writes `--diagram`.
void write_diagram_file(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Writes the file of an option that `Command::add_target` added.
void write_own_file(Run& run, const std::string& option, const OutputWriter& write);

/// Writes `--view`; `make_scenes` is called only then. The name of the input file is added to the title.
void write_view_file(Run& run, const std::string& title, const std::function<std::vector<ViewScene>()>& make_scenes);

/// Writes `--report`: to be called last.
void write_report_file(Run& run);

}  // namespace gvd::app
