// Finds curves that are closer to each other than their generators.
//
// The curves are sampled, and near samples are found in a grid of boxes whose side is the largest distance of close
// curves.
#include "close_curves.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

#include "mesh/creases.hpp"

namespace gvd {
namespace {

/// Two curves are close where their distance is below this, in spacings. There, a generator of one curve can be nearer
/// to the middle between two generators of the other curve than these generators are.
constexpr double kCloseCurves = 0.5;

/// Close points must also be nearer to each other than this fraction of the way to the end of their curve. For two
/// curves that leave the same corner, that means an angle below 45 degrees.
const double kLeastSine = std::sqrt(0.5);

/// Points of the same curve count as close only if the way along the curve is longer than this, in spacings.
constexpr double kSameCourse = 1.5;

/// Number of samples of a curve per spacing.
constexpr double kSamplesPerSpacing = 4;

/// A sample of a curve, which stands for a part of it. Lengths are in mesh units.
struct CurveSample {
  Vec3 at;
  std::size_t curve;
  double along;   ///< position along the curve
  double to_end;  ///< distance to the end of the curve; infinite if it is closed
  double length;  ///< length of its part of the curve
};

void append_samples(const Mesh& mesh, const CreaseCurve& curve, std::size_t number, double length, double spacing,
                    std::vector<CurveSample>& samples) {
  const double parts = std::max(1.0, std::round(kSamplesPerSpacing * length / spacing));
  std::vector<double> at;
  for (double k = 0; k < parts; ++k) at.push_back(length * (k + 0.5) / parts);
  const std::vector<SurfacePoint> points = points_on_curve(mesh, curve, at);
  for (std::size_t k = 0; k < at.size(); ++k) {
    const double to_end = curve.closed ? kInfinity : std::min(at[k], length - at[k]);
    samples.push_back({position(mesh, points[k]), number, at[k], to_end, length / parts});
  }
}

}  // namespace

std::vector<Vec3> expect_opposite_generators(const Mesh& mesh, const std::vector<EdgeId>& creases, double spacing,
                                             double corner_distance) {
  const std::vector<CreaseCurve> curves = trace_creases(mesh, creases, corner_distance);
  std::vector<double> lengths;  // length of each curve
  std::vector<CurveSample> samples;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    lengths.push_back(total_length(mesh, curves[c].edges));
    append_samples(mesh, curves[c], c, lengths[c], spacing, samples);
  }
  const double reach = kCloseCurves * spacing;
  using Box = std::array<std::int64_t, 3>;
  const auto box_of = [&](const Vec3& at) {
    Box box{};
    for (int i = 0; i < 3; ++i) box[i] = static_cast<std::int64_t>(std::floor(at[i] / reach));
    return box;
  };
  std::map<Box, std::vector<std::size_t>> in_box;  // the samples in each box
  for (std::size_t i = 0; i < samples.size(); ++i) in_box[box_of(samples[i].at)].push_back(i);
  const auto is_same_course = [&](const CurveSample& a, const CurveSample& b) {
    if (a.curve != b.curve) return false;
    const double way = std::abs(a.along - b.along);
    const double other_way = curves[a.curve].closed ? lengths[a.curve] - way : kInfinity;
    return std::min(way, other_way) < kSameCourse * spacing;
  };
  const auto any_close = [&](const CurveSample& sample, const std::vector<std::size_t>& others) {
    const double within = std::min(reach, kLeastSine * sample.to_end);
    return std::ranges::any_of(others, [&](std::size_t i) {
      return (samples[i].at - sample.at).norm() < within && !is_same_course(sample, samples[i]);
    });
  };
  const auto has_close = [&](const CurveSample& sample) {
    const Box middle = box_of(sample.at);
    for (int k = 0; k < 27; ++k) {  // the box and its neighbours
      const auto near = in_box.find({middle[0] + k / 9 - 1, middle[1] + k / 3 % 3 - 1, middle[2] + k % 3 - 1});
      if (near != in_box.end() && any_close(sample, near->second)) return true;
    }
    return false;
  };
  std::vector<Vec3> places;
  double length = 0;
  for (const CurveSample& sample : samples) {
    if (has_close(sample)) length += sample.length;
    if (length < spacing) continue;
    places.push_back(sample.at);
    length -= spacing;
  }
  return places;
}

}  // namespace gvd
