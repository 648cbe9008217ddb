// The generators of a run, by its options: a list (--generators, --vertices), or samples (-n, --radius, --target-edge).
//
// Listed generators are where the user wants them: they are only moved to the surface. Sampling is seeded, so that the
// same options give the same points. A length of edges becomes a number of generators by the area that each one has in
// an even triangulation.

#include "common/choose_generators.hpp"

#include <fmt/format.h>

#include <array>
#include <limits>

#include "common/process.hpp"
#include "gvd/error.hpp"
#include "gvd/mesh.hpp"
#include "gvd/sampling.hpp"

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

ResolvedGenerators resolve(const CheckedMesh& input, const GeneratorOptions& asked, const Progress& progress) {
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  options.max_snap = asked.max_snap;
  options.merge_coincident = asked.merge_coincident;
  options.progress = progress;
  return resolve_generators(input.mesh, read_list(asked), options);
}

Sampling sampling_of(SamplingKind kind) {
  constexpr std::array kKinds{Sampling::farthest, Sampling::random, Sampling::vertices, Sampling::poisson};
  return kKinds[static_cast<std::size_t>(kind)];
}

/// The number of generators for a mean length of edges.
std::int32_t count_for(const Mesh& mesh, double edge) {
  const double count = even_count(compute_area(mesh), edge);
  if (count <= std::numeric_limits<std::int32_t>::max()) return static_cast<std::int32_t>(count);
  throw Error(ErrorCode::invalid_option,
              fmt::format("--target-edge {}: this takes {:.3g} generators; ask for longer edges", edge, count));
}

ResolvedGenerators sample(const Mesh& mesh, const Options& run, const Progress& progress) {
  const GeneratorOptions& asked = run.generators;
  SamplingOptions options;
  options.seed = asked.seed;
  options.front = make_diagram_options(run.compute).front;
  options.progress = progress;
  if (asked.count) options.count = *asked.count;
  if (asked.target_edge) options.count = count_for(mesh, *asked.target_edge);
  if (asked.radius) options.radius = *asked.radius;
  options.kind = asked.radius ? Sampling::covering_radius : sampling_of(asked.sampling);
  ResolvedGenerators sampled;
  sampled.points = sample_generators(mesh, options);
  sampled.snap_distance.resize(sampled.points.size());
  return sampled;
}

}  // namespace

ResolvedGenerators choose_generators(const CheckedMesh& input, const Options& options, const Progress& progress) {
  return options.generators.are_listed() ? resolve(input, options.generators, progress)
                                         : sample(input.mesh, options, progress);
}

}  // namespace gvd::app
