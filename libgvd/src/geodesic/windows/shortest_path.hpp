#pragma once

#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "geodesic/distance_field.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// Stores where paths end, and how paths continue from vertices with many faces. All paths of a generator that come to
/// such a vertex continue in the same way, and searching the tip of a cone of n faces again for each path would take
/// O(n^2). Several threads may use it at once.
class PathMemo {
 public:
  /// `generators` are the vertices from which the field was propagated.
  explicit PathMemo(std::vector<VertexId> generators) : generators_(std::move(generators)) {}

  using Key = std::pair<VertexId, GeneratorId>;
  struct Step {
    FaceSource source;
    double distance;
    Vec2 at;  // the vertex in the layout of the source's face
  };

  VertexId end(GeneratorId g) const { return generators_[g.index()]; }
  std::optional<Step> find(const Key& key) const {
    const std::shared_lock lock(mutex_);
    const auto found = steps_.find(key);
    return found != steps_.end() ? std::optional(found->second) : std::nullopt;
  }
  void add(const Key& key, const Step& step) {
    const std::unique_lock lock(mutex_);
    steps_.emplace(key, step);
  }

 private:
  std::vector<VertexId> generators_;
  mutable std::shared_mutex mutex_;
  std::map<Key, Step> steps_;
};

/// Traces a shortest path over edges and pseudo-sources; its length includes the generator's offset. All windows must
/// have been kept. If `only` is valid, the path leads to that generator. Cost: O(faces crossed + windows at its bends).
GeodesicPath trace_shortest_path(const Mesh& mesh, const WindowField& field, PathMemo& memo, const SurfacePoint& start,
                                 GeneratorId only = {});

}  // namespace gvd
