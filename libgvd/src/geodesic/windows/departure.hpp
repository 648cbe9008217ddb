#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

namespace gvd {

/// The angle at which paths leave their generator, counter-clockwise from the generator's `mesh.halfedge`, on the
/// surface: round a vertex they go up to the total angle of its faces.
///
/// A straight path of a window leaves at this angle plus the angle of the path with the window's halfedge. Behind a
/// pseudo-source all paths leave at this angle, as the pseudo-source's own path does.
///
/// Fixed point, in four bytes: a waiting window then still fills one line of the cache, and sums cost nothing. The last
/// two bits count the half turns of the side at which the sector of the paths begins; a full turn has 2^30 units. Each
/// face crossed adds the rounding of one angle: up to 3e-9 radians, 1e-7 over a thousand faces. Distances are not
/// affected. More than five half turns round a vertex are told wrongly.
class Departure {
 public:
  Departure() = default;
  /// An angle >= 0 of a side of a generator, radians.
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
    // Rounded half away from zero, without a call of the library.
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(turns + (turns < 0 ? -0.5 : 0.5))) << kShift;
  }

  static constexpr int kShift = 2;
  static constexpr std::uint32_t kHalfTurns = 3;
  static constexpr double kFullTurn = 1 << 30;
  /// Rounding of the sum over ten thousand faces, radians.
  static constexpr double kSlack = 1e-4;

  std::uint32_t bits_ = 0;
};
static_assert(sizeof(Departure) == 4);

}  // namespace gvd
