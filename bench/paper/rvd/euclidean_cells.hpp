#pragma once

#include <array>
#include <span>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "pieces/clip_polygon.hpp"

namespace gvd::paper {

/// Cells by straight distances in space, face by face: what RVD and LRVD clip with.
class EuclideanCells {
 public:
  /// Both must outlive this. `positions`: of the generators, mesh units.
  EuclideanCells(const Mesh& mesh, const std::vector<Vec3>& positions) : mesh_(mesh), positions_(positions) {}

  /// |p - b|^2 - |p - a|^2 at the corners of a face: > 0 where a is nearer. It is linear, and 0 in the bisector plane.
  /// Swapping a and b negates it exactly, so that both cells are clipped at the same line.
  LinearForm bisector_form(FaceId f, GeneratorId a, GeneratorId b) const;

  /// The part of a polygon of face f that is nearer to g than to the other generators; g itself is left out. Where two
  /// are equally near to the whole polygon, the lower one has it.
  Polygon clip(FaceId f, Polygon polygon, GeneratorId g, std::span<const GeneratorId> others) const;

  double squared_distance(const Vec3& p, GeneratorId g) const { return (p - positions_[g.index()]).squaredNorm(); }

 private:
  const Mesh& mesh_;
  const std::vector<Vec3>& positions_;
};

}  // namespace gvd::paper
