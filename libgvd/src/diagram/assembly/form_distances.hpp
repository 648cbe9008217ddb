#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/barycentric.hpp"
#include "diagram/assembly/face_distances.hpp"
#include "gvd/front.hpp"
#include "gvd/ids.hpp"

namespace gvd {

/// A generator's distance over a triangle, in a form whose difference between two generators is linear in barycentric
/// coordinates. With such forms, bisectors are straight, and a branch point solves a 2 x 2 system.
///
/// With planar fronts the form is the distance, interpolated linearly from the corners. With circle fronts it is
/// derived from the squared distance: for a point source in the triangle's plane, d(p)^2 = sum b_i d_i^2 - sum b_i b_j
/// l_ij^2, whose last sum is the same for every generator and is left out.
/// Source: not in the paper, whose rough bisectors join the midpoints of edges (section 4.2).
struct DistanceForm {
  GeneratorId generator;
  std::array<double, 3> corner;  ///< the form's values at the triangle's corners, by form_value

  double at(const Bary& bary) const { return interpolate(bary, corner[0], corner[1], corner[2]); }
};

/// The form's value for a distance in mesh units. The sign of a negative value is kept.
inline double form_value(Front front, double distance) {
  return front == Front::circle ? distance * std::abs(distance) : distance;
}

/// Distances given by distance forms. They give good guesses, but have no paths.
class FormDistances final : public FaceDistances {
 public:
  /// `forms` are ascending by generator, each once, and must outlive this object.
  explicit FormDistances(const std::vector<DistanceForm>& forms) : forms_(forms) {}

  const DistanceForm& form(GeneratorId g) const {
    return *std::ranges::lower_bound(forms_, g, {}, &DistanceForm::generator);
  }

  double at(GeneratorId g, const Bary& p) const override { return form(g).at(p); }

  /// The solution of a 2 x 2 system; it does not depend on the start. Nothing if the bisectors are parallel.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary&) const override {
    const auto &fa = form(a).corner, &fb = form(b).corner, &fc = form(c).corner;
    Bary u{}, v{};
    for (int k = 0; k < 3; ++k) {
      u[k] = fa[k] - fb[k];
      v[k] = fa[k] - fc[k];
    }
    // In barycentric coordinates the point is orthogonal to u and v: it is their cross product, scaled to sum 1.
    const Bary w{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double sum = w[0] + w[1] + w[2];
    const Bary p{w[0] / sum, w[1] / sum, w[2] / sum};
    if (!std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2])) return std::nullopt;
    return p;
  }

 private:
  const std::vector<DistanceForm>& forms_;
};

}  // namespace gvd
