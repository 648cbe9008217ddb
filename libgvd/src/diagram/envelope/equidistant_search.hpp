#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "geodesic/distance_field.hpp"
#include "geodesic/face_layout.hpp"

namespace gvd {

/// Searches the points of a face that are equally far from three generators. One object serves many faces, to save
/// allocations.
class EquidistantSearch {
 public:
  /// All candidates in the face, to rounding, or to half of the digits where two rays touch: the branch points of the
  /// three generators are among them. Most are none: the rays don't pass the openings, or another source is nearer.
  /// Cost: O(k) memory, and mostly O(k log k) time, for k sources; a bounded number of cells, however many paths tie.
  const std::vector<Vec2>& find(const FaceLayout& face, std::span<const FaceSource> a, std::span<const FaceSource> b,
                                std::span<const FaceSource> c);

 private:
  /// A triangle inside the face.
  using Cell = std::array<Vec2, 3>;
  /// Where the sources of the three generators begin on the stack; the last entry is where they end.
  using Lists = std::array<std::size_t, 4>;
  struct Disc;

  void search(const Cell& cell, const Lists& lists, int halvings);
  Lists keep_relevant(const Disc& disc, const Lists& lists);
  void search_halves(const Cell& cell, const Lists& lists, int halvings);
  void solve(const Disc& disc, const Lists& lists);
  std::span<const FaceSource> sources(const Lists& lists, std::size_t i) const {
    return std::span(stack_).subspan(lists[i], lists[i + 1] - lists[i]);
  }

  std::vector<FaceSource> stack_;  // the lists of the cell and of those that contain it
  std::vector<Vec2> found_, solved_;
  int cells_ = 0;
};

/// Appends the points equally far from a source of each of three generators, along straight lines from the images: two
/// at most for each triple. They are exact to rounding, or to half of the digits where two rays touch.
/// Cost: O(product of the numbers of sources).
void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points);

}  // namespace gvd
