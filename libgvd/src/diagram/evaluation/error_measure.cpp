#include "gvd/error_measure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>

#include "base/barycentric.hpp"
#include "diagram/evaluation/absolute_integral.hpp"
#include "gvd/error.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {
namespace {

/// One interval of the quadrature: the samples at its Gauss-Lobatto points.
struct Panel {
  std::array<std::size_t, 4> samples;
  double length;
};

/// A point with its two distances, which come from two queries.
struct Sample {
  SurfacePoint point;
  BisectorId bisector;
  double left = 0;
  double right = 0;
};

[[noreturn]] void refuse(BisectorId bisector, const std::string& what) {
  throw Error(ErrorCode::precondition, fmt::format("bisector {} {}", bisector.value(), what), bisector.value());
}

/// The samples along all bisectors. Neighbouring panels share the sample between them.
class BisectorSampling {
 public:
  BisectorSampling(const Mesh& mesh, const Diagram& diagram, int panels) : mesh_(mesh), panels_(panels) {
    for (std::size_t i = 0; i < diagram.bisectors.size(); ++i) {
      const BisectorId id(i);
      check(id, diagram);
      if (diagram.bisectors[id].left != diagram.bisectors[id].right) add(id, diagram.bisectors[id]);
    }
  }

  std::vector<Sample> samples;
  std::vector<Panel> all_panels;

 private:
  void check(BisectorId id, const Diagram& diagram) const {
    const Bisector& bisector = diagram.bisectors[id];
    for (const GeneratorId g : {bisector.left, bisector.right}) {
      if (!g.valid() || g.index() >= diagram.generators.size()) refuse(id, "refers to no generator of the diagram");
      check(id, diagram.generators[g.index()]);
    }
    for (const SurfacePoint& point : bisector.points) check(id, point);
  }

  void check(BisectorId id, const SurfacePoint& point) const {
    if (!point.face.valid() || point.face.value() >= mesh_.face_count()) refuse(id, "refers to no face of the mesh");
  }

  std::size_t add_sample(BisectorId id, const SurfacePoint& point) {
    samples.push_back({point, id});
    return samples.size() - 1;
  }

  void add(BisectorId id, const Bisector& bisector) {
    const std::size_t count = bisector.points.size();
    if (count < 2) return;
    const std::size_t first = add_sample(id, bisector.points.front());
    std::size_t last = first;
    const std::size_t segments = bisector.closed ? count : count - 1;
    for (std::size_t i = 0; i < segments; ++i) {
      const auto view = find_common_view(mesh_, bisector.points[i], bisector.points[(i + 1) % count]);
      if (!view) refuse(id, fmt::format("has no face in common for its points {} and {}", i, (i + 1) % count));
      add_segment(id, view->first, view->second, last);
    }
  }

  void add_segment(BisectorId id, const SurfacePoint& a, const SurfacePoint& b, std::size_t& last) {
    const double length = (position(mesh_, b) - position(mesh_, a)).norm();
    if (length == 0) return;
    for (int k = 0; k < panels_; ++k) {
      Panel panel{{last, 0, 0, 0}, length / panels_};
      for (std::size_t i = 1; i < 4; ++i) {
        panel.samples[i] = add_sample(id, between(a, b, (k + kLobattoNodes[i]) / panels_));
      }
      last = panel.samples[3];
      all_panels.push_back(panel);
    }
  }

  static SurfacePoint between(const SurfacePoint& a, const SurfacePoint& b, double t) {
    return make_surface_point(a.face, mix(a.bary, b.bary, t));
  }

  const Mesh& mesh_;
  int panels_;
};

/// Queries and stores the distances of all samples, in one query for each generator.
void measure(const Diagram& diagram, const ExactDistances& exact, std::vector<Sample>& samples) {
  std::vector<std::vector<double*>> slots(diagram.generators.size());
  std::vector<DistanceQuery> by_generator(diagram.generators.size());
  const auto want = [&](GeneratorId g, Sample& sample, double Sample::*side) {
    slots[g.index()].push_back(&(sample.*side));
    by_generator[g.index()].points.push_back(sample.point);
  };
  for (Sample& sample : samples) {
    want(diagram.bisectors[sample.bisector].left, sample, &Sample::left);
    want(diagram.bisectors[sample.bisector].right, sample, &Sample::right);
  }
  std::vector<DistanceQuery> queries;
  std::vector<std::vector<double*>> wanted;
  for (std::size_t g = 0; g < slots.size(); ++g) {
    if (slots[g].empty()) continue;
    queries.push_back({diagram.generators[g], std::move(by_generator[g].points)});
    wanted.push_back(std::move(slots[g]));
  }
  if (queries.empty()) return;
  const std::vector<std::vector<double>> answers = exact(queries);
  for (std::size_t q = 0; q < queries.size(); ++q) {
    if (answers.size() != queries.size() || answers[q].size() != wanted[q].size()) {
      throw Error(ErrorCode::precondition, "the exact distances do not match the points that were asked for");
    }
    for (std::size_t i = 0; i < wanted[q].size(); ++i) *wanted[q][i] = answers[q][i];
  }
}

/// d_left - d_right; infinite if either is, since infinity - infinity has no value.
double difference(const Sample& sample) {
  const double d = sample.left - sample.right;
  return std::isfinite(d) ? d : std::numeric_limits<double>::infinity();
}

double integrate(const Panel& panel, const std::vector<Sample>& samples) {
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
  BisectorSampling sampling(mesh, diagram, options.panels);
  measure(diagram, exact, sampling.samples);
  ErrorMeasure result;
  for (const Panel& panel : sampling.all_panels) {
    result.error_integral += integrate(panel, sampling.samples);
    result.length += panel.length;
  }
  for (const Sample& sample : sampling.samples) {
    result.error_max = std::max(result.error_max, std::abs(difference(sample)));
  }
  if (result.length > 0) result.error_mean = result.error_integral / result.length;
  return result;
}

}  // namespace gvd
