#include "diffusion/diffusion.hpp"

#include <cmath>
#include <utility>

#include "cpu_clock.hpp"
#include "diffusion/heat_envelope.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"
#include "pieces/collect_pieces.hpp"
#include "pieces/working_pieces.hpp"

namespace gvd::paper {
namespace {

/// 4^12 triangles in one face are more than any time step needs.
constexpr int kMostSplits = 12;

void check(const DiffusionOptions& options) {
  if (!(options.time_factor > 0) || !std::isfinite(options.time_factor)) {
    throw Error(ErrorCode::invalid_option, "the time factor of diffusion must be positive and finite");
  }
  if (options.most_splits < 0 || options.most_splits > kMostSplits) {
    throw Error(ErrorCode::invalid_option, "the number of splits must be between 0 and 12");
  }
}

}  // namespace

Comparison compute_diffusion(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const DiffusionOptions& options) {
  check(options);
  const WorkingMesh working(mesh, generators);
  const Mesh& copy = working.mesh();
  Comparison result;
  const double start = bench::cpu_milliseconds();
  const double time = options.time_factor * mesh.mean_edge_length() * mesh.mean_edge_length();
  const HeatField field = compute_heat(copy, working.generator_vertices().raw(), time);
  const double diffused = bench::cpu_milliseconds();
  HeatEnvelope envelope(copy, field, options.most_splits);
  Pieces pieces;
  for (std::int32_t f = 0; f < copy.face_count(); ++f) {
    result.faults.forced_faces += envelope.cut(FaceId(f), pieces) ? 1 : 0;
  }
  result.field_ms = diffused - start;
  result.diagram_ms = bench::cpu_milliseconds() - diffused;
  for (std::int32_t v = 0; v < copy.vertex_count(); ++v) {
    result.faults.unreached_vertices += envelope.warmest(VertexId(v)).valid() ? 0 : 1;
  }
  collect_pieces(mesh, generators, take_to_input(working, std::move(pieces)), result);
  return result;
}

}  // namespace gvd::paper
