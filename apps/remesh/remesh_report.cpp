#include "remesh/remesh_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

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

Json to_json(const RemeshCertificate& c) {
  return {{"manifold", c.manifold},
          {"closed_as_input", c.closed_as_input},
          {"same_euler_characteristic", c.same_euler_characteristic},
          {"same_components", c.same_components},
          {"same_boundary_loops", c.same_boundary_loops},
          {"same_in_each_component", c.same_in_each_component},
          {"flipped_faces", c.flipped_faces},
          {"unused_generators", c.unused_generators}};
}

void note_result(Console& console, const RemeshResult& result) {
  console.note(fmt::format("{} vertices, {} faces: manifold, with the input's topology", result.mesh.vertex_count(),
                           result.mesh.face_count()));
  if (result.added > 0) {
    console.note(fmt::format("{} generators were added: the dual of the given {} is no proper mesh", result.added,
                             result.generators.size() - static_cast<std::size_t>(result.added)));
  }
}

}  // namespace

void report_remesh_options(Run& run, std::int64_t max_added, bool no_refine) {
  run.report().options()["max_added"] = max_added;
  run.report().options()["no_refine"] = no_refine;
}

void report_remesh(Run& run, const Mesh& mesh, const RemeshResult& result) {
  Json& results = run.report().results();
  results["added_generators"] = result.added;
  results["rounds"] = result.rounds;
  results["output"] = to_json(result.certificate.output);
  results["certificate"] = to_json(result.certificate);
  results["quality"] = {{"input", to_json(result.input_quality)}, {"output", to_json(result.output_quality)}};
  run.report().set_diagram(result.diagram);
  // The given ones are in the report already.
  std::vector<ReportedGenerator>& generators = run.report().generators();
  for (std::size_t i = generators.size(); i < result.generators.size(); ++i) {
    const SurfacePoint& p = result.generators[i];
    generators.push_back({p, position(mesh, p), std::nullopt});
  }
  note_result(run.console(), result);
}

}  // namespace gvd::app
