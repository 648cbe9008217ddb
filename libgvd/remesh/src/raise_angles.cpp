// Moves the vertices of a fit's thin triangles to where the angles are larger and the distances hardly worse.
//
// A fit that moves vertices to creases makes a triangle thin if its three corners end up near one line. The guard would
// halve the steps of all three, and lose the crease. Here one vertex at a time moves, and the move has a cost: the
// distances are the quadratic forms of the fit, with the other vertices fixed, and thin triangles have a price. So
// vertices first slide along creases and flat parts, which costs no distance, and leave a crease where nothing else
// helps.
//
// The springs of a fit know neither how far a vertex may go for free nor where its triangles are best. So in the last
// rounds, all triangles have a price, by their lack of Q.
//
// Source: optimisation-based smoothing (L. Freitag and C. Ollivier-Gooch, Tetrahedral mesh improvement using swapping
// and smoothing, 1997), with a search in place of the linear programs, and the distance beside the angle.
// docs/notes/remesh-placement.md has the measurements behind the constants.
#include "raise_angles.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "cell_quadrics.hpp"
#include "dual/flipped_triangles.hpp"
#include "dual/placed_faces.hpp"
#include "fit_vertices.hpp"
#include "gvd/quality.hpp"

namespace gvd {
namespace {

/// Directions in which a vertex tries to move.
constexpr int kDirections = 8;

/// The length of the first steps, relative to the mean edge of the vertex. Each next step is half as long.
constexpr double kFirstStep = 0.2;

/// A gain below this fraction of the cost does not count: it is a million times the rounding.
constexpr double kLeastGain = 1e-9;

/// The price of an angle that the guard forbids, in units of what an angle lacks to the bound of thin triangles: .1 for
/// any such angle, plus what it lacks itself. Without this price the guard would halve the steps of all three corners,
/// and a third more angles would be below 30 degrees.
constexpr double kForbidden = 0.1;

/// The largest square distance that a vertex accepts for all its thin triangles, in units of a cell: that of a cell
/// moved by a tenth of the root of its area. If generators are uneven, there may be no place with good triangles, and
/// without the bound vertices would move far in vain (docs/notes/remesh-placement.md).
constexpr double kMostPaid = 0.01;

/// A triangle with a Q above this times most_q is not thin: the slack is a million times the rounding.
constexpr double kQSlack = 1 + 1e-9;

/// The largest Q of a triangle with this smallest angle, in degrees: that of the isosceles triangle with this angle at
/// its apex. If the longer side at the angle has length 1, the ratio of area and perimeter grows with the other side.
double most_q(double angle) {
  const double apex = angle * std::numbers::pi / 180;
  return std::sqrt(3.0) * std::sin(apex) / (1 + std::sin(apex / 2));
}

class AngleRaiser {
 public:
  AngleRaiser(const AngleSearch& search, const AnglePrice& price, std::vector<Vec3> positions)
      : search_(search),
        price_(price),
        positions_(std::move(positions)),
        fitted_(positions_),
        placed_(*search.mesh, positions_),
        faces_of_(positions_.size()),
        may_improve_(positions_.size(), 1) {
    for (const FaceId f : search.mesh->faces()) {
      for (const VertexId v : search.mesh->vertices(f)) faces_of_[v.index()].push_back(f);
    }
  }

  std::vector<Vec3> run() && {
    for (int pass = 0; pass < kAnglePasses; ++pass) {
      if (!move_all()) break;
    }
    return std::move(positions_);
  }

 private:
  /// The square distances around a vertex as a function of its move: x' matrix x - 2 right' x, and a constant.
  struct Form {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();

    double at(const Vec3& move) const { return move.dot(matrix * move) - 2 * right.dot(move); }

    /// How far to go along a direction for the least value; 0 if the direction does not matter.
    double rise(const Vec3& move, const Vec3& direction) const {
      const double stiffness = direction.dot(matrix * direction);
      return stiffness > 0 ? direction.dot(right - matrix * move) / stiffness : 0;
    }
  };

  /// Passes over the vertices once. False if none has moved.
  bool move_all() {
    bool has_moved = false;
    for (std::size_t v = 0; v < positions_.size(); ++v) {
      report_progress(search_.progress, "placement", double(v) / double(positions_.size()));
      if (search_.plan->roles[v] == VertexRole::held || !may_improve_[v]) continue;
      may_improve_[v] = price_of_faces(v) > 0 && improve(v);
      if (!may_improve_[v]) continue;
      has_moved = true;
      for (const FaceId f : faces_of_[v]) {
        for (const VertexId other : search_.mesh->vertices(f)) may_improve_[other.index()] = 1;
      }
    }
    return has_moved;
  }

