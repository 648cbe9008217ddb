#pragma once

#include <numbers>
#include <optional>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/exact_field.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// An inner vertex is a tip if its total angle, in radians, is below this. At a larger angle one generator can't
/// surround a vertex: its bisector with the vertex does not close.
inline constexpr double kTipAngle = std::numbers::pi;

/// Total angle of the faces round a vertex, radians. Cost: O(degree).
double total_angle(const Mesh& mesh, VertexId v);

/// A tip with a cell round it where the surface is too narrow for three generators.
struct NarrowTip {
  VertexId tip;
  double angle = 0;           ///< total angle, radians
  double least_distance = 0;  ///< from the tip, mesh units: farther away there is room for three generators
};

/// Finds generators that divide a cell round a tip.
///
/// On a cone of total angle a, let b < a / 2 be the angle between two generators. The one at distance r from the tip
/// shuts the other one out if that is farther from the tip than r / cos(b). Points on the shortest loop round the tip
/// lie just that far, because the loop is a straight line. So each generator there shuts the others out, and repairs
/// there go on without end, each at half the distance of the one before. Three points at the same distance r, an angle
/// of a / 3 apart, shut no other one out.
class TipRings {
 public:
  /// The mesh and the diagram must outlive the rings. Cost: O(n), and O(m) for each cell that is an annulus, of m
  /// cells; where one surrounds a tip, that of an exact field.
  TipRings(const Mesh& mesh, const Diagram& diagram);

  /// Two points as far from the surrounded tip as the cell's generator is. The three divide the tip's total angle in
  /// parts of at most a half, and lie far apart in space. Empty for a cell that is no annulus or surrounds no tip. Also
  /// empty where a straight line from the tip to a point is not the shortest one: the surface is no cone there.
  std::vector<SurfacePoint> find(GeneratorId cell) const;

  /// The tip that the cell surrounds, if there is no room for three generators on the circle round it through the
  /// cell's generator. The circle is then shorter than three times the least distance between generators
  /// (kMinAddedSpacing). Nearer to the tip there is still less room.
  std::optional<NarrowTip> find_narrow_tip(GeneratorId cell) const;

 private:
  struct Polar {
    GeneratorId source;  // the tip, an index of sources_
    Vec2 tangent;        // at the tip
  };
  std::optional<Polar> locate(GeneratorId cell) const;
  std::optional<SurfacePoint> follow(GeneratorId source, const Vec2& tangent) const;
  std::vector<VertexId> find_tips(GeneratorId annulus, const IdVector<GeneratorId, VertexId>& sharpest) const;
  std::vector<std::vector<GeneratorId>> list_sides(GeneratorId annulus) const;

  const Mesh& mesh_;
  const Diagram& diagram_;
  IdVector<GeneratorId, std::vector<VertexId>> tips_;  // that each annulus surrounds, one a side
  std::vector<VertexId> sources_;                      // the tips of all annuli, ascending
  std::optional<ExactField> field_;                    // distances from sources_
};

}  // namespace gvd
