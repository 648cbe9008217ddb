#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "gvd/dual.hpp"
#include "gvd/remesh.hpp"

namespace gvd {

/// Makes the mesh of a remesh from the generators and the diagram of its result, and finds the defects in the way.
class DualMeshMaker {
 public:
  /// All must outlive this. Each call reads `result.generators`, `result.diagram` and `result.rounds`.
  DualMeshMaker(const Mesh& mesh, const RemeshOptions& options, RemeshResult& result)
      : mesh_(mesh), options_(options), result_(result) {}

  /// Builds the mesh, with its vertices at the generators, and gives the defects of the dual and flipped triangles.
  /// With defects of the dual there is no mesh. Throws Error{no_valid_result} if the triangles are no manifold mesh.
  std::vector<DualDefect> build(const DualMesh& dual);

  /// Moves the vertices as the options say, and gives the triangles that intersect then.
  std::vector<DualDefect> place(const DualMesh& dual);

 private:
  std::vector<DualDefect> find_dual_defects(const DualMesh& dual) const;
  std::vector<DualDefect> find_intersections(const DualMesh& dual) const;
  bool has_coincident_corners(const std::array<GeneratorId, 3>& face) const;
  void build_mesh(const DualMesh& dual);
  DualDefect triangle_defect(const DualMesh& dual, std::size_t face, const std::string& what,
                             DualProperty property = DualProperty::not_flipped) const;

  const Mesh& mesh_;
  const RemeshOptions& options_;
  RemeshResult& result_;
};

}  // namespace gvd
