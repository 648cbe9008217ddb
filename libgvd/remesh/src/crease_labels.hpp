#pragma once

#include <array>
#include <map>
#include <vector>

#include "gvd/diagram.hpp"
#include "gvd/features.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A part of an edge or of a curve that belongs to one cell, as one of the faces there has it.
struct LabelInterval {
  double begin = 0;  ///< parameter along the edge's halfedge `mesh.halfedge(edge)`, or length along the curve
  double end = 1;
  GeneratorId cell;
};

/// Label intervals of whole edges, out of the labels and the pieces of their faces.
class EdgeLabels {
 public:
  /// Both must outlive this. Cost: O(pieces).
  EdgeLabels(const Mesh& mesh, const Diagram& diagram);

  /// The intervals that all faces of the edge have, in no order. The two faces of an inner edge agree, unless a
  /// bisector runs along it. Empty where no generator reaches it. Cost: O(corners of the faces' pieces).
  std::vector<LabelInterval> of(EdgeId edge) const;

 private:
  void append(HalfedgeId h, bool forwards, std::vector<LabelInterval>& labels) const;

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<FaceId, std::size_t> first_piece_;  // of each cut face
};

/// A generator on an edge or a curve, at a parameter or a length as in LabelInterval.
struct GeneratorOnCurve {
  double at = 0;
  GeneratorId generator;
};

/// A curve with the generators and the label intervals on it, by length from its first vertex.
struct LabelledCurve {
  const Mesh& mesh;
  const CreaseCurve& curve;
  std::vector<double> vertex_at;             ///< length at each of the curve's vertices
  std::vector<GeneratorOnCurve> generators;  ///< ascending; one at the ends of a closed curve is at its beginning
  std::vector<LabelInterval> labels;
  bool begins_at_generator = false, ends_at_generator = false;  ///< whether its first, its last vertex is one

  double length() const { return vertex_at.back(); }
  /// Whether a curve that ends where it begins has fewer than three generators.
  bool has_too_few() const;
  /// The generators of a curve; those of a closed one with the first one again at the end.
  std::vector<GeneratorOnCurve> closed_generators() const;
  /// The label intervals of a curve; those of a closed one for a second way round, too.
  std::vector<LabelInterval> repeated_labels() const;
  /// The point at a length; on a closed curve, the length may belong to a second way round here and below.
  SurfacePoint point(double at) const;
  /// The length, from `begin` to `end`, at which the curve is nearest to a point.
  double find_nearest(double begin, double end, const Vec3& to) const;
  /// The largest distance of the curve's vertices between two lengths from the line through two points.
  double largest_distance(double begin, double end, const std::array<Vec3, 2>& line) const;

 private:
  /// The length at the k-th vertex.
  double at(std::size_t k) const;
  /// The first vertex after a length.
  std::size_t first_after(double length) const;
};

/// Labels curves by a diagram. Curves and mesh must outlive the result. Cost: O(n), and O(k log k) for k labels.
std::vector<LabelledCurve> label_curves(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                        const Diagram& diagram);

}  // namespace gvd
