#pragma once

#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "common/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/view.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The steps that the commands are made of, in their order. Each one times itself, shows its progress, says on standard
// error what the user must know, and puts its figures into the run's report. All of them throw gvd::Error.

namespace gvd::app {

/// Reads and checks the mesh. Repairs are said in one line each.
CheckedMesh load_input(Run& run);

/// The generators that the options ask for, exactly as many as they say.
std::vector<SurfacePoint> make_generators(Run& run, const CheckedMesh& input);

/// The diagram by the method that the options name; fills the report's figures of the diagram.
Diagram build_diagram(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& generators);

/// Writes to `-o` in one format.
using OutputWriter = std::function<void(std::ostream&)>;

/// Writes every `-o` file: `mesh` in the formats of meshes, and what `own_formats` (by extension without its dot) holds
/// before these.
void write_output_files(Run& run, const LabelledMesh& mesh,
                        const std::map<std::string, OutputWriter>& own_formats = {});

/// Writes `--diagram` where it is asked for.
void write_diagram_file(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Writes `--view` where it is asked for; `make_scenes` is called only then. The input's file name joins the title.
void write_view_file(Run& run, const std::string& title, const std::function<std::vector<ViewScene>()>& make_scenes);

/// With `--verify`: measures the diagram against exact distances, for the report and on standard error.
void verify(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Writes `--report` where it is asked for: to be called last.
void write_report_file(Run& run);

}  // namespace gvd::app
