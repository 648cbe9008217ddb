#include "diagram/envelope/source_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "diagram/envelope/equidistant_points.hpp"

namespace gvd {
namespace {

/// Three distances that differ by less than this part of themselves are equal: a few units in the last place of sums of
/// three terms.
constexpr double kEqual = 1e-14;

/// What is accepted where Newton's steps no longer gain anything: the rounding of a point far from its images.
constexpr double kResidual = 1e-12;

/// Another generator this much nearer, as a part of the distance, is as near as the three: a branch point of degree
/// four.
constexpr double kTie = 1e-12;

/// Two distances to a crossing differ by up to this part of themselves: they are taken for equal within a quarter of
/// it, and are rounded sums.
constexpr double kCrossingError = 4e-14;

/// Where three distances differ by less than this part of themselves, Newton's method finds the place where they don't.
constexpr double kNearMeeting = 1e-6;

constexpr int kNewtonSteps = 40, kHalvings = 6;

/// Moves a point that lies a little beyond a side, or just on it, inside.
std::array<double, 3> moved_inside(std::array<double, 3> bary) {
  const double least = *std::min_element(bary.begin(), bary.end());
  if (least >= kInsideFace || least < -kBeyondFace) return bary;
  double sum = 0;
  for (double& b : bary) sum += b = std::max(b, kInsideFace);
  for (double& b : bary) b /= sum;
  return bary;
}

}  // namespace

void SourceDistances::enter(const Mesh& mesh, FaceId f) {
  layout_.emplace(mesh, f);
  field_.collect(f, *layout_, found_);
  others_.clear();
  has_offsets_ = false;
  order_.clear();
  for (const FaceSource& s : found_) order_.emplace_back(s.generator, static_cast<std::int32_t>(order_.size()));
  std::sort(order_.begin(), order_.end());
  sources_.clear();
  for (const auto& [generator, place] : order_) sources_.push_back(found_[static_cast<std::size_t>(place)]);
  bring_nearest_forward();
}

/// The most likely one of each generator comes first: then most of the others are passed over without a square root.
void SourceDistances::bring_nearest_forward() {
  const Vec2 centre = (layout_->corner[0] + layout_->corner[1] + layout_->corner[2]) / 3;
  FaceSource::Path best{};
  for (std::size_t i = 0, first = 0; i < sources_.size(); ++i) {
    if (i == 0 || sources_[i].generator != sources_[first].generator) {
      first = i;
      best.distance = std::numeric_limits<double>::infinity();
    }
    if (take_nearer(sources_[i], centre, best)) std::swap(sources_[i], sources_[first]);
  }
}

void SourceDistances::set_symbolic_offsets(bool tied) {
  if (tied == has_offsets_) return;
  if (others_.empty()) {
    others_ = sources_;
    for (FaceSource& source : others_) {
      const double tie = tie_step_ * static_cast<double>(source.generator.value());
      source.offset += tie;
      source.distance_begin += tie;
      source.distance_end += tie;
    }
  }
  std::swap(sources_, others_);
  has_offsets_ = tied;
}

std::span<const FaceSource> SourceDistances::sources(GeneratorId g) const {
  // By halving: one large face beside hundreds of small cells has thousands of sources.
  const auto begin = std::partition_point(sources_.begin(), sources_.end(),
                                          [g](const FaceSource& source) { return source.generator < g; });
  const auto end = std::find_if(begin, sources_.end(), [g](const FaceSource& source) { return source.generator != g; });
  return {begin, end};
}

SourceDistances::Nearest SourceDistances::nearest(std::span<const FaceSource> sources, const Vec2& p) {
  Nearest best{nullptr, {std::numeric_limits<double>::infinity(), p}};
  for (const FaceSource& source : sources) {
    if (take_nearer(source, p, best.path)) best.source = &source;
  }
  return best;
}

FaceDistances::Bary SourceDistances::bary(const Vec2& p) const { return layout_->bary(p); }

std::optional<double> SourceDistances::entry(GeneratorId g, const Bary& bary) const {
  if (!can_confirm_) return std::nullopt;
  const Vec2 p = layout_->at(bary);
  const Nearest best = nearest(sources(g), p);
  if (best.source == nullptr) return std::nullopt;
  const int side = Mesh::corner(best.source->halfedge);
  if (best.source->is_corner) return side;
  const Vec2 start = layout_->corner[static_cast<std::size_t>(side)];
  const Vec2 along = layout_->corner[static_cast<std::size_t>((side + 1) % 3)] - start;
  return side + std::clamp((best.source->entry(p) - start).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

double SourceDistances::at(GeneratorId g, const Bary& p) const { return nearest(g, layout_->at(p)).distance; }

std::optional<FaceDistances::Bary> SourceDistances::equidistant(GeneratorId a, GeneratorId b, GeneratorId c,
                                                                const Bary& start) const {
  struct State {
    Vec2 p;
    FaceSource::Path a, b, c;
    Vec2 error() const { return {a.distance - b.distance, a.distance - c.distance}; }
    double size() const { return error().cwiseAbs().maxCoeff(); }
  };
  const auto look = [&](const Vec2& p) { return State{p, nearest(a, p), nearest(b, p), nearest(c, p)}; };
  State now = look(layout_->at(start));
  const double longest =
      (layout_->corner[1] - layout_->corner[0]).norm() + (layout_->corner[2] - layout_->corner[1]).norm();
  for (int step = 0; step < kNewtonSteps && now.size() > kEqual * now.a.distance; ++step) {
    const Vec2 u = direction(now.p, now.a.from), v = direction(now.p, now.b.from), w = direction(now.p, now.c.from);
    const Vec2 first = u - v, second = u - w, error = now.error();
    const double determinant = cross(first, second);
    Vec2 move((second.y() * error.x() - first.y() * error.y()) / -determinant,
              (first.x() * error.y() - second.x() * error.x()) / -determinant);
    if (!move.allFinite()) break;
    if (move.norm() > longest) move *= longest / move.norm();
    State next = look(now.p + move);
    for (int half = 0; half < kHalvings && !(next.size() < now.size()); ++half) {
      move *= 0.5;
      next = look(now.p + move);
    }
    if (!(next.size() < now.size())) break;
    now = next;
  }
  // Infinite where the face knows nothing of a generator.
  if (std::isinf(now.a.distance) || !(now.size() <= kResidual * now.a.distance)) return std::nullopt;
  return moved_inside(bary(now.p));
}

std::vector<FaceDistances::Bary> SourceDistances::equidistant_points(GeneratorId a, GeneratorId b,
                                                                     GeneratorId c) const {
  std::vector<Bary> found;
  for (const Vec2& p : gvd::equidistant_points(sources(a), sources(b), sources(c))) {
    const Bary at = bary(p);
    if (!(*std::min_element(at.begin(), at.end()) > -kBeyondFace)) continue;
    const auto [least, most] = std::minmax({this->at(a, at), this->at(b, at), this->at(c, at)});
    if (most - least <= kNearMeeting * least) found.push_back(at);
  }
  return found;
}

double SourceDistances::crossing_error(const BoundaryCrossing& crossing) const {
  const Vec2 p = layout_->at(crossing.bary());
  const auto before = nearest(crossing.previous, p), after = nearest(crossing.next, p);
  const double rate =
      std::abs((direction(p, before.from) - direction(p, after.from)).dot(layout_->side(crossing.corner)));
  const auto corner = static_cast<std::size_t>(crossing.corner);
  const double length = (layout_->corner[(corner + 1) % 3] - layout_->corner[corner]).norm();
  return kCrossingError * before.distance / (rate * length);
}

bool SourceDistances::is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& bary) const {
  if (!can_confirm_ || *std::min_element(bary.begin(), bary.end()) < kInsideFace * (1 - 1e-3)) return false;
  const Vec2 p = layout_->at(bary);
  const auto path_a = nearest(a, p), path_b = nearest(b, p), path_c = nearest(c, p);
  for (const FaceSource& s : sources_) {
    if (s.generator == a || s.generator == b || s.generator == c) continue;
    if (s.shortest_path(p).distance < path_a.distance * (1 - kTie)) return false;
  }
  const Vec2 u = direction(p, path_a.from), v = direction(p, path_b.from), w = direction(p, path_c.from);
  return twice_signed_area(u, v, w) > 0;
}

}  // namespace gvd
