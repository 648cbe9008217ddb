#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "base/plane.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/generator_table.hpp"
#include "geodesic/nearest_source.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

/// Overwrites `sources` with all that reach the edge of halfedge h: its two ends, then the windows from both sides.
/// Positions run from `from(h)`. Cost: O(windows on the two faces).
void collect_edge_sources(const Mesh& mesh, const WindowField& field, HalfedgeId h, std::vector<EdgeSource>& sources);

/// Overwrites `sources` with all that reach the points of face f, in its layout: the windows that enter through its
/// sides, then its corners. Cost: O(windows on the face).
void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f, const FaceLayout& layout,
                          std::vector<FaceSource>& sources);
inline void collect_face_sources(const Mesh& mesh, const WindowField& field, FaceId f,
                                 std::vector<FaceSource>& sources) {
  collect_face_sources(mesh, field, f, FaceLayout(mesh, f), sources);
}

/// Exact distances on edges and in faces, from the windows that the propagation kept near bisectors.
class WindowDistances final : public DistanceField {
 public:
  /// Both have to outlive this.
  WindowDistances(const Mesh& mesh, const WindowField& field) : mesh_(mesh), field_(field) {}

  std::vector<EdgeId> contested_edges(const ParallelChunks& parallel) const override;
  void collect(EdgeId e, std::vector<EdgeSource>& sources) const override {
    collect_edge_sources(mesh_, field_, mesh_.halfedge(e), sources);
  }
  void collect(FaceId f, const FaceLayout& layout, std::vector<FaceSource>& sources) const override {
    collect_face_sources(mesh_, field_, f, layout, sources);
  }

 private:
  const Mesh& mesh_;
  const WindowField& field_;
};

/// The generator tables that correspond to exact distances: the input of the paper's growth. A generator has a line in
/// a face's table if one of its windows, or a corner with its label, reaches the face. Its distances at the corners are
/// computed from these.
/// Reports the step "tables". Cost: O(n + windows).
GeneratorTable make_generator_table(const Mesh& mesh, const WindowField& field, const Progress& progress = {});

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

/// Turns departures, which count angles on the working mesh, into tangent vectors of the input mesh at the generators
/// (see geodesic_tracing.hpp).
class Departures {
 public:
  /// `generators`: of the working mesh, in the input. Cost: O(generators).
  Departures(const WorkingMesh& working, const std::vector<SurfacePoint>& generators);

  /// The tangent direction of generator g, a unit vector, in which a path departs.
  Vec2 direction(GeneratorId g, Departure departure) const {
    const Plane& plane = planes_[g];
    return unit_vector(plane.start + plane.scale * (plane.scale == 1 ? departure.turned() : departure.angle()));
  }
  /// Whether tangent angles are angles on the surface. They are scaled at vertices with curvature.
  bool is_flat(GeneratorId g) const { return planes_[g].scale == 1; }

 private:
  struct Plane {
    double start;  // tangent angle of the first side at the generator, radians
    double scale;  // ratio of tangent angles to angles on the surface
  };
  IdVector<GeneratorId, Plane> planes_;
};

/// A shortest path from the nearest generator to a point.
struct NearestPath {
  GeneratorId generator;  ///< invalid where none reaches
  double distance;        ///< without the distance at which the generator starts, mesh units
  /// The logarithm of the point: the tangent vector at the generator (see geodesic_tracing.hpp) in whose direction the
  /// path departs, with its length.
  Vec2 log;
};

/// The shortest paths to points of one face after the other. For one thread; several may read the same field.
class NearestPaths {
 public:
  /// `field`: with departures. All have to outlive this.
  NearestPaths(const Mesh& mesh, const WindowField& field, const Departures& departures)
      : mesh_(mesh), field_(field), departures_(departures) {}

  /// Collects the images that reach face f of the working mesh. The other members are about this face.
  /// Cost: O(windows on the face).
  void enter(FaceId f);
  /// The position of a point of the face in its layout (FaceLayout).
  Vec2 position(const Bary& bary) const { return interpolate(bary, corner_[0], corner_[1], corner_[2]); }
  /// The shortest path to a point of the face, or that from the generator `only`, whose cell has a part in the face.
  /// Cost: O(windows on the face).
  NearestPath at(const Vec2& p, GeneratorId only = GeneratorId());

  /// The path from an image, if the straight way to the point goes through its opening; else that from its generator.
  /// Cost: O(1), or O(windows on the face).
  NearestPath from(std::size_t image, const Vec2& p);

  /// The image of a point that no generator reaches.
  static constexpr std::size_t kNoImage = static_cast<std::size_t>(-1);
  /// The image that the shortest path to a point of the face comes from; kNoImage if no generator reaches it.
  /// Cost: O(windows on the face).
  std::size_t nearest_image(const Vec2& p) const {
    double distance = kInfinity;
    return search(p, GeneratorId(), distance);
  }
  /// The square length of the straight way from an image to a point of its plane, through its opening or not, with the
  /// way to the image.
  double square_distance(std::size_t image, const Vec2& p) const {
    const double squared = (p - images_[image].at).squaredNorm(), offset = images_[image].offset;
    return offset == 0 ? squared : squared + 2 * offset * std::sqrt(squared) + offset * offset;
  }
  /// Images have the numbers below this.
  std::size_t image_count() const { return images_.size(); }
  /// Whether an image is one of a generator, not of a pseudo-source.
  bool is_direct(std::size_t image) const { return is_direct(images_[image]); }
  GeneratorId generator(std::size_t image) const { return images_[image].generator; }

 private:
  /// An image, with the rays to the ends of its opening; a corner of the face is one without an opening.
  struct Image {
    Vec2 at, begin, end;  // `begin` and `end`: from the image to the ends
    double offset;
    GeneratorId generator;
    int side;            // of the opening; of a corner the one that leaves it
    std::size_t window;  // its number; kCorner for a corner
    bool has_direction;
    Vec2 direction;  // tangent direction of a ray along the side, or of all rays behind a pseudo-source
  };
  static constexpr std::size_t kCorner = static_cast<std::size_t>(-1);

  /// The image with the shortest way to p among those of `only`, or of all. Lowers `distance` to that, with the one at
  /// which its generator starts, or leaves it.
  std::size_t search(const Vec2& p, GeneratorId only, double& distance) const;
  NearestPath find_round_ends(const Vec2& p, GeneratorId only) const;
  void add_window(std::size_t number);
  /// Whether a ray from the image goes through its opening.
  static bool passes(const Image& image, const Vec2& ray) {
    return image.window == kCorner || (cross(ray, image.begin) >= 0 && cross(ray, image.end) <= 0);
  }
  bool is_direct(const Image& image) const { return image.offset == field_.starts[image.generator]; }
  /// `distance`: without the one at which the generator starts.
  Vec2 log(Image& image, const Vec2& ray, double distance) const;
  Vec2 direction(const Image& image) const;
  Departure from_side(const Image& image, const Vec2& ray) const;

  const Mesh& mesh_;
  const WindowField& field_;
  const Departures& departures_;
  FaceId face_;
  std::array<Vec2, 3> corner_, side_;  // of the face in its layout; the sides are unit vectors
  std::vector<Image> images_;
};

}  // namespace gvd
