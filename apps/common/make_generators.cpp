#include <fmt/format.h>

#include <algorithm>

#include "common/pipeline.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"

namespace gvd::app {
namespace {

GeneratorList read_list(const GeneratorOptions& options) {
  if (!options.vertices) return read_generators(options.file);
  GeneratorList list{"--vertices", {}};
  for (const std::int64_t vertex : *options.vertices) {
    list.entries.push_back({GeneratorEntry::Kind::vertex, vertex, {}, 0});
  }
  return list;
}

void tell(Run& run, const ResolvedGenerators& resolved) {
  double largest = -1;
  for (const auto& distance : resolved.snap_distance) largest = std::max(largest, distance.value_or(-1));
  if (largest >= 0) run.console().note(fmt::format("generators: moved to the surface by at most {}", largest));
  if (resolved.merged > 0) run.console().note(fmt::format("generators: {} merged with earlier ones", resolved.merged));
}

ResolvedGenerators resolve(Run& run, const CheckedMesh& input) {
  const GeneratorOptions& asked = run.options().generators;
  ResolveOptions options;
  options.input_vertices = &input.mesh_vertex;
  options.max_snap = asked.max_snap;
  options.merge_coincident = asked.merge_coincident;
  options.progress = run.progress();
  ResolvedGenerators resolved = resolve_generators(input.mesh, read_list(asked), options);
  tell(run, resolved);
  return resolved;
}

}  // namespace

std::vector<SurfacePoint> make_generators(Run& run, const CheckedMesh& input) {
  const GeneratorOptions& asked = run.options().generators;
  if (!asked.vertices && asked.file.empty()) {
    throw Error(ErrorCode::invalid_option, "-n and --radius are not in this version; use --vertices or --generators");
  }
  ResolvedGenerators found = run.timed("generators", [&] { return resolve(run, input); });
  for (std::size_t i = 0; i < found.points.size(); ++i) {
    run.report().generators.push_back({found.points[i], position(input.mesh, found.points[i]), found.snap_distance[i]});
  }
  run.console().detail(fmt::format("{} generators", found.points.size()));
  return std::move(found.points);
}

}  // namespace gvd::app
