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

/// Where paths end, and where they go on from vertices with many faces: the same for all paths of a generator that come
/// to one. Searching the tip of a cone of n faces again for each path would take O(n^2). Several threads may use it.
class PathMemo {
 public:
  /// `generators`: the vertices that the field was propagated from.
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
/// have been kept. `only`: the generator that it leads to, if valid. Cost: O(faces crossed + windows at its ends).
GeodesicPath trace_shortest_path(const Mesh& mesh, const WindowField& field, PathMemo& memo, const SurfacePoint& start,
                                 GeneratorId only = {});

}  // namespace gvd
