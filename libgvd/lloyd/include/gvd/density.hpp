#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gvd/ids.hpp"
#include "gvd/mesh.hpp"
#include "gvd/soup.hpp"

namespace gvd {

/// A positive weight of the points of a surface, linear in each face. Where it is larger, cells become smaller: the
/// cells of a minimum of the energy have about equal shares of it, so that their sizes go with density^(-1/4).
struct Density {
  IdVector<FaceId, std::array<double, 3>> corners;  ///< empty: 1 everywhere

  bool is_uniform() const { return corners.empty(); }
  /// At a point of a face, by its barycentric coordinates.
  double at(FaceId face, const std::array<double, 3>& bary) const {
    if (is_uniform()) return 1;
    const auto& [a, b, c] = corners[face];
    return bary[0] * a + bary[1] * b + bary[2] * c;
  }
};

/// The density with a value at each vertex, linear in the faces. Throws Error{precondition} where the number of values
/// is not that of the vertices, or a value is not a finite number > 0 (the message names it). Cost: O(n).
Density make_vertex_density(const Mesh& mesh, const std::vector<double>& values);

/// The density with a value in each face. Throws as `make_vertex_density` does. Cost: O(n).
Density make_face_density(const Mesh& mesh, const std::vector<double>& values);

/// The density that `name` stands for: a file with a number for each vertex, or for each polygon, of the input; else
/// the property of that name of `mesh_file`, a PLY file from which `input` was made (empty: none). Nothing where there
/// is neither. A midpoint of a split edge has the mean of all vertices.
/// Throws Error{unreadable_input} where a file can't be read or has too few or too many numbers, and what
/// make_vertex_density throws, with the name in front. Cost: O(n), and O(bytes) of the file.
std::optional<Density> read_density(const CheckedMesh& input, const std::string& name,
                                    const std::filesystem::path& mesh_file);

/// Throws Error{precondition} if the density is neither uniform nor of the mesh's faces.
void check_density(const Mesh& mesh, const Density& density);

struct CurvatureDensityOptions {
  double gradation = 0.3;  ///< largest change of the size per length along edges, > 0
  double range = 5;        ///< ratio of the largest to the smallest size, >= 1
};

/// The density for cells whose size follows the radius of curvature.
///
/// The curvature of an edge is |(n_j - n_i) . (p_j - p_i)| / |p_j - p_i|^2, with the vertex normals n and the positions
/// p (G. Taubin, Estimating the tensor of curvature of a surface from a polyhedral approximation, 1995). Of a vertex it
/// is the mean over the ring of the largest one at each vertex. Sizes are its inverse, limited to a `range` above their
/// fifth percentile; then no size exceeds that of any other vertex plus `gradation` times their distance along edges.
/// The density is size^-4. It does not depend on the mesh's units.
/// Throws Error{invalid_option} for an option out of its range. Cost: O(n log n).
Density make_curvature_density(const Mesh& mesh, const CurvatureDensityOptions& options = {});

}  // namespace gvd
