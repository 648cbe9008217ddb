#pragma once

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/options/options.hpp"
#include "gvd/diagram.hpp"
#include "gvd/error_measure.hpp"
#include "gvd/soup.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd::app {

/// A generator as the report lists it.
struct ReportedGenerator {
  SurfacePoint point;
  Vec3 position = Vec3::Zero();         ///< mesh units
  std::optional<double> snap_distance;  ///< mesh units; from the given position, where one was given
};

/// The record of a run: the document of `--report`, schema `gvd-report/1`. The body of the run fills it in, and it is
/// written once, at the end. docs/guide/formats.md lists its members.
class RunReport {
 public:
  RunReport(const std::string& command, const Options& options);
  ~RunReport();
  RunReport(const RunReport&) = delete;
  RunReport& operator=(const RunReport&) = delete;

  /// Member `options`, an object: the shared options are in it, a command adds its own.
  nlohmann::ordered_json& options();
  /// Member `results`, an object: the figures of the command itself.
  nlohmann::ordered_json& results();
  /// Member `generators`: those that the run used or leaves, in the order of their ids.
  std::vector<ReportedGenerator>& generators() { return generators_; }

  /// Lists these points. Generators that are listed already, in their places, keep their snap distances.
  void set_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points);

  void set_input(const MeshSummary& mesh, const DefectReport& defects);
  /// The figures of a diagram. Replaces those of an earlier one and its error measure. Cost: O(cells).
  void set_diagram(const Diagram& diagram);
  /// The error of the diagram that was set.
  void set_error_measure(const ErrorMeasure& error);
  /// Wall time of a step, in milliseconds. A second time under the same name replaces the first.
  void set_time(std::string_view step, double milliseconds);
  /// Largest resident memory of the process.
  void set_peak_memory(std::int64_t bytes);

  /// Writes the document; the stream is flushed and checked. `parse_generators` reads its generators back.
  /// Numbers that are not finite become null; bytes that are no UTF-8 become U+FFFD.
  /// Throws Error{unwritable_output}. Cost: O(size).
  void write(std::ostream& out) const;

 private:
  std::unique_ptr<nlohmann::ordered_json> document_;  ///< all members in their order; `generators` is left null
  std::vector<ReportedGenerator> generators_;         ///< not in the document: a run may have very many
};

}  // namespace gvd::app
