#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "base/barycentric.hpp"
#include "base/plane.hpp"
#include "geodesic/windows/window.hpp"
#include "geodesic/windows/window_field.hpp"
#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "gvd/vec.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd {

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
