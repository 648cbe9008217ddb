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
  /// `generators` are those of the working mesh, as points of the input. Cost: O(generators).
  Departures(const WorkingMesh& working, const std::vector<SurfacePoint>& generators);

  /// The tangent direction of generator g, a unit vector, in which a path departs.
  Vec2 direction(GeneratorId g, Departure departure) const {
    const Plane& plane = planes_[g];
    return unit_vector(plane.start + plane.scale * (plane.scale == 1 ? departure.turned() : departure.angle()));
  }
  /// Whether tangent angles equal the angles on the surface. At vertices with curvature they are scaled.
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
  GeneratorId generator;  ///< invalid if none reaches the point
  double distance;        ///< without the distance at which the generator starts, mesh units
  /// The logarithm of the point: the tangent vector at the generator (see geodesic_tracing.hpp) that has the direction
  /// in which the path departs, and the length of the path.
  Vec2 log;
};

/// Finds the shortest paths to points of face after face. An object serves one thread; several threads may read the
/// same field.
class NearestPaths {
 public:
  /// `field` must have departures. All arguments must outlive this object.
  NearestPaths(const Mesh& mesh, const WindowField& field, const Departures& departures)
      : mesh_(mesh), field_(field), departures_(departures) {}

  /// Collects the images that reach face f of the working mesh. The other members are about this face.
  /// Cost: O(windows on the face).
  void enter(FaceId f);
  /// The position of a point of the face in its layout (FaceLayout).
  Vec2 position(const Bary& bary) const { return interpolate(bary, corner_[0], corner_[1], corner_[2]); }
  /// The shortest path to a point of the face, or the shortest one from the generator `only`, whose cell must have a
  /// part in the face.
  /// Cost: O(windows on the face).
  NearestPath at(const Vec2& p, GeneratorId only = GeneratorId());

  /// The path from an image if the straight way to the point goes through its opening; otherwise the shortest path from
  /// the image's generator.
  /// Cost: O(1), or O(windows on the face).
  NearestPath from(std::size_t image, const Vec2& p);

  /// Returned for a point that no generator reaches.
  static constexpr std::size_t kNoImage = static_cast<std::size_t>(-1);
  /// The image from which the shortest path to a point of the face comes; kNoImage if no generator reaches the point.
  /// Cost: O(windows on the face).
  std::size_t nearest_image(const Vec2& p) const {
    double distance = kInfinity;
    return search(p, GeneratorId(), distance);
  }
  /// The squared length of the path to a point that is straight from an image on, through its opening or not. The
  /// length includes the way to the image.
  double square_distance(std::size_t image, const Vec2& p) const {
    const double squared = (p - images_[image].at).squaredNorm(), offset = images_[image].offset;
    return offset == 0 ? squared : squared + 2 * offset * std::sqrt(squared) + offset * offset;
  }
  /// The number of images. They are numbered from 0.
  std::size_t image_count() const { return images_.size(); }
  /// Whether an image is that of a generator, not of a pseudo-source.
  bool is_direct(std::size_t image) const { return is_direct(images_[image]); }
  GeneratorId generator(std::size_t image) const { return images_[image].generator; }

 private:
  /// An image, with the rays to the ends of its opening. A corner of the face is an image without an opening.
  struct Image {
    Vec2 at, begin, end;  // `begin` and `end`: from the image to the ends
    double offset;
    GeneratorId generator;
    int side;            // side of the opening; for a corner, the side that leaves it
    std::size_t window;  // number of the window; kCorner for a corner
    bool has_direction;
    Vec2 direction;  // tangent direction of a ray along the side, or of all rays behind a pseudo-source
  };
  static constexpr std::size_t kCorner = static_cast<std::size_t>(-1);

  /// The image with the shortest straight path to p among those of `only`, or among all, if that is shorter than
  /// `distance`, which is lowered to its length. kNoImage if there is none. Lengths include the distance at which the
  /// generator starts.
  std::size_t search(const Vec2& p, GeneratorId only, double& distance) const;
  NearestPath find_round_ends(const Vec2& p, GeneratorId only) const;
  void add_window(std::size_t number);
  /// Whether a ray from the image goes through its opening.
  static bool passes(const Image& image, const Vec2& ray) {
    return image.window == kCorner || (cross(ray, image.begin) >= 0 && cross(ray, image.end) <= 0);
  }
  bool is_direct(const Image& image) const { return image.offset == field_.starts[image.generator]; }
  /// `distance` does not include the distance at which the generator starts.
  Vec2 log(Image& image, const Vec2& ray, double distance) const;
  Vec2 direction(const Image& image) const;
  Departure from_side(const Image& image, const Vec2& ray) const;

  const Mesh& mesh_;
  const WindowField& field_;
  const Departures& departures_;
  FaceId face_;
  std::array<Vec2, 3> corner_, side_;  // corners and sides of the face in its layout; the sides are unit vectors
  std::vector<Image> images_;
};

}  // namespace gvd
