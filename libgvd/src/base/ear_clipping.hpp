#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "gvd/vec.hpp"

namespace gvd {

/// Cuts a simple, counter-clockwise polygon into triangles along diagonals.
///
/// Source:  ear clipping (G. H. Meisters, Polygons have ears, 1975). The roundest ear is cut first, so that corners on
///          a straight side become corners of triangles with an area. If rounding leaves no ear of positive area, the
///          corner with the largest signed area is cut
/// Inputs:  corners with coordinates in [0, 1]; sides may touch, corners may repeat
/// Returns: triangles of corner numbers, counter-clockwise: always two fewer than corners, none for fewer than three
/// Cost:    O(n^2) worst, O(n log n) in practice
std::vector<std::array<std::size_t, 3>> triangulate_plane_polygon(const std::vector<Vec2>& corners);

/// An ear: a corner that can be cut off a polygon, and the quality of the triangle that this makes.
struct EarCandidate {
  double quality;
  std::size_t corner;
  int version;  ///< the version of the corner's triangle; the candidate is outdated once the triangle has changed

  /// Orders candidates by quality. Of equally good ones the first corner counts as the largest, so that a
  /// std::priority_queue returns it first.
  bool operator<(const EarCandidate& other) const {
    return quality != other.quality ? quality < other.quality : corner > other.corner;
  }
};

/// The remaining corners of a polygon while ears are cut off, as a doubly linked ring. Two ear clippers share it,
/// `triangulate_plane_polygon` and `triangulate_polygon` of the repair. They differ in their definition of an ear: the
/// first may assume that its polygon is simple and always ends, the second finds out whether its polygon is simple.
class PolygonRing {
 public:
  explicit PolygonRing(std::size_t n) : links_(n), left_(n) {
    for (std::size_t i = 0; i < n; ++i) links_[i] = {(i + n - 1) % n, (i + 1) % n};
  }

  /// The number of corners at the start, and the number that remain.
  std::size_t corner_count() const { return links_.size(); }
  std::size_t left_count() const { return left_; }

  bool is_left(std::size_t i) const { return links_[i].is_left; }
  /// The neighbours of a remaining corner.
  std::size_t before(std::size_t i) const { return links_[i].before; }
  std::size_t after(std::size_t i) const { return links_[i].after; }
  /// The triangle that is cut off with corner i.
  std::array<std::size_t, 3> triangle(std::size_t i) const { return {before(i), i, after(i)}; }
  /// How often the triangle of corner i has changed.
  int version(std::size_t i) const { return links_[i].version; }

  EarCandidate candidate(std::size_t i, double quality) const { return {quality, i, version(i)}; }
  /// Whether the candidate's corner remains and still has the same triangle.
  bool is_current(const EarCandidate& ear) const { return is_left(ear.corner) && ear.version == version(ear.corner); }

  /// The remaining corner with the smallest number. At least one corner must remain.
  std::size_t first_left() const {
    const auto found = std::find_if(links_.begin(), links_.end(), [](const Link& link) { return link.is_left; });
    return found - links_.begin();
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
