#include "common/steps/make_generators.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/steps/standard_input.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"
#include "gvd/text.hpp"

namespace gvd::app {
namespace {

GeneratorList read_list(const GeneratorOptions& options) {
  if (options.file == "-") {
    const std::string content = read_standard_input();
    return parse_generators(content, options.format.value_or(detect_generator_format(content)), kStandardInput);
  }
  if (!options.vertices) return read_generators(options.file, options.format);
  GeneratorList list{"--vertices", {}};
  for (const std::int64_t vertex : *options.vertices) {
    list.entries.push_back({GeneratorEntry::Kind::vertex, vertex, {}, 0});
  }
  return list;
}

void note_changes(Run& run, const ResolvedGenerators& resolved) {
  double largest = -1;
  for (const auto& distance : resolved.snap_distance) largest = std::max(largest, distance.value_or(-1));
  if (largest >= 0) run.console().note(fmt::format("generators: moved to the surface, by at most {}", largest));
  if (resolved.merged > 0)
    run.console().note(fmt::format(
        "generators: {}", counted(resolved.merged, "is merged with an earlier one", "are merged with earlier ones")));
}

ResolvedGenerators resolve(Run& run, const CheckedMesh& input) {
  const GeneratorOptions& asked = run.options().generators;
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  options.max_snap = asked.max_snap;
  options.merge_coincident = asked.merge_coincident;
  options.progress = run.progress();
  ResolvedGenerators resolved = resolve_generators(input.mesh, read_list(asked), options);
  note_changes(run, resolved);
  return resolved;
}

Sampling sampling_of(SamplingKind kind) {
  switch (kind) {
    case SamplingKind::random:
      return Sampling::random;
    case SamplingKind::vertices:
      return Sampling::vertices;
    case SamplingKind::poisson:
      return Sampling::poisson;
    case SamplingKind::farthest:
      break;
  }
  return Sampling::farthest;
}

/// The number of generators for a mean length of edges.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option, fmt::format("--target-edge {}: this takes {:.3g} generators; ask for longer "
                                                     "edges",
                                                     edge, count));
}

ResolvedGenerators sample(Run& run, const Mesh& mesh, std::optional<std::int32_t> count) {
  const GeneratorOptions& asked = run.options().generators;
  SamplingOptions options;
  options.seed = asked.seed;
  options.front = make_diagram_options(run.options().compute).front;
  options.progress = run.progress();
  if (asked.count) options.count = *asked.count;
  if (asked.target_edge) options.count = count_for(mesh, *asked.target_edge);
  if (count) options.count = *count;
  if (asked.radius) options.radius = *asked.radius;
  options.kind = asked.radius ? Sampling::covering_radius : sampling_of(asked.sampling);
  ResolvedGenerators sampled;
  sampled.points = sample_generators(mesh, options);
  sampled.snap_distance.resize(sampled.points.size());
  return sampled;
}

}  // namespace

std::vector<SurfacePoint> make_generators(Run& run, const CheckedMesh& input, std::optional<std::int32_t> count) {
  const GeneratorOptions& asked = run.options().generators;
  const bool listed = asked.are_listed();
  ResolvedGenerators found =
      run.timed("generators", [&] { return listed ? resolve(run, input) : sample(run, input.mesh, count); });
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    run.report().generators().push_back(
        {found.points[i], position(input.mesh, found.points[i]), found.snap_distance[i]});
  }
  run.console().detail(counted(std::ssize(found.points), "generator", "generators"));
  return std::move(found.points);
}

}  // namespace gvd::app
