// The paper's error measure E (section 5.2): how far the bisectors are from where the exact distances are equal.
//
// Every segment of a bisector is cut into panels with four Gauss-Lobatto samples each. Neighbouring panels share the
// sample between them.
// Source: equations (11) and (12); the paper names no quadrature. Between two vertices of a bisector, its points are
// taken to lie on the straight segment, as it is drawn and written.
// Invariant: there is one query for each generator, and the sums run in the order of the bisectors.
#include "gvd/error_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "base/barycentric.hpp"
#include "diagram/absolute_integral.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// One interval of the quadrature: the samples at its Gauss-Lobatto points.
struct Panel {
  std::array<std::size_t, 4> samples;
  double length;
};

/// A point with its two distances, which two queries answer.
struct SampledPoint {
  SurfacePoint point;
  BisectorId bisector;
  double left = 0;
  double right = 0;
};

[[noreturn]] void refuse(BisectorId bisector, const std::string& what) {
  throw Error(ErrorCode::precondition, fmt::format("bisector {} {}", bisector.value(), what), bisector.value());
}

/// The samples along all bisectors. Neighbouring panels share the sample between them.
struct BisectorSamples {
  std::vector<SampledPoint> samples;
  std::vector<Panel> panels;

  std::size_t add(BisectorId id, const SurfacePoint& point) {
    samples.push_back({point, id});
    return samples.size() - 1;
  }
};

void check_bisector(const Mesh& mesh, const Diagram& diagram, BisectorId id) {
  const Bisector& bisector = diagram.bisectors[id];
  const auto check_point = [&](const SurfacePoint& p) {
    if (!p.face.valid() || p.face.value() >= mesh.face_count())
      refuse(id, "refers to a face that the mesh does not have");
  };
  for (const GeneratorId g : {bisector.left, bisector.right}) {
    if (!g.valid() || g.index() >= diagram.generators.size())
      refuse(id, "refers to a generator that the diagram does not have");
    check_point(diagram.generators[g.index()]);
  }
  std::ranges::for_each(bisector.points, check_point);
}

/// Appends the samples of a bisector, `panels` for each segment.
void sample_bisector(const Mesh& mesh, BisectorId id, const Bisector& bisector, int panels, BisectorSamples& result) {
  const std::size_t count = bisector.points.size();
  if (count < 2) return;
  std::size_t last = result.add(id, bisector.points.front());
  const std::size_t segments = bisector.closed ? count : count - 1;
  for (std::size_t i = 0; i < segments; ++i) {
    const auto view = find_common_view(mesh, bisector.points[i], bisector.points[(i + 1) % count]);
    if (!view) refuse(id, fmt::format("has two points, {} and {}, that no face contains", i, (i + 1) % count));
    const auto& [a, b] = *view;
    const double length = (position(mesh, b) - position(mesh, a)).norm();
    if (length == 0) continue;
    for (int k = 0; k < panels; ++k) {
      Panel panel{{last, 0, 0, 0}, length / panels};
      for (std::size_t node = 1; node < 4; ++node) {
        const double t = (k + kLobattoNodes[node]) / panels;
        panel.samples[node] = result.add(id, make_surface_point(a.face, mix(a.bary, b.bary, t)));
      }
      last = panel.samples[3];
      result.panels.push_back(panel);
    }
  }
}

/// Queries and stores the distances of all samples, weights included, with one query for each generator.
void measure(const Diagram& diagram, const ExactDistances& exact, std::vector<SampledPoint>& samples) {
  struct Wanted {
    std::vector<SurfacePoint> points;
    std::vector<double*> slots;
  };
  std::map<GeneratorId, Wanted> by_generator;
  const auto want = [&](GeneratorId g, const SurfacePoint& point, double& slot) {
    by_generator[g].points.push_back(point);
    by_generator[g].slots.push_back(&slot);
  };
  for (SampledPoint& sample : samples) {
    want(diagram.bisectors[sample.bisector].left, sample.point, sample.left);
    want(diagram.bisectors[sample.bisector].right, sample.point, sample.right);
  }
  if (by_generator.empty()) return;
  std::vector<DistanceQuery> queries;
  for (auto& [g, wanted] : by_generator) queries.push_back({diagram.generators[g.index()], std::move(wanted.points)});
  const std::vector<std::vector<double>> answers = exact(queries);
  std::size_t q = 0;
  for (const auto& [g, wanted] : by_generator) {
    if (answers.size() != queries.size() || answers[q].size() != wanted.slots.size()) {
      throw Error(ErrorCode::precondition, "the exact distances do not match the points that were asked for");
    }
    for (std::size_t i = 0; i < wanted.slots.size(); ++i) *wanted.slots[i] = answers[q][i] + diagram.weight(g);
    ++q;
  }
}

/// d_left - d_right; infinite if either is, because infinity - infinity has no value.
double difference(const SampledPoint& sample) {
  const double d = sample.left - sample.right;
  return std::isfinite(d) ? d : kInfinity;
}

double integrate(const Panel& panel, const std::vector<SampledPoint>& samples) {
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) {
    values[i] = difference(samples[panel.samples[i]]);
    if (std::isinf(values[i])) return values[i];
  }
  return panel.length * integrate_absolute(values);
}

}  // namespace

ErrorMeasure compute_error_measure(const Mesh& mesh, const Diagram& diagram, const ExactDistances& exact,
                                   const ErrorMeasureOptions& options) {
  if (options.panels < 1) throw Error(ErrorCode::invalid_option, "the number of panels must be 1 or more");
  BisectorSamples sampled;
  for (const BisectorId id : diagram.bisectors.ids()) {
    check_bisector(mesh, diagram, id);
    const Bisector& bisector = diagram.bisectors[id];
    if (bisector.left != bisector.right) sample_bisector(mesh, id, bisector, options.panels, sampled);
  }
  measure(diagram, exact, sampled.samples);
  ErrorMeasure result;
  for (const Panel& panel : sampled.panels) {
    result.error_integral += integrate(panel, sampled.samples);
    result.length += panel.length;
  }
  for (const SampledPoint& sample : sampled.samples) {
    result.error_max = std::max(result.error_max, std::abs(difference(sample)));
  }
  if (result.length > 0) result.error_mean = result.error_integral / result.length;
  return result;
}

}  // namespace gvd
