// The shortest paths to points of one face, over the sources that a solver has in it.
//
// A source's path is straight where its image sees the point through its opening, and bends round an end of the opening
// elsewhere: always a path of the surface, so that the least over all sources is the distance itself. Equidistant
// points come from Newton's method on the differences of three distances, damped, because the shortest path may change
// from one source to another on the way. A result counts only where the three distances agree to rounding.
#include "diagram/envelope/source_distances.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gvd {
namespace {

/// Three distances that differ by less than this fraction of themselves are equal: a few units in the last place of
/// sums of three terms.
constexpr double kEqualDistance = 1e-14;

/// Difference accepted where Newton's steps no longer improve it, as a fraction of the distance: the rounding of a
/// point far from its images.
constexpr double kResidual = 1e-12;

/// Another generator nearer by up to this fraction of the distance is equally far: the branch point has degree four.
constexpr double kEquallyFar = 1e-12;

/// Difference of the two distances at a crossing, as a fraction of them. The envelope takes them for equal within a
/// quarter of it, and they are rounded sums.
constexpr double kCrossingError = 4e-14;

/// Candidates for branch points: points whose three distances differ by less than this fraction of themselves. Newton's
/// method starts there.
constexpr double kNearlyEqual = 1e-6;

constexpr int kMostNewtonSteps = 40, kStepHalvings = 6;

/// Moves a point that lies on a side, or a little beyond it, inside the face.
Bary moved_inside(Bary bary) {
  const double least = *std::min_element(bary.begin(), bary.end());
  if (least >= kInsideFace || least < -kBeyondFace) return bary;
  double sum = 0;
  for (double& b : bary) sum += b = std::max(b, kInsideFace);
  for (double& b : bary) b /= sum;
  return bary;
}

/// The shortest paths of three generators to a point.
struct ThreePaths {
  Vec2 p;
  FaceSource::Path a, b, c;
  Vec2 error() const { return {a.distance - b.distance, a.distance - c.distance}; }
  double size() const { return error().cwiseAbs().maxCoeff(); }
  bool are_equal() const { return !(size() > kEqualDistance * a.distance); }
  /// Newton's step to the point where the three are equally long, if they keep their last straight pieces.
  Vec2 newton_step() const {
    const Vec2 u = direction(p, a.from), v = direction(p, b.from), w = direction(p, c.from);
    const Vec2 first = u - v, second = u - w, e = error();
    const double determinant = cross(first, second);
    return {(second.y() * e.x() - first.y() * e.y()) / -determinant,
            (first.x() * e.y() - second.x() * e.x()) / -determinant};
  }
};

}  // namespace

void SourceDistances::enter(const Mesh& mesh, FaceId f) {
  layout_.emplace(mesh, f);
  field_.collect(f, *layout_, found_);
  order_.clear();
  for (const FaceSource& s : found_) order_.emplace_back(s.generator, static_cast<std::int32_t>(order_.size()));
  std::sort(order_.begin(), order_.end());
  sources_.clear();
  for (const auto& [generator, index] : order_) sources_.push_back(found_[index]);
  bring_nearest_forward();
}

/// Puts the nearest source of each generator first, as seen from the centre. Then most others need no square root.
void SourceDistances::bring_nearest_forward() {
  const Vec2 centre = (layout_->corner[0] + layout_->corner[1] + layout_->corner[2]) / 3;
  FaceSource::Path best{};
  for (std::size_t i = 0, first = 0; i < sources_.size(); ++i) {
    if (i == 0 || sources_[i].generator != sources_[first].generator) {
      first = i;
      best.distance = kInfinity;
    }
    if (take_nearer(sources_[i], centre, best)) std::swap(sources_[i], sources_[first]);
  }
}

void SourceDistances::enter_with_offsets(const SourceDistances& others, const SymbolicOffset& offset) {
  layout_ = others.layout_;
  sources_ = others.sources_;
  for (FaceSource& source : sources_) {
    const double longer = offset.of(source.generator);
    source.offset += longer;
    source.distance_begin += longer;
    source.distance_end += longer;
  }
}

