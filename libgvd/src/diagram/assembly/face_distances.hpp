#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "diagram/assembly/distance_form.hpp"
#include "diagram/graph/crossings.hpp"

namespace gvd {

/// A branch point may come out this far beyond a side, in barycentric coordinates, because crossings that it comes near
/// are kept apart from it or were rounded, and be meant to lie on it; a sure metric puts it kInsideFace inside.
inline constexpr double kBeyondFace = 1e-9, kInsideFace = 2e-12;

/// What the assembly of a face asks of the distances inside it.
class FaceDistances {
 public:
  using Bary = std::array<double, 3>;
  virtual ~FaceDistances() = default;

  /// Whether entry() and is_branch_point() can say anything.
  virtual bool can_confirm() const = 0;
  /// A number that tells how far generator g is from p; smaller is nearer, between generators at one point.
  virtual double at(GeneratorId g, const Bary& p) const = 0;
  /// A point that is equally far from the three, looked for from `start` on; it may lie outside of the face.
  virtual std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const = 0;
  /// Where the three may be equally far: a sure metric names every such point of the face, and others.
  virtual std::vector<Bary> equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const = 0;
  /// Where the shortest path from g to p comes into the face: at corner + t on the halfedge of that corner; nothing
  /// where the metric does not know. A path of g stays in g's cell, so the boundary there and p belong to one piece.
  virtual std::optional<double> entry(GeneratorId g, const Bary& p) const = 0;
  /// How far rounding may have moved a crossing along its edge, as a part of the edge: far where the two generators
  /// nearly coincide.
  virtual double crossing_error(const BoundaryCrossing& crossing) const = 0;
  /// Whether p is known to be a branch point of the diagram, with the three cells counter-clockwise round it: then it
  /// is taken as it is.
  virtual bool is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& p) const = 0;
};

/// Distance forms: good guesses, and never sure.
class FormDistances final : public FaceDistances {
 public:
  /// `forms`: ascending by generator, each once.
  explicit FormDistances(const std::vector<DistanceForm>& forms) : forms_(forms) {}

  bool can_confirm() const override { return false; }
  double at(GeneratorId g, const Bary& p) const override { return form(g).at(p); }

  /// The forms are linear, so this is a 2 x 2 system.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary&) const override {
    const auto &fa = form(a).corner, &fb = form(b).corner, &fc = form(c).corner;
    Bary u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
      u[k] = fa[k] - fb[k];
      v[k] = fa[k] - fc[k];
    }
    // The point is orthogonal to u and v in barycentric coordinates: their cross product, scaled to sum 1.
    const Bary w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double sum = w[0] + w[1] + w[2];
    const Bary p{w[0] / sum, w[1] / sum, w[2] / sum};
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return std::nullopt;
    return p;
  }

  std::vector<Bary> equidistant_points(GeneratorId, GeneratorId, GeneratorId) const override { return {}; }
  std::optional<double> entry(GeneratorId, const Bary&) const override { return std::nullopt; }
  double crossing_error(const BoundaryCrossing&) const override { return 0; }
  bool is_branch_point(GeneratorId, GeneratorId, GeneratorId, const Bary&) const override { return false; }

 private:
  const DistanceForm& form(GeneratorId g) const {
    return *std::lower_bound(forms_.begin(), forms_.end(), g,
                             [](const DistanceForm& f, GeneratorId wanted) { return f.generator < wanted; });
  }

  const std::vector<DistanceForm>& forms_;
};

}  // namespace gvd
