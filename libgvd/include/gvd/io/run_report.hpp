#pragma once

#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Named numbers in the order in which they are written.
template <class Number>
using NamedNumbers = std::vector<std::pair<std::string, Number>>;

/// A generator as the report lists it.
struct ReportedGenerator {
  SurfacePoint point;
  Vec3 position = Vec3::Zero();         ///< mesh units
  std::optional<double> snap_distance;  ///< mesh units; from the given position, where one was given
};

/// Difference between the diagram and exact distances (section 5.2 of the paper).
struct VerifyFigures {
  double error_integral = 0;  ///< along the bisectors, square mesh units
  double error_max = 0;       ///< mesh units
  double length = 0;          ///< of the bisectors, mesh units; the mean error is error_integral / length
};

/// A diagram in figures.
struct DiagramFigures {
  std::int64_t branch_points = 0;
  std::int64_t bisectors = 0;
  double length = 0;  ///< of all bisectors, mesh units
  std::int64_t cells = 0;
  std::int64_t disc_cells = 0;  ///< connected cells of Euler characteristic 1
  std::int64_t unresolved_ends = 0;
  std::int64_t relabelled_vertices = 0;  ///< see DiagramReport
  std::int64_t straightened_faces = 0;   ///< see DiagramReport
  std::optional<VerifyFigures> verify;   ///< of a run that measured it
};

/// Cost: O(cells).
DiagramFigures summarize_diagram(const Diagram& diagram);

/// What a command did: the content of `--report`.
struct RunReport {
  std::string command;
  std::string version;
  std::string options = "{}";  ///< text of a JSON object
  std::uint64_t seed = 0;
  MeshSummary input;
  NamedNumbers<std::int64_t> defects;  ///< how many of each kind the input had
  std::vector<ReportedGenerator> generators;
  std::optional<DiagramFigures> diagram;  ///< null in the file where the run made none
  NamedNumbers<double> timings_ms;
  std::int64_t peak_memory_bytes = 0;
  std::string results = "{}";  ///< text of a JSON object: the command's own
};

/// Writes the report as `gvd-report/1`; the stream is flushed and checked. Its generators can be read back with
/// `parse_generators`. Numbers that are not finite become null; bytes that are no UTF-8 become U+FFFD.
/// Throws Error{precondition} where options or results are no JSON object, Error{unwritable_output}.
void write_run_report(std::ostream& out, const RunReport& report);

}  // namespace gvd
