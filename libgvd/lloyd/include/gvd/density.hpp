#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/soup.hpp"

namespace gvd {

struct ElementValues;

/// A positive weight of the points of a surface, linear in each face. Where it is larger, cells become smaller: in a
/// minimum of the energy, the sizes of cells are about proportional to density^(-1/4).
struct Density {
  IdVector<FaceId, std::array<double, 3>> corners;  ///< empty: 1 everywhere

  bool is_uniform() const { return corners.empty(); }
  /// The density at a point of a face, given by barycentric coordinates.
  double at(FaceId face, const std::array<double, 3>& bary) const {
    if (is_uniform()) return 1;
    const auto& [a, b, c] = corners[face];
    return bary[0] * a + bary[1] * b + bary[2] * c;
  }
};

/// Makes a density of a value for each vertex, linear in the faces. Throws Error{precondition} if the number of values
/// is not the number of vertices, or if a value is not a finite number > 0; the message names it. Cost: O(n).
Density make_vertex_density(const Mesh& mesh, const std::vector<double>& values);

/// Makes a density of a value for each face. Throws as `make_vertex_density` does. Cost: O(n).
Density make_face_density(const Mesh& mesh, const std::vector<double>& values);

/// Makes a density of numbers for the elements of the input or of its mesh. The midpoint of a split edge gets the mean
/// of all vertices. Throws what `make_vertex_density` throws, with the title of the numbers in front. Cost: O(n).
Density make_density(const CheckedMesh& input, const ElementValues& given);

/// Reads the density that `name` stands for: a file with a number for each vertex or polygon of the input, or else the
/// property of that name in `mesh_file`, the file from which `input` was made (empty: none). Returns nothing if there
/// is neither. The midpoint of a split edge gets the mean of all vertices. Throws Error{unreadable_input} if a file
/// can't be read or has the wrong number of values, and what `make_vertex_density` throws, with the name in front.
/// Cost: O(n), and O(bytes of the file).
std::optional<Density> read_density(const CheckedMesh& input, const std::string& name,
                                    const std::filesystem::path& mesh_file);

/// Throws Error{precondition} unless the density is uniform or has a value for each corner of the mesh's faces.
void check_density(const Mesh& mesh, const Density& density);

struct CurvatureDensityOptions {
  double gradation = 0.3;  ///< largest change of the size of cells per length along edges, > 0
  double range = 5;        ///< largest ratio of the sizes of two cells, >= 1
  Progress progress;       ///< may be empty
};

/// Makes the density for which a remesh with `count` vertices has a small mean square distance from the surface.
///
/// Sizes of cells are proportional to q^(-1/3), where the mean square distance of a disc of radius R from its best
/// plane is q^2 R^4 / 64. The discs are about as large as the cells of `count` evenly spread generators, so the density
/// depends on the number of generators. No size exceeds the smallest size times `range`, or the size at another vertex
/// plus `gradation` times the distance along edges. The density is (size / even spacing)^-4, so it does not depend on
/// the mesh's units. On a flat surface, and on a surface without area, the density is 1 everywhere, up to rounding.
/// Throws Error{invalid_option} for a count below 1 or an option out of range; Error{interrupted} if the progress
/// callback cancels. Cost: O(n log n).
/// Source: docs/developer/lloyd.md, section 8.
Density make_curvature_density(const Mesh& mesh, std::int64_t count, const CurvatureDensityOptions& options = {});

}  // namespace gvd
