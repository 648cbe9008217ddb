// Computes how fast bisectors pass mass from one cell to the other as the weights of their generators change.
//
// On a bisector, the difference of two distances equals the difference of two weights. If the latter grows by a small
// step, the bisector moves by step / |difference of the gradients|. Gradients are unit vectors along the shortest
// paths, which the windows of the diagram know.
//
// Invariant: rates are summed in the order of a bisector's points, so the result does not depend on the number of
// threads.
#include "balance_rates.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "base/barycentric.hpp"
#include "base/plane.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/windows/window_sources.hpp"
#include "gvd/diagram_steps.hpp"
#include "window_integrals.hpp"

namespace gvd {
namespace {

/// The least difference of two gradients, which are unit vectors. Below it, a bisector runs nearly along the paths to
/// it: its move is no longer linear, and its rate would outweigh all others.
constexpr double kLeastDifference = 1e-3;

/// Number of bisectors in a chunk, which takes less than a millisecond.
constexpr std::size_t kChunkBisectors = 16;

/// The two Gauss points of a segment.
constexpr std::array kGaussPoints{0.5 - 0.5 * std::numbers::inv_sqrt3, 0.5 + 0.5 * std::numbers::inv_sqrt3};

/// Computes rates along the bisectors of a diagram from its windows. Each thread has an object of its own.
class BisectorRates {
 public:
  BisectorRates(const WorkingMesh& working, const WindowField& field, const SplitFaces& split, const Density& density)
      : working_(working), field_(field), split_(split), density_(density) {}

  double rate(const Bisector& bisector) {
    const Mesh& mesh = working_.input();
    double sum = 0;
    const std::size_t count = bisector.points.size();
    for (std::size_t i = 0; i + (bisector.closed ? 0 : 1) < count; ++i) {
      const auto view = find_common_view(mesh, bisector.points[i], bisector.points[(i + 1) % count]);
      const auto& [from, to] = *view;  // consecutive points share a face
      const double length = (position(mesh, from) - position(mesh, to)).norm();
      for (const double t : kGaussPoints) {
        const Bary p = mix(from.bary, to.bary, t);
        const double difference = gradient_difference({from.face, p}, bisector);
        sum += length / kGaussPoints.size() * density_.at(from.face, p) / std::max(difference, kLeastDifference);
      }
    }
    return sum;
  }

 private:
  double gradient_difference(SurfacePoint p, const Bisector& bisector) {
    if (const auto parts = split_.parts_of(p.face); !parts.empty()) {
      p = locate_in_parts(parts, [&](const std::array<Bary, 3>& part) { return place_in_triangle(part, p.bary); });
    }
    if (p.face != face_) {
      face_ = p.face;
      layout_.emplace(working_.mesh(), face_);
      collect_face_sources(working_.mesh(), field_, face_, *layout_, sources_);
    }
    const Vec2 at = layout_->at(p.bary);
    return (gradient(at, bisector.left) - gradient(at, bisector.right)).norm();
  }
  /// The gradient of the distance from g: the direction in which its shortest path arrives.
  Vec2 gradient(const Vec2& at, GeneratorId g) const {
    FaceSource::Path shortest{kInfinity, at};
    for (const FaceSource& source : sources_) {
      if (source.generator != g) continue;
      const FaceSource::Path path = source.shortest_path(at);
      if (path.distance < shortest.distance) shortest = path;
    }
    const Vec2 way = at - shortest.from;
    return way.norm() > 0 ? Vec2(way.normalized()) : way;
  }

  const WorkingMesh& working_;
  const WindowField& field_;
  const SplitFaces& split_;
  const Density& density_;
  FaceId face_;  // a face of the working mesh
  std::optional<FaceLayout> layout_;
  std::vector<FaceSource> sources_;  // the sources of the face
};

}  // namespace

std::vector<double> integrate_balance_rates(const WorkingMesh& working, const WindowField& field,
                                            const Diagram& diagram, const Density& density,
                                            const ParallelChunks& parallel) {
  const SplitFaces split(working);
  const auto chunks = cut_into_chunks(diagram.bisectors.size(), kChunkBisectors);
  return parallel.collect(chunks, {steps::kCells}, [&](const Chunk& chunk) {
    BisectorRates rates(working, field, split, density);
    std::vector<double> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) found.push_back(rates.rate(diagram.bisectors[BisectorId(i)]));
    return found;
  });
}

}  // namespace gvd
