#include "placement/surface_samples.hpp"

#include <algorithm>
#include <cmath>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

std::vector<SurfaceSample> sample_surface(const Mesh& mesh, double count) {
  const double total = compute_area(mesh);
  std::vector<SurfaceSample> samples;
  for (std::int32_t i = 0; i < mesh.face_count(); ++i) {
    const FaceId f(i);
    const auto& [a, b, c] = mesh.vertices(f);
    const Vec3 &p = mesh.position(a), u = mesh.position(b) - p, v = mesh.position(c) - p;
    if (!(mesh.area(f) > 0)) continue;
    const int k = std::max(1, static_cast<int>(std::lround(std::sqrt(mesh.area(f) / total * count))));
    const double area = mesh.area(f) / (k * k);
    const Vec3 normal = face_normal(mesh, f);
    for (int s = 0; s < k; ++s) {
      for (int t = 0; s + t < k; ++t) {
        const auto add = [&](double third) {
          samples.push_back({p + (s + third) / k * u + (t + third) / k * v, normal, f, area});
        };
        add(1.0 / 3);
        if (s + t + 1 < k) add(2.0 / 3);
      }
    }
  }
  return samples;
}

}  // namespace gvd
