#include "windows/separate_windows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geodesic/windows/propagation/propagate_windows.hpp"
#include "geodesic/windows/window_queries.hpp"
#include "gvd/error.hpp"

namespace gvd::paper {
namespace {

/// Vertices are nearer to another generator only if its distance is less by this fraction; rounding decides nothing.
constexpr double kEqual = 2e-14;

/// Lengths are enlarged by this fraction: on symmetric meshes a generator wins in a single point of an edge.
constexpr double kSlack = 1e-9;

void check_memory(std::size_t generators, std::size_t windows) {
  const double bytes = static_cast<double>(generators) * static_cast<double>(windows * (sizeof(Window) + 4));
  if (bytes <= SeparateWindows::kMostMemory) return;
  throw Error(ErrorCode::precondition,
              fmt::format("the windows of {} generators, one by one, need {:.1f} GB; take fewer generators", generators,
                          1e-9 * bytes));
}

}  // namespace

SeparateWindows::SeparateWindows(const Mesh& mesh, const std::vector<VertexId>& generators) : mesh_(mesh) {
  PropagationOptions options;
  options.keep = KeepWindows::all;
  options.threads = 1;
  for (const VertexId v : generators) {
    fields_.push_back(propagate_windows(mesh, {v}, options, {}));
    check_memory(generators.size(), fields_.back().windows.size());
  }
  take_nearest();
}

void SeparateWindows::take_nearest() {
  const auto n = static_cast<std::size_t>(mesh_.vertex_count());
  distance_.assign(n, std::numeric_limits<double>::infinity());
  label_.assign(n, GeneratorId());
  for (std::size_t g = 0; g < fields_.size(); ++g) {
    for (std::int32_t i = 0; i < mesh_.vertex_count(); ++i) {
      const VertexId v(i);
      if (!(fields_[g].distance[v] < distance_[v] * (1 - kEqual))) continue;
      distance_[v] = fields_[g].distance[v];
      label_[v] = GeneratorId(g);
    }
  }
}

/// Whether the generator can be the nearest one in a point within `longest` of v: two distances change by that much
/// each.
bool SeparateWindows::can_win(const WindowField& field, VertexId v, double longest) const {
  return field.distance[v] <= distance_[v] * (1 + kSlack) + 2 * longest * (1 + kSlack);
}

bool SeparateWindows::can_win(const WindowField& field, EdgeId e) const {
  const HalfedgeId h = mesh_.halfedge(e);
  const double length = mesh_.length(h);
  return can_win(field, mesh_.from(h), length) && can_win(field, mesh_.to(h), length);
}

bool SeparateWindows::can_win(const WindowField& field, FaceId f) const {
  const auto& length = mesh_.shape(f).length;
  const double longest = *std::max_element(length.begin(), length.end());
  const auto& corners = mesh_.vertices(f);
  return std::all_of(corners.begin(), corners.end(), [&](VertexId v) { return can_win(field, v, longest); });
}

std::vector<EdgeId> SeparateWindows::contested_edges(const ParallelChunks& parallel) const {
  return find_edges(mesh_, parallel, [&](EdgeId e) {
    return std::count_if(fields_.begin(), fields_.end(), [&](const WindowField& f) { return can_win(f, e); }) > 1;
  });
}

void SeparateWindows::collect(EdgeId e, std::vector<EdgeSource>& sources) const {
  sources.clear();
  std::vector<EdgeSource> own;
  for (std::size_t g = 0; g < fields_.size(); ++g) {
    if (!can_win(fields_[g], e)) continue;
    collect_edge_sources(mesh_, fields_[g], mesh_.halfedge(e), own);
    for (EdgeSource& source : own) source.generator = GeneratorId(g);
    sources.insert(sources.end(), own.begin(), own.end());
  }
}

void SeparateWindows::collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const {
  sources.clear();
  std::vector<FaceSource> own;
  for (std::size_t g = 0; g < fields_.size(); ++g) {
    if (!can_win(fields_[g], f)) continue;
    collect_face_sources(mesh_, fields_[g], f, layout, own);
    for (FaceSource& source : own) source.generator = GeneratorId(g);
    sources.insert(sources.end(), own.begin(), own.end());
  }
}

}  // namespace gvd::paper