std::span<const FaceSource> SourceDistances::sources(GeneratorId g) const {
  // Binary search: a large face beside hundreds of small cells has thousands of sources.
  const auto begin = std::partition_point(sources_.begin(), sources_.end(),
                                          [g](const FaceSource& source) { return source.generator < g; });
  const auto end = std::find_if(begin, sources_.end(), [g](const FaceSource& source) { return source.generator != g; });
  return {begin, end};
}

SourceDistances::Nearest SourceDistances::nearest(std::span<const FaceSource> sources, const Vec2& p) {
  Nearest best{nullptr, {kInfinity, p}};
  for (const FaceSource& source : sources) {
    if (take_nearer(source, p, best.path)) best.source = &source;
  }
  return best;
}

std::optional<double> SourceDistances::entry(GeneratorId g, const Bary& bary) const {
  const Vec2 p = layout_->at(bary);
  const Nearest best = nearest(sources(g), p);
  if (best.source == nullptr) return std::nullopt;
  const int side = Mesh::corner(best.source->halfedge);
  if (best.source->is_corner) return side;
  const Vec2 start = layout_->corner[side];
  const Vec2 along = layout_->corner[(side + 1) % 3] - start;
  return side + nearest_on_segment(start, along, best.source->entry(p));
}

double SourceDistances::at(GeneratorId g, const Bary& p) const { return nearest(g, layout_->at(p)).distance; }

std::optional<Bary> SourceDistances::equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const {
  const auto paths_to = [&](const Vec2& p) { return ThreePaths{p, nearest(a, p), nearest(b, p), nearest(c, p)}; };
  ThreePaths paths = paths_to(layout_->at(start));
  const double longest =
      (layout_->corner[1] - layout_->corner[0]).norm() + (layout_->corner[2] - layout_->corner[1]).norm();
  for (int i = 0; i < kMostNewtonSteps && !paths.are_equal(); ++i) {
    Vec2 step = paths.newton_step();
    if (!step.allFinite()) break;
    if (step.norm() > longest) step *= longest / step.norm();
    ThreePaths next = paths_to(paths.p + step);
    for (int half = 0; half < kStepHalvings && !(next.size() < paths.size()); ++half) {
      step *= 0.5;
      next = paths_to(paths.p + step);
    }
    if (!(next.size() < paths.size())) break;
    paths = next;
  }
  // Infinite where the face has no source of a generator.
  if (std::isinf(paths.a.distance) || !(paths.size() <= kResidual * paths.a.distance)) return std::nullopt;
  return moved_inside(layout_->bary(paths.p));
}

std::vector<Bary> SourceDistances::equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const {
  std::vector<Bary> found;
  for (const Vec2& p : search_.find(*layout_, sources(a), sources(b), sources(c))) {
    const Bary bary = layout_->bary(p);
    if (!(*std::min_element(bary.begin(), bary.end()) > -kBeyondFace)) continue;
    const auto [least, most] = std::minmax({at(a, bary), at(b, bary), at(c, bary)});
    if (most - least <= kNearlyEqual * least) found.push_back(bary);
  }
  return found;
}

double SourceDistances::crossing_error(const BoundaryCrossing& crossing) const {
  const Vec2 p = layout_->at(crossing.bary());
  const auto before = nearest(crossing.previous, p), after = nearest(crossing.next, p);
  const double rate =
      std::abs((direction(p, before.from) - direction(p, after.from)).dot(layout_->side(crossing.corner)));
  const double length = (layout_->corner[(crossing.corner + 1) % 3] - layout_->corner[crossing.corner]).norm();
  return kCrossingError * before.distance / (rate * length);
}

bool SourceDistances::is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& bary) const {
  if (*std::min_element(bary.begin(), bary.end()) < kInsideFace * (1 - 1e-3)) return false;
  const Vec2 p = layout_->at(bary);
  const auto path_a = nearest(a, p), path_b = nearest(b, p), path_c = nearest(c, p);
  for (const FaceSource& s : sources_) {
    if (s.generator == a || s.generator == b || s.generator == c) continue;
    if (s.shortest_path(p).distance < path_a.distance * (1 - kEquallyFar)) return false;
  }
  const Vec2 u = direction(p, path_a.from), v = direction(p, path_b.from), w = direction(p, path_c.from);
  return twice_signed_area(u, v, w) > 0;
}

}  // namespace gvd
