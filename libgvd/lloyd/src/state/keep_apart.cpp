#include "keep_apart.hpp"

#include <algorithm>
#include <numeric>

namespace gvd {
namespace {

class Separator {
 public:
  Separator(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap, std::vector<SurfacePoint>& to)
      : mesh_(mesh), from_(from), to_(to), gap_(gap), order_(to.size()), is_at_start_(to.size(), 0) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    for (const SurfacePoint& p : to) positions_.push_back(position(mesh, p));
    for (std::size_t i = 0; i < to.size(); ++i) is_at_start_[i] = to[i] == from[i];
  }

  /// Every round but the last undoes a move, and a point that is back at its start stays there.
  std::int32_t run() {
    std::int32_t held = 0;
    for (std::vector<std::size_t> colliding = find(); !colliding.empty(); colliding = find()) {
      for (const std::size_t i : colliding) {
        is_at_start_[i] = 1;
        to_[i] = from_[i];
        positions_[i] = position(mesh_, from_[i]);
      }
      held += static_cast<std::int32_t>(colliding.size());
    }
    return held;
  }

 private:
  /// The moved points that are too close to another one, found by a sweep along x.
  std::vector<std::size_t> find() {
    std::sort(order_.begin(), order_.end(), [&](std::size_t a, std::size_t b) {
      return std::pair(positions_[a].x(), a) < std::pair(positions_[b].x(), b);
    });
    std::vector<std::size_t> colliding;
    for (std::size_t i = 0; i < order_.size(); ++i) {
      for (std::size_t k = i + 1; k < order_.size(); ++k) {
        const std::size_t a = order_[i], b = order_[k];
        if (positions_[b].x() - positions_[a].x() > gap_) break;
        if ((positions_[b] - positions_[a]).norm() > gap_) continue;
        if (!is_at_start_[a]) colliding.push_back(a);
        if (!is_at_start_[b]) colliding.push_back(b);
      }
    }
    std::sort(colliding.begin(), colliding.end());
    colliding.erase(std::unique(colliding.begin(), colliding.end()), colliding.end());
    return colliding;
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& from_;
  std::vector<SurfacePoint>& to_;
  double gap_;
  std::vector<std::size_t> order_;
  std::vector<char> is_at_start_;
  std::vector<Vec3> positions_;
};

}  // namespace

std::int32_t keep_apart(const Mesh& mesh, const std::vector<SurfacePoint>& from, double gap,
                        std::vector<SurfacePoint>& to) {
  return Separator(mesh, from, gap, to).run();
}

}  // namespace gvd
