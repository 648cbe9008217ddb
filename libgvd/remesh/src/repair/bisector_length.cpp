#include "repair/bisector_length.hpp"

namespace gvd {
namespace {

double segment_length(const Mesh& mesh, const Bisector& b, std::size_t i) {
  return (position(mesh, b.points[i]) - position(mesh, b.points[i - 1])).norm();
}

}  // namespace

double compute_length(const Mesh& mesh, const Bisector& bisector) {
  double sum = 0;
  for (std::size_t i = 1; i < bisector.points.size(); ++i) sum += segment_length(mesh, bisector, i);
  return sum;
}

SurfacePoint find_midpoint(const Mesh& mesh, const Bisector& bisector) {
  const double half = 0.5 * compute_length(mesh, bisector);
  double sum = 0;
  for (std::size_t i = 1; i < bisector.points.size(); ++i) {
    const double step = segment_length(mesh, bisector, i);
    if (sum + step >= half) return bisector.points[half - sum < 0.5 * step ? i - 1 : i];
    sum += step;
  }
  return bisector.points.back();
}

}  // namespace gvd
