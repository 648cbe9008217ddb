#include "remesh/remesh_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <nlohmann/json.hpp>

#include "gvd/quality.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const MeshSummary& s) {
  return {{"vertices", s.vertices},
          {"faces", s.faces},
          {"components", s.components},
          {"boundary_loops", s.boundary_loops},
          {"euler_characteristic", s.euler_characteristic},
          {"area", s.area}};
}

Json to_json(const TriangleQuality& q) {
  return {{"q_min", q.q_min},
          {"q_average", q.q_average},
          {"angle_min", q.angle_min},
          {"angle_min_average", q.angle_min_average},
          {"percent_below_30", q.percent_below_30}};
}

Json to_json(const Valences& v) {
  return {{"least", v.least}, {"largest", v.largest}, {"percent_regular", v.percent_regular}};
}

Json to_json(const RemeshCertificate& c) {
  return {{"manifold", c.manifold},
          {"closed_as_input", c.closed_as_input},
          {"same_euler_characteristic", c.same_euler_characteristic},
          {"same_components", c.same_components},
          {"same_boundary_loops", c.same_boundary_loops},
          {"same_in_each_component", c.same_in_each_component},
          {"flipped_faces", c.flipped_faces},
          {"unused_generators", c.unused_generators},
          {"self_intersections", c.self_intersections.size()},
          {"inherited_intersections", c.inherited_intersections},
          {"intersections_allowed", c.intersections_allowed}};
}

Json to_json(const SurfaceDistance& d) {
  return {{"hausdorff", d.hausdorff}, {"hausdorff_bound", d.hausdorff_bound}, {"rms", d.rms}};
}

/// What one defect, and what several, of a property look like, in the order of the properties.
struct DefectWords {
  const char* one;
  const char* several;
};
constexpr std::array<DefectWords, 11> kDefectWords{{
    {"component of the mesh has no generator", "components of the mesh have no generator"},
    {"cell is not a disc", "cells are not discs"},
    {"cell touches the mesh's boundary in several arcs", "cells touch the mesh's boundary in several arcs"},
    {"bisector has no branch point", "bisectors have no branch point"},
    {"pair of cells shares several bisectors", "pairs of cells share several bisectors"},
    {"set of cells shares several branch points", "sets of cells share several branch points"},
    {"cell has too few neighbours", "cells have too few neighbours"},
    {"branch point touches a cell twice", "branch points touch a cell twice"},
    {"branch point can't be cut into triangles", "branch points can't be cut into triangles"},
    {"triangle is flipped or has an edge of length 0", "triangles are flipped or have an edge of length 0"},
    {"triangle intersects another one", "triangles intersect others"},
}};

/// The defects in words, one part for each property: "3 cells are not discs, 1 triangle is flipped ..."
std::string describe_defects(const std::vector<DualDefect>& defects) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < kDefectWords.size(); ++i) {
    const auto has_property = [i](const DualDefect& d) { return static_cast<std::size_t>(d.property) == i + 1; };
    const auto count = std::count_if(defects.begin(), defects.end(), has_property);
    const DefectWords& words = kDefectWords[i];
    if (count > 0) parts.push_back(fmt::format("{} {}", count, count == 1 ? words.one : words.several));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

void note_intersections(Console& console, const RemeshCertificate& certificate) {
  const std::int64_t inherited = certificate.inherited_intersections;
  const std::int64_t own = std::ssize(certificate.self_intersections) - inherited;
  if (own > 0) {
    console.note(counted(own, "pair of triangles intersects", "pairs of triangles intersect"));
  }
  if (inherited > 0) {
    console.note(counted(inherited, "pair of triangles intersects where the input does",
                         "pairs of triangles intersect where the input does"));
  }
}

void note_distance(Console& console, const RemeshResult& result) {
  const double diagonal = result.certificate.input.bbox_diagonal;
  if (!(diagonal > 0)) return;
  const SurfaceDistance &there = result.input_to_output, &back = result.output_to_input;
  console.note(fmt::format("distance from the input, in % of the diagonal: {:.3g} at most, {:.3g} RMS",
                           100 * std::max(there.hausdorff, back.hausdorff) / diagonal,
                           100 * std::max(there.rms, back.rms) / diagonal));
}

/// What lets the edges follow more of the creases.
const char* following_advice(const RemeshResult& result, const RemeshOptions& options) {
  if (!options.refine) return "without --no-refine and --exact-count, generators are added there";
  if (result.added >= *options.max_added) return "raise --max-added";
  return "give more generators";
}

void note_result(Console& console, const RemeshResult& result, const RemeshOptions& options) {
  console.note(fmt::format("{}, {}: manifold, with the input's topology",
                           counted(result.mesh.vertex_count(), "vertex", "vertices"),
                           counted(result.mesh.face_count(), "face", "faces")));
  if (result.added_on_creases > 0) {
    console.note(fmt::format("{} added on creases and boundaries{}",
                             counted(result.added_on_creases, "generator was", "generators were"),
                             result.crease_gap_length > 0 ? "" : ", which the edges then follow"));
  }
  const std::int64_t repairs = result.added - result.added_on_creases;
  if (repairs > 0 && result.given_defects.empty()) {
    console.note(fmt::format("{} added to repair the mesh", counted(repairs, "generator was", "generators were")));
  } else if (repairs > 0) {
    console.note(fmt::format("{} added: with the given {}, {}", counted(repairs, "generator was", "generators were"),
                             result.generators.size() - static_cast<std::size_t>(result.added),
                             describe_defects(result.given_defects)));
  }
  if (result.crease_gap_length > 0) {
    console.note(fmt::format("creases and boundaries: edges do not follow {:.3g} % of their length; {}",
                             100 * result.crease_gap_length / result.crease_length, following_advice(result, options)));
  }
  note_intersections(console, result.certificate);
  note_distance(console, result);
}

}  // namespace

void report_remesh_options(Run& run, const RemeshOptions& options) {
  run.report().options()["max_added"] = *options.max_added;
  run.report().options()["allow_intersections"] = options.allow_intersections;
  run.report().options()["no_refine"] = !options.refine;
}

void report_remesh(Run& run, const Mesh& mesh, const RemeshResult& result, const RemeshOptions& options) {
  Json& results = run.report().results();
  results["added_generators"] = result.added;
  results["rounds"] = result.rounds;
  results["creases"] = {{"length", result.crease_length},
                        {"followed", result.crease_length - result.crease_gap_length},
                        {"added_generators", result.added_on_creases}};
  results["output"] = to_json(result.certificate.output);
  results["certificate"] = to_json(result.certificate);
  results["quality"] = {{"input", to_json(result.input_quality)}, {"output", to_json(result.output_quality)}};
  results["valences"] = {{"input", to_json(compute_valences(mesh))},
                         {"output", to_json(compute_valences(result.mesh))}};
  results["distance"] = {{"input_to_output", to_json(result.input_to_output)},
                         {"output_to_input", to_json(result.output_to_input)}};
  run.report().set_diagram(result.diagram);
  run.figures().regions = std::ssize(result.diagram.cells);
  // The given ones are in the report already.
  std::vector<ReportedGenerator>& generators = run.report().generators();
  for (std::size_t i = generators.size(); i < result.generators.size(); ++i) {
    const SurfacePoint& p = result.generators[i];
    generators.push_back({p, position(mesh, p), std::nullopt});
  }
  note_result(run.console(), result, options);
}

}  // namespace gvd::app
