#include "pieces/chain_segments.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>

#include "base/union_find.hpp"
#include "gvd/surface_point.hpp"

namespace gvd::paper {
namespace {

constexpr std::int32_t kNone = -1;

/// Numbers points so that those within a distance have one number: sorted along x, only neighbours are compared.
std::vector<std::int32_t> number_points(const std::vector<Vec3>& points, double distance) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x() < points[b].x(); });
  UnionFind sets(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3& p = points[order[i]];
    for (std::size_t j = i + 1; j < order.size() && points[order[j]].x() - p.x() <= distance; ++j) {
      if ((points[order[j]] - p).norm() <= distance) {
        sets.unite(static_cast<std::int32_t>(order[i]), static_cast<std::int32_t>(order[j]));
      }
    }
  }
  std::vector<std::int32_t> numbers(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) numbers[i] = sets.find(static_cast<std::int32_t>(i));
  return numbers;
}

class Chainer {
 public:
  Chainer(const Mesh& mesh, const std::vector<Segment>& segments)
      : mesh_(mesh), segments_(segments), next_(segments.size(), kNone), previous_(segments.size(), kNone) {}

  Chains chain() {
    join();
    Chains chains;
    chains.open_ends = open_ends_;
    std::vector<char> done(segments_.size(), 0);
    // First the chains with two ends, then what is left: closed ones.
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        if (done[i] == 0 && (closed || previous_[i] == kNone)) chains.bisectors.push_back(follow(i, closed, done));
      }
    }
    return chains;
  }

 private:
  struct End {
    std::int32_t point;
    std::size_t segment;
    bool is_begin;
  };

  /// Links each segment to the one that continues it.
  void join() {
    std::vector<Vec3> points;
    for (const Segment& s : segments_) {
      points.push_back(position(mesh_, s.begin));
      points.push_back(position(mesh_, s.end));
    }
    const auto numbers = number_points(points, kSameEnd * mesh_.bbox_diagonal());
    std::vector<End> ends;
    for (std::size_t i = 0; i < points.size(); ++i) ends.push_back({numbers[i], i / 2, i % 2 == 0});
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.point < b.point; });
    for (std::size_t i = 0; i < ends.size();) {
      std::size_t j = i;
      while (j < ends.size() && ends[j].point == ends[i].point) ++j;
      join_at_point(ends, i, j);
      i = j;
    }
  }

  void join_at_point(const std::vector<End>& ends, std::size_t first, std::size_t last) {
    if (last == first + 1 && !is_on_boundary(mesh_, end_point(ends[first]))) ++open_ends_;
    for (std::size_t i = first; i < last; ++i) {
      for (std::size_t j = first; j < last; ++j) {
        if (!ends[i].is_begin && ends[j].is_begin) link(ends[i].segment, ends[j].segment);
      }
    }
  }

  const SurfacePoint& end_point(const End& end) const {
    return end.is_begin ? segments_[end.segment].begin : segments_[end.segment].end;
  }

  void link(std::size_t from, std::size_t to) {
    const Segment &a = segments_[from], &b = segments_[to];
    if (from == to || a.left != b.left || a.right != b.right) return;
    if (next_[from] != kNone || previous_[to] != kNone) return;
    if (!find_common_view(mesh_, a.begin, b.begin)) return;  // rounding has moved the point off their common edge
    next_[from] = static_cast<std::int32_t>(to);
    previous_[to] = static_cast<std::int32_t>(from);
  }

  Bisector follow(std::size_t first, bool closed, std::vector<char>& done) const {
    Bisector bisector;
    bisector.left = segments_[first].left;
    bisector.right = segments_[first].right;
    bisector.closed = closed;
    std::size_t i = first;
    while (done[i] == 0) {
      done[i] = 1;
      bisector.points.push_back(segments_[i].begin);
      if (next_[i] == kNone) bisector.points.push_back(segments_[i].end);
      if (next_[i] != kNone) i = static_cast<std::size_t>(next_[i]);
    }
    return bisector;
  }

  const Mesh& mesh_;
  const std::vector<Segment>& segments_;
  std::vector<std::int32_t> next_, previous_;
  std::int64_t open_ends_ = 0;
};

}  // namespace

Chains chain_segments(const Mesh& mesh, const std::vector<Segment>& segments) {
  return Chainer(mesh, segments).chain();
}

}  // namespace gvd::paper
