#pragma once

#include <span>
#include <utility>
#include <vector>

#include "diagram/assembly/face_distances.hpp"
#include "geodesic/field/distance_field.hpp"
#include "geodesic/field/face_layout.hpp"

namespace gvd {

/// Unit vector at p, away from `from`; zero where they are the same.
inline Vec2 direction(const Vec2& p, const Vec2& from) {
  const Vec2 way = p - from;
  const double length = way.norm();
  return length > 0 ? Vec2(way / length) : Vec2(0, 0);
}

/// Whether the path of a source to p is shorter than `best`, which it then replaces.
inline bool take_nearer(const FaceSource& source, const Vec2& p, FaceSource::Path& best) {
  // No path of a source is shorter than the straight one.
  const double rest = best.distance - source.offset;
  if (!(rest > 0) || (p - source.image).squaredNorm() >= rest * rest) return false;
  const auto path = source.shortest_path(p);
  if (!(path.distance < best.distance)) return false;
  best = path;
  return true;
}

/// Distances inside one face, from the sources that a solver knows there: as good as the solver.
class SourceDistances final : public FaceDistances {
 public:
  /// `tie_step`: the symbolic offset between two generators that follow each other, mesh units: as on the edges.
  explicit SourceDistances(const DistanceField& field, double tie_step = 0) : field_(field), tie_step_(tie_step) {}

  /// Makes this the metric of face f.
  void enter(const Mesh& mesh, FaceId f);

  const FaceLayout& layout() const { return *layout_; }
  /// The sources of generator g; the first one is the nearest to the face's centre.
  std::span<const FaceSource> sources(GeneratorId g) const;

  /// The shortest path over some sources, and the one that it comes from; null, and infinite, where there is none.
  struct Nearest {
    const FaceSource* source;
    FaceSource::Path path;
  };
  static Nearest nearest(std::span<const FaceSource> sources, const Vec2& p);
  /// The shortest path from generator g to p.
  FaceSource::Path nearest(GeneratorId g, const Vec2& p) const { return nearest(sources(g), p).path; }
  /// The distance to the nearest of all generators.
  double nearest_of_all(const Bary& p) const { return nearest(sources_, layout_->at(p)).path.distance; }
  Bary bary(const Vec2& p) const;

  /// Whether each generator is behind by its symbolic offset, so that the crossings on the edges and what lies between
  /// them decide every tie alike. Not so where a face has just been entered.
  void set_symbolic_offsets(bool tied);
  /// False makes assembly take every point for a guess.
  void set_can_confirm(bool sure) { can_confirm_ = sure; }
  bool can_confirm() const override { return can_confirm_; }
  std::optional<double> entry(GeneratorId g, const Bary& p) const override;

  /// The distance itself, mesh units.
  double at(GeneratorId g, const Bary& p) const override;
  /// Newton's method on the differences of the distances. Nothing where it does not converge.
  std::optional<Bary> equidistant(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& start) const override;
  std::vector<Bary> equidistant_points(GeneratorId a, GeneratorId b, GeneratorId c) const override;
  double crossing_error(const BoundaryCrossing& crossing) const override;
  /// Inside the face, with no other generator nearer, and the three directions counter-clockwise.
  bool is_branch_point(GeneratorId a, GeneratorId b, GeneratorId c, const Bary& p) const override;

 private:
  void bring_nearest_forward();

  const DistanceField& field_;
  double tie_step_;
  bool can_confirm_ = true, has_offsets_ = false;
  std::optional<FaceLayout> layout_;
  std::vector<FaceSource> sources_;  // by generator
  std::vector<FaceSource> others_;   // the same, tied where these are not, and the other way round; or empty
  std::vector<FaceSource> found_;
  std::vector<std::pair<GeneratorId, std::int32_t>> order_;  // of found_, ascending
};

}  // namespace gvd
