#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/vec.hpp"

namespace gvd {

/// The angle by which the surface turns at an edge, as it looks at a scale.
struct ScaleAngle {
  double degrees = 0;    ///< 0 where the surface does not turn there, or one side has no voice
  double crispness = 0;  ///< share of the turn of the whole scale that lies within a quarter of it: 1 at a sharp edge
};

/// Measures the angles of edges at a scale.
///
/// The faces around an edge, up to the radius from its midpoint, are shared out between its two sides, each to the side
/// that reaches it first. The angle is that between the sides' mean normals, in which faces count by their area and
/// less with their distance. So slivers have no voice, and a side of slivers alone has none either. Walls are not
/// crossed: they hide what lies behind them.
///
/// Means over half and a quarter of the radius tell a crease from a curved surface. There the angle grows with the
/// radius, so that the line through two angles leads to 0 at radius 0, while a crease keeps its angle.
///
/// Not safe for several threads. Cost: O(k log k) for k faces in the disc, at most kMostFaces; one seventh of that
/// where a quarter of the radius shows that the angle is below `least`.
class AngleAtScale {
 public:
  /// `radius`: mesh units, > 0. `walls`: edges that hide what is behind them, read anew in each measurement. Both the
  /// mesh and the walls have to outlive this. Cost: O(n).
  AngleAtScale(const Mesh& mesh, double radius, const IdVector<EdgeId, bool>& walls);

  /// Whether the two faces of an edge turn at least as fast, by their width, as a curve that makes this angle (degrees)
  /// over the scale. The sharpest edge of each crease does. No boundary edge does, and each edge at a face without
  /// area.
  bool bends(EdgeId e, double angle) const;

  /// Whether an edge that is small for the scale turns as much as the other edges of its two faces. Of the many edges
  /// that see one crease, these are enough to find it. Larger edges count as sharpest, too.
  bool is_sharpest(EdgeId e) const;

  /// The angle at an inner edge. Angles below `least` may be given as 0, and so may those below `beside` within
  /// `kShoulderReach` radii of a wall beside the edge. `beside` = 0: the walls beside it do not matter.
  ScaleAngle measure(EdgeId e, double least, double beside);

  /// How far from a wall, in radii, an edge counts as lying beside it.
  static constexpr double kShoulderReach = 1.5;

 private:
  static constexpr int kLevels = 3;  // the radius, its half and its quarter

  struct FaceSize {
    Vec3 normal = Vec3::Zero();  // of length 1, or 0 where the face has no area
    double longest = 0, height = 0;
  };
  struct Side {
    std::array<Vec3, kLevels> normal{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
    std::array<double, kLevels> weight{};
  };
  struct Entry {
    double distance;
    std::int32_t order;  // of equal distances the first comes first
    FaceId face;
    int side;
  };

  /// The disc around an edge while its two sides grow.
  struct Disc {
    EdgeId edge;
    Vec3 middle, along;  // of the edge
    double reach;
    std::array<Side, 2> sides{};
    int faces = 0;
    bool is_beside_wall = false;
  };

  bool grow(double least, Disc& disc);
  void push_neighbours(const Entry& entry, Disc& disc);
  void push(double distance, FaceId face, int side);
  Entry pop();
  void add(FaceId f, double distance, Side& side) const;
  bool has_voice(const std::array<Side, 2>& sides, int level, bool is_cut_off) const;
  double width(EdgeId e) const;
  static double angle_of(const std::array<Side, 2>& sides, int level);
  bool is_beside(HalfedgeId wall, const Vec3& middle, const Vec3& along, double reach) const;

  const Mesh& mesh_;
  double radius_;
  const IdVector<EdgeId, bool>& walls_;
  IdVector<FaceId, FaceSize> sizes_;
  IdVector<EdgeId, double> turns_;  // between the two faces, degrees; 180 at a face without area, 0 at the boundary
  IdVector<FaceId, std::int32_t> seen_;  // number of the last measurement that took the face
  std::int32_t measurement_ = 0;
  std::vector<Entry> front_;  // a heap
  std::int32_t pushed_ = 0;
};

}  // namespace gvd
