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

/// The density of numbers for the elements of the input or of its mesh. A midpoint of a split edge has the mean of all
/// vertices. Throws what make_vertex_density throws, with the title of the numbers in front. Cost: O(n).
Density make_density(const CheckedMesh& input, const ElementValues& given);

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
  double gradation = 0.3;  ///< largest change of the size of cells per length along edges, > 0
  double range = 5;        ///< largest ratio of the sizes of two cells, >= 1
  Progress progress;       ///< may be empty
};

/// The density for which a remesh with `count` vertices has a small mean square distance from the surface.
///
/// Sizes of cells go with q^(-1/3), where the mean square distance of a disc of radius R from its best plane is
/// q^2 R^4 / 64. Discs are as large as the cells of `count` evenly spread generators, so the density depends on their
/// number. No size exceeds the smallest one times `range`, nor that of another vertex plus `gradation` times their
/// distance along edges. The density is (size / even spacing)^-4, so it does not depend on the mesh's units. A flat
/// surface has the density 1 everywhere, within rounding; so has one without area.
/// Throws Error{invalid_option} for a count below 1 or an option out of its range; Error{interrupted} if the progress
/// callback cancels. Cost: O(n log n). Source: docs/developer/lloyd.md, section 8.
Density make_curvature_density(const Mesh& mesh, std::int64_t count, const CurvatureDensityOptions& options = {});

}  // namespace gvd
