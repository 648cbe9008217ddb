#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace gvd {

/// An ear: a corner that can be cut off a polygon, and how good the triangle is that it leaves.
struct EarCandidate {
  double quality;
  std::size_t corner;
  int version;  ///< of the corner when the candidate was made: an older one is outdated

  /// By quality; of equal ones the first corner is the largest, so that a std::priority_queue gives it first.
  bool operator<(const EarCandidate& other) const {
    return quality != other.quality ? quality < other.quality : corner > other.corner;
  }
};

/// The corners of a polygon that are left while ears are cut off: a ring of links. What both ear clippers share,
/// `triangulate_plane_polygon` and `triangulate_polygon` of the repair. They differ in what an ear is: the first knows
/// that its polygon is simple and always ends, the second finds out whether it is.
class PolygonRing {
 public:
  explicit PolygonRing(std::size_t n) : links_(n), left_(n) {
    for (std::size_t i = 0; i < n; ++i) links_[i] = {(i + n - 1) % n, (i + 1) % n};
  }

  /// Number of corners at the start, and of those that are left.
  std::size_t corner_count() const { return links_.size(); }
  std::size_t left_count() const { return left_; }

  bool is_left(std::size_t i) const { return links_[i].is_left; }
  /// The neighbours of a corner that is left.
  std::size_t before(std::size_t i) const { return links_[i].before; }
  std::size_t after(std::size_t i) const { return links_[i].after; }
  /// The triangle that corner i would leave.
  std::array<std::size_t, 3> triangle(std::size_t i) const { return {before(i), i, after(i)}; }
  /// How often the triangle of corner i has changed.
  int version(std::size_t i) const { return links_[i].version; }

  EarCandidate candidate(std::size_t i, double quality) const { return {quality, i, version(i)}; }
  /// Whether the candidate's triangle is still that of its corner.
  bool is_current(const EarCandidate& ear) const { return is_left(ear.corner) && ear.version == version(ear.corner); }

  /// The first corner that is left. At least one must be.
  std::size_t first_left() const {
    const auto found = std::find_if(links_.begin(), links_.end(), [](const Link& link) { return link.is_left; });
    return static_cast<std::size_t>(found - links_.begin());
  }

  /// Cuts a corner off. The triangles of its two neighbours change.
  void remove(std::size_t i) {
    Link& link = links_[i];
    link.is_left = false;
    links_[link.before].after = link.after;
    links_[link.after].before = link.before;
    ++links_[link.before].version;
    ++links_[link.after].version;
    --left_;
  }

 private:
  struct Link {
    std::size_t before = 0, after = 0;
    int version = 0;
    bool is_left = true;
  };

  std::vector<Link> links_;
  std::size_t left_;
};

}  // namespace gvd
