#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "geodesic/distance_field.hpp"
#include "geodesic/face_layout.hpp"
#include "geodesic/nearest_source.hpp"
#include "geodesic/symbolic_offset.hpp"

namespace gvd {

/// Searches the points of a face that are equally far from three generators. One object is used for many faces, to save
/// allocations.
class EquidistantSearch {
 public:
  /// Returns all candidates in the face, accurate up to rounding, or to half of the digits if two rays touch. The
  /// branch points of the three generators are among them. Most candidates are not branch points, because their rays
  /// don't pass the openings or another source is nearer.
  /// Cost: O(k) memory and mostly O(k log k) time for k sources. The number of cells is bounded, however many paths
  /// tie.
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

  std::vector<FaceSource> stack_;  // the lists of the cell and of the cells that contain it
  std::vector<Vec2> found_, solved_;
  int cells_ = 0;
};

/// Appends the points that are equally far, along straight lines from the images, from a source of each of three
/// generators. There are at most two for each triple. They are exact up to rounding, or to half of the digits if two
/// rays touch.
/// Cost: O(product of the numbers of sources).
void append_equidistant_points(std::span<const FaceSource> a, std::span<const FaceSource> b,
                               std::span<const FaceSource> c, std::vector<Vec2>& points);

/// Unit vector at p, away from `from`; zero if they are the same point.
inline Vec2 direction(const Vec2& p, const Vec2& from) {
  const Vec2 way = p - from;
  const double length = way.norm();
  return length > 0 ? Vec2(way / length) : Vec2(0, 0);
}

/// The distances inside one face from a solver's sources, which are as accurate as the solver. Entering face after face
/// with the same object saves allocations. An object must not be used by several threads at once.
class SourceDistances final : public FaceDistances, public FacePaths {
 public:
  /// `field` must outlive this object.
  explicit SourceDistances(const DistanceField& field) : field_(field) {}

  /// Collects the sources of face f. The functions below are about the face entered last.
  void enter(const Mesh& mesh, FaceId f);
  /// Enters the face of other distances, and adds to every distance the symbolic offset of its generator, so that every
  /// tie inside the face is decided as at the crossings on its edges.
  void enter_with_offsets(const SourceDistances& others, const SymbolicOffset& offset);

  const FaceLayout& layout() const { return *layout_; }
  /// The sources of generator g. Cost: O(log k + sources of g).
  std::span<const FaceSource> sources(GeneratorId g) const { return sources_.of(g); }

  /// The shortest path from generator g to p.
  FaceSource::Path nearest(GeneratorId g, const Vec2& p) const { return gvd::nearest(sources(g), p).path; }
  /// The distance from p to the nearest of all generators.
  double nearest_of_all(const Bary& p) const { return gvd::nearest(sources_.all(), layout_->at(p)).path.distance; }

  std::optional<double> entry(GeneratorId g, const Bary& p) const override;

  /// The distance itself, mesh units.
  double at(GeneratorId g, const Bary& p) const override;
  /// Uses Newton's method with damping on the differences of the distances. Nothing if it does not converge.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const override;
  std::vector<Bary> equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const override;
  double crossing_error(const BoundaryCrossing& crossing) const override;
  /// True for a point inside the face to which no other generator is nearer, with the three directions
  /// counter-clockwise.
  bool is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& p) const override;

 private:
  const DistanceField& field_;
  std::optional<FaceLayout> layout_;
  SourcesByGenerator<FaceSource> sources_;
  std::vector<FaceSource> found_;
  mutable EquidistantSearch search_;  // keeps its memory from face to face
};

}  // namespace gvd
