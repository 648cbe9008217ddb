#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/process.hpp"
#include "common/run.hpp"
#include "gvd/diagram.hpp"
#include "gvd/io/mesh_writer.hpp"
#include "gvd/io/view.hpp"
#include "gvd/object.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"

// The parts that the runs of the commands share after `load_input`, in order. Each part times its steps, notes what
// users should know, and fills in its members of the report.
namespace gvd::app {

/// Lists generators in the report. `snap_distance`: how far each was moved to the surface, as far as known.
void report_generators(Run& run, const Mesh& mesh, const std::vector<SurfacePoint>& points,
                       const std::vector<std::optional<double>>& snap_distance);

/// The time and memory that a command needs for each generator if a mesh has fewer faces than generators. Then nearly
/// all of the work is for the generators, and grows with their number.
struct GeneratorCost {
  double microseconds, kilobytes;
};

/// Notes in advance how long the generators may take, if there are more of them than faces and the time is long.
void note_many_generators(Run& run, const Mesh& mesh, std::int64_t count, const GeneratorCost& cost);

/// Adds the figures of an object to the results of the report, if it is written.
void report_figures(Run& run, const Object& object);

/// Writes to `-o` in a format.
using OutputWriter = std::function<void(std::ostream&)>;

// Each of the following functions writes only if its option is given, and throws Error{unwritable_output} if it can't.

/// Writes every `-o` file: by the writer in `own_formats` for its extension (without the dot), or otherwise `mesh`.
void write_output_files(Run& run, const LabelledMesh& mesh, const OwnWriters& own_formats = {});
void write_output_files(Run& run, const Object& object);

/// Writes `--diagram`.
void write_diagram_file(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Writes the file of an option that `describe_target` described.
void write_own_file(Run& run, const std::string& option, const OutputWriter& write);
/// Writes a part of an object (Object::part_writers) to the file of the option of the same name.
void write_part_file(Run& run, const std::string& option, const Object& object);

/// Writes `--view`, and calls `make_scenes` only for it. Adds the name of the input file to the title.
void write_view_file(Run& run, const std::string& title, const std::function<std::vector<ViewScene>()>& make_scenes);

/// Ends a run: with `--verify`, measures, notes and reports the error of the diagram against exact distances; then
/// writes `--report`.
void finish_run(Run& run, const Mesh& mesh, const Diagram& diagram);

/// Ends a run without a diagram: writes `--report`.
void write_report(Run& run);

}  // namespace gvd::app