  /// How far a triangle's angle is below the angle of thin triangles, and how far below its own bound.
  double price_of_angle(FaceId f, const Triangle& triangle, double q) const {
    const bool flips = is_flipped(triangle, search_.guard->normals()[f]);
    const double bound = search_.guard->least_angles()[f];
    if (!flips && q > most_q_ && bound <= price_.angle) return 0;
    const double least = compute_min_angle(triangle[0], triangle[1], triangle[2]), is = flips ? -least : least;
    const double lack = (price_.angle - is) / price_.angle, forbidden = (bound - is) / price_.angle;
    return (lack > 0 ? lack * lack : 0) + (forbidden > 0 ? kForbidden + forbidden : 0);
  }

  double price_of_faces(std::size_t v) const {
    double angles = 0, shapes = 0;
    for (const FaceId f : faces_of_[v]) {
      const Triangle triangle = placed_.corners(f);
      const double q = compute_q(triangle[0], triangle[1], triangle[2]);
      angles += price_of_angle(f, triangle, q);
      shapes += 1 - q;
    }
    const double share = search_.plan->roles[v] == VertexRole::free ? 1 : kShapeAtCrease;
    return price_.weight * angles + share * price_.shape * shapes;
  }

  Form find_form(std::size_t v) const {
    Form form;
    for (const FaceId f : faces_of_[v]) {
      const FaceSystem& system = (*search_.systems)[f];
      const auto& corners = search_.mesh->vertices(f);
      const int k = corners[0].index() == v ? 0 : corners[1].index() == v ? 1 : 2;
      form.matrix += system.matrix.block<3, 3>(3 * k, 3 * k);
      form.right += system.right.segment<3>(3 * k);
      for (const int other : {(k + 1) % 3, (k + 2) % 3}) {
        form.right -= system.matrix.block<3, 3>(3 * k, 3 * other) * move(corners[other].index());
      }
    }
    return form;
  }

  Vec3 move(std::size_t v) const { return positions_[v] - search_.mesh->positions()[v]; }

  double cost(std::size_t v, const Form& form) const {
    const double area = search_.plan->areas[v];
    return form.at(move(v)) + area * area * price_of_faces(v);
  }

  /// Two directions along the surface at a vertex and one across it, with the length of the mean edge of its faces. On
  /// a crease, only the direction along it.
  std::array<Vec3, 3> axes(std::size_t v) const {
    Vec3 normal(0, 0, 0);
    double length = 0;
    for (const FaceId f : faces_of_[v]) {
      const auto [a, b, c] = placed_.corners(f);
      normal += (b - a).cross(c - a);
      length += ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    length /= double(faces_of_[v].size());
    const CreaseCell& crease = search_.plan->creases[GeneratorId(v)];
    if (crease.is_met) return {length * crease.direction, Vec3::Zero(), Vec3::Zero()};
    const Vec3 first = normal.unitOrthogonal();
    return {length * first, length * normal.normalized().cross(first), length * normal.normalized()};
  }

  /// Tries places around the vertex, with steps that get shorter, and keeps the best. False if the vertex stays.
  bool improve(std::size_t v) {
    const auto [x, y, z] = axes(v);
    const Form form = find_form(v);
    Vec3 best = positions_[v];
    double least = cost(v, form);
    const double area = search_.plan->areas[v];
    const double most = form.at(fitted_[v] - search_.mesh->positions()[v]) + kMostPaid * area * area;
    const double gain = kLeastGain * std::abs(least);
    bool has_moved = false;
    double step = kFirstStep;
    for (int trial = 0; trial < kAngleTrials; trial += kDirections, step /= 2) {
      const Vec3 from = best;
      for (int k = 0; k < kDirections; ++k) {
        const double turn = 2 * std::numbers::pi * k / kDirections;
        positions_[v] = from + step * (std::cos(turn) * x + std::sin(turn) * y);
        positions_[v] += std::clamp(form.rise(move(v), z), -step, step) * z;
        if (form.at(move(v)) > most) continue;
        const double now = cost(v, form);
        if (!(now < least - gain)) continue;
        best = positions_[v];
        least = now;
        has_moved = true;
      }
    }
    positions_[v] = best;
    return has_moved;
  }

  const AngleSearch& search_;
  const AnglePrice& price_;
  std::vector<Vec3> positions_;
  const std::vector<Vec3> fitted_;  // the positions before the search
  PlacedFaces placed_;
  std::vector<std::vector<FaceId>> faces_of_;
  std::vector<char> may_improve_;  // false for vertices whose search would find nothing new
  const double most_q_ = kQSlack * most_q(price_.angle);
};

}  // namespace

std::vector<Vec3> raise_angles(const AngleSearch& search, const AnglePrice& price, std::vector<Vec3> positions) {
  return AngleRaiser(search, price, std::move(positions)).run();
}

}  // namespace gvd
