#pragma once

#include <array>
#include <map>
#include <vector>

#include "creases/edge_labels.hpp"
#include "gvd/diagram.hpp"
#include "gvd/features.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Shorter parts of a crease between two of its generators, relative to their distance, count as none: cells may touch
/// a crease in a point.
inline constexpr double kLeastForeignPart = 1e-6;

/// Places of new generators are not nearer than this to the ends of their gap, relative to its length.
inline constexpr double kLeastGapShare = 0.05;

/// The edge between consecutive generators of a crease shall not cut off a bend of more degrees: a circle then has nine
/// edges at least. The direction of an arc differs from that of such an edge by half of that at most.
inline constexpr double kLargestBend = 40;

/// A part of a curve that the dual's edges do not follow, or where they cut off a bend.
struct CreaseGap {
  std::vector<SurfacePoint> places;  ///< where generators would help
  double length = 0;                 ///< mesh units; gaps of a curve do not overlap; 0 for a bend
  bool at_corner = false;            ///< the part beside a corner without a generator
  bool waits = false;                ///< for a generator at a corner of the curve, which changes this gap
};

/// Where the dual of a diagram leaves the creases.
///
/// The dual follows a curve of the creases if the cells of any two consecutive generators cover the curve between them.
/// Then these cells share a bisector that crosses the curve there: an edge joins consecutive generators. No other cell
/// contains a point of the curve, so that no edge between generators on the two sides crosses it. The other generators
/// of the curve count as foreign there, too.
///
/// The generators of the ends and of turns have to be at the corners themselves, and a closed curve needs three.
///
/// The place of a generator in each kind of gap:
/// - from a corner without a generator to the first generator of the curve: the corner;
/// - a whole curve that has too few generators: thirds of its length;
/// - beside a corner that a curve of the foreign generator leaves: the point whose distance from the corner is a power
///   of two, and a third to two thirds of the gap;
/// - any other: the point nearest to the foreign generator;
/// - any other, where that point is next to an end (kLeastGapShare): the middle of the foreign parts;
/// - a bend (kLargestBend) of a crease between generators that are farther apart than `spacing`: the middle. Boundaries
///   of scans bend at every scale, so bends of boundaries do not count.
///
/// Opposite generators of two parallel curves do not disturb each other, however close the curves are. Two curves that
/// leave a corner at an acute angle would disturb each other without end, unless their generators are equally far from
/// the corner. Powers of two achieve that.
/// Source: J. Ruppert, A Delaunay refinement algorithm for quality 2-dimensional mesh generation, 1995.
class CreaseGaps {
 public:
  /// The first three must outlive this. `spacing`: that of evenly spread generators, mesh units. Shorter edges may cut
  /// off bends: circles that are small beside the triangles need few edges. Cost: O(n).
  CreaseGaps(const Mesh& mesh, const std::vector<CreaseCurve>& curves, const Diagram& diagram, double spacing);

  /// Those of all curves: at corners first, then the longest first. The sum of their lengths exceeds that of the curves
  /// by rounding at most. Cost: O(k log k) for k labels on creases.
  std::vector<CreaseGap> find() const;

 private:
  struct Mark {
    double at;  // from the curve's first vertex
    GeneratorId generator;
  };
  struct Part {
    double begin, end;
    GeneratorId cell;
  };
  struct Course;
  std::vector<Mark> marks_on(const CreaseCurve& curve) const;
  std::vector<Part> parts_of(const CreaseCurve& curve) const;
  void add_gaps(const Course& course, std::vector<CreaseGap>& gaps) const;
  bool add_corners(const Course& course, std::vector<CreaseGap>& gaps) const;
  CreaseGap whole_curve(const Course& course) const;
  struct Gap;
  static std::vector<Gap> list_gaps(const std::vector<Part>& parts, const std::vector<Mark>& marks);
  VertexId shared_corner(const Course& course, std::size_t i, std::size_t marks, GeneratorId of) const;
  double nearest(const Course& course, double begin, double end, const Vec3& to) const;
  double place_in(const Course& course, const std::vector<Mark>& marks, const Gap& gap) const;
  std::vector<CreaseGap> gaps_between(const Course& course) const;
  bool cuts_off_bend(const Course& course, double begin, double end) const;
  double distance_from_line(const Course& course, double begin, double end, const std::array<Vec3, 2>& line) const;

  const Mesh& mesh_;
  const std::vector<CreaseCurve>& curves_;
  const std::vector<SurfacePoint>& generators_;
  double spacing_;
  EdgeLabels labels_;
  std::map<EdgeId, std::vector<Mark>> on_edge_;  // at parameters along the edge's halfedge
  std::map<VertexId, GeneratorId> at_vertex_;
  std::map<GeneratorId, std::vector<VertexId>> ends_of_curves_;  // of the open curves of each generator
};

}  // namespace gvd
