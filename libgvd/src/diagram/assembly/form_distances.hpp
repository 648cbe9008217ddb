#pragma once

#include <algorithm>
#include <cmath>

#include "diagram/assembly/distance_form.hpp"
#include "diagram/assembly/face_distances.hpp"

namespace gvd {

/// The distances of distance forms: they give good guesses and confirm nothing.
class FormDistances final : public FaceDistances {
 public:
  /// `forms`: ascending by generator, each once. They must outlive this.
  explicit FormDistances(const std::vector<DistanceForm>& forms) : forms_(forms) {}

  bool can_confirm() const override { return false; }
  double at(GeneratorId g, const Bary& p) const override { return form(g).at(p); }

  /// The solution of a 2 x 2 system, whatever the start. Nothing where the bisectors are parallel.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary&) const override {
    const auto &fa = form(a).corner, &fb = form(b).corner, &fc = form(c).corner;
    Bary u{}, v{};
    for (std::size_t k = 0; k < 3; ++k) {
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
