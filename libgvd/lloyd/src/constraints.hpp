#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "gvd/geodesic_tracing.hpp"
#include "gvd/lloyd.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/creases.hpp"

namespace gvd {

/// The tangent vector along the crease that is nearest to `tangent`, at a point of a crease. Zero at a corner.
Vec2 project_to_crease(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point, const Vec2& tangent);

/// Follows the crease from one of its points in the direction of `tangent`, which must lie along the crease, by the
/// length of `tangent` or to the next corner. The path ends on that crease. Cost: O(edges passed).
GeodesicTrace follow_crease(const Mesh& mesh, const CreaseNetwork& network, const SurfacePoint& point,
                            const Vec2& tangent);

/// Where generators may go.
class GeneratorConstraints {
 public:
  /// All generators are free.
  GeneratorConstraints() = default;
  /// `freedom`: one for each generator, or empty. The mesh must outlive this object.
  GeneratorConstraints(const Mesh& mesh, std::vector<Freedom> freedom, const std::vector<EdgeId>& creases)
      : freedom_(std::move(freedom)) {
    if (!freedom_.empty()) network_.emplace(mesh, creases);
  }

  bool is_free(std::size_t generator) const { return of(generator) == Freedom::free; }
  /// Throws Error{precondition} if there is not one freedom for each generator, or if a generator that has to stay on a
  /// crease lies on none.
  void check(const std::vector<SurfacePoint>& generators) const;
  /// The tangent vector nearest to `tangent` in which the generator may move from this point.
  Vec2 project(const Mesh& mesh, std::size_t generator, const SurfacePoint& point, const Vec2& tangent) const;
  /// The path of the generator from this point: a geodesic or a path along a crease.
  GeodesicTrace move(const Mesh& mesh, std::size_t generator, const SurfacePoint& point, const Vec2& step) const;

 private:
  Freedom of(std::size_t generator) const { return freedom_.empty() ? Freedom::free : freedom_[generator]; }

  std::vector<Freedom> freedom_;
  std::optional<CreaseNetwork> network_;  // only with freedoms
};

}  // namespace gvd
