#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "gvd/ids.hpp"

namespace gvd {

/// The angle at which paths leave their generator, counter-clockwise from the generator's `mesh.halfedge`. Angles are
/// measured on the surface: round a vertex they go up to the total angle of its faces.
///
/// A straight path of a window leaves at this angle plus the angle of the path with the window's halfedge. Behind a
/// pseudo-source all paths leave at this angle, as the pseudo-source's own path does.
///
/// It is a fixed-point number of four bytes, so that a waiting window still fits into one cache line, and sums cost
/// nothing. The last two bits count the half turns of the side at which the sector of the paths begins; a full turn has
/// 2^30 units. Each face crossed adds the rounding of one angle: up to 3e-9 radians, 1e-7 over a thousand faces.
/// Distances are not affected. At a vertex with more than five half turns, angles can be wrong.
class Departure {
 public:
  Departure() = default;
  /// The angle of a side at a generator, >= 0, radians.
  static Departure of_side(double angle) {
    const double half_turns = std::floor(angle / std::numbers::pi);
    return Departure(units(angle) | static_cast<std::uint32_t>(half_turns < 3 ? half_turns : 3));
  }
  /// An angle to be added to another one, radians.
  static Departure of_angle(double angle) { return Departure(units(angle)); }

  friend Departure operator+(Departure a, Departure b) { return Departure(a.bits_ + (b.bits_ & ~kHalfTurns)); }
  friend Departure operator-(Departure a, Departure b) { return Departure(a.bits_ - (b.bits_ & ~kHalfTurns)); }
  bool operator==(const Departure&) const = default;

  /// The angle modulo a full turn, in [0, 2 pi), radians.
  double turned() const { return (bits_ >> kShift) * (2 * std::numbers::pi / kFullTurn); }
  /// The angle of a path, in [0, total angle of the generator's faces), radians, up to rounding.
  double angle() const {
    const double least = (bits_ & kHalfTurns) * std::numbers::pi - kSlack;
    return turned() + std::ceil((least - turned()) / (2 * std::numbers::pi)) * 2 * std::numbers::pi;
  }

 private:
  explicit Departure(std::uint32_t bits) : bits_(bits) {}
  static std::uint32_t units(double angle) {
    const double turns = angle * (kFullTurn / (2 * std::numbers::pi));
    // This rounds half away from zero without a library call.
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5))) << kShift;
  }

  static constexpr int kShift = 2;
  static constexpr std::uint32_t kHalfTurns = 3;
  static constexpr double kFullTurn = 1 << 30;
  /// Bound on the rounding error of a sum over ten thousand faces, radians.
  static constexpr double kSlack = 1e-4;

  std::uint32_t bits_ = 0;
};
static_assert(sizeof(Departure) == 4);

/// All shortest paths of one generator that reach one interval of an edge from one side through the same faces. In the
/// plane of the face that they leave, they are straight lines from one image: that of the generator, or of the last
/// pseudo-source at which they bend. Paths from a segment of a curve are parallel (parallel_windows.hpp).
///
/// The same type serves a window on its way, in a message to another partition, and on the edge where it is kept.
/// Tracers see windows as EdgeSource and FaceSource (distance_field.hpp), which fast marching provides as well. These
/// two types use one frame for both sides of an edge, and include the paths through vertices.
///
/// Source: Mitchell, Mount and Papadimitriou (1987); Chen and Han (1990).
/// Frame: the edge lies on the x axis and the paths come from below. The origin is the start of `halfedge`, x runs
/// towards its end. On the boundary, where the paths end, the origin is the end of `halfedge` and x runs to its start.
/// Mesh units.
struct Window {
  double begin, end;  ///< interval on the edge, 0 <= begin < end <= length
  double x, depth;  ///< the image lies at (x, -depth), depth > 0; if paths are parallel, their direction is (x, -depth)
  double offset;    ///< distance from the generator to the vertex whose image this is; if paths are parallel, the
                    ///< distance at t = 0
  GeneratorId generator;  ///< generator at which the paths start
  HalfedgeId halfedge;    ///< the next one that the paths cross; on the boundary, that of the face they leave

  /// Square of the distance from the image to the point t of the edge.
  double squared_image_distance(double t) const { return (t - x) * (t - x) + depth * depth; }
  double image_distance(double t) const { return std::sqrt(squared_image_distance(t)); }
  /// The least distance from the image to the interval.
  double least_image_distance() const { return image_distance(std::min(std::max(x, begin), end)); }
  /// Distance from the generator to the point t of the edge; the length of a path for t in [begin, end].
  double distance(double t) const { return offset + (is_parallel() ? x * t : image_distance(t)); }

  /// Whether the paths are parallel. If they are, only `distance` and `begins_here` may be called, because the
  /// functions above assume an image.
  bool is_parallel() const { return depth < 0; }
  /// Whether the paths begin on the edge, which then belongs to a curve. No other window has these values, because its
  /// edge would be at distance 0, and windows that come to such an edge are dropped.
  bool begins_here() const { return depth == -1 && x == 0 && offset == 0; }
};
static_assert(sizeof(Window) == 48);

/// The distance at which each generator starts, mesh units.
struct StartDistances {
  std::vector<double> of_generator = {};  ///< >= 0; empty: 0 for all

  double operator[](GeneratorId g) const { return of_generator.empty() ? 0 : of_generator[g.index()]; }
};

/// Tells the propagation which way a window's paths have come.
///
/// Bit fields make a waiting window fit into one cache line (waiting_windows.hpp). A mesh has fewer than 2^30 faces.
struct WindowHistory {
  std::uint32_t crossed_faces : 30;  ///< number of faces that the paths have crossed
  std::uint32_t joinable_ends : 2;   ///< kAtBegin, kAtEnd: ends where another window may continue without a gap
  FaceId cycle_check_face;           ///< one of the faces crossed (is_cycle_check_step in window_filters.hpp), or none
  Departure departure = {};          ///< where the paths leave their generator, if departures are recorded

  static constexpr std::uint32_t kAtBegin = 1, kAtEnd = 2;
};

/// A window on its way.
struct PropagatedWindow {
  Window window;
  WindowHistory history;
};
static_assert(sizeof(PropagatedWindow) == 64);

/// Images that differ by less than this fraction of their distance count as the same, and so do the rays from them
/// through one point. Two images of one point, over a thousand faces each, differ by up to 1.2e-13.
///
/// Rounding of an image: each face rotates it about a corner, with two products and a sum for each coordinate. The
/// squares of the cosine and the sine add up to 1 within 2e-15, and within 3e-16 on average, so that a face moves the
/// image by about 3e-16 of its distance. Over unlike faces, these errors grow with the square root of the number of
/// faces; over equal faces, they grow with the number itself. The offset and the distance to a point add a few units in
/// the last place. The table has the largest errors of images and distances, as fractions of the distance, on flat
/// plates of up to 500 x 500 rectangles with a diagonal. test_window_rounding.cpp compares them with the plane in long
/// double:
///
///     faces crossed        100       200       500      1000
///     equal faces        6e-15   1.3e-14     3e-14     6e-14
///     unlike faces       5e-15     8e-15   1.4e-14   2.7e-14
inline constexpr double kSameImage = 3e-13;

}  // namespace gvd
