#pragma once

// The same surface with other triangles, for tables 1 to 5.
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gvd/mesh.hpp"

namespace gvd::paper {

/// A model of the paper, and what may stand for it.
struct Wanted {
  std::string model;               ///< the paper's name
  int faces = 0;                   ///< the paper's number; 0 for the mesh as it is
  std::vector<std::string> files;  ///< names without extension, the best first
};

struct FoundMesh {
  std::string name;  ///< what the mesh is: its file, and whether it is resampled
  Mesh mesh;
};

/// The meshes at hand: those of the folders, and data/figure.obj, which stands for every model that is not there.
class Models {
 public:
  /// `scale` multiplies the paper's numbers of faces, > 0: less than 1 for tests.
  Models(std::vector<std::string> folders, double scale) : folders_(std::move(folders)), scale_(scale) {}

  /// The first file of `wanted` that a folder has, resampled if its number of faces differs by more than
  /// kFacesTolerance. Meshes with a boundary are never resampled. Throws Error if a file is no mesh.
  FoundMesh find(const Wanted& wanted) const;

 private:
  std::string find_path(const Wanted& wanted) const;

  std::vector<std::string> folders_;
  double scale_;
};

/// Makes a mesh of one surface with edges of about this length, mesh units.
using Remesher = std::function<Mesh(double edge_length)>;

/// A mesh of `faces` faces of a surface with this area: calls the remesher with one length after the other, until the
/// number is met within kFacesTolerance, or kMostTries are over; then the nearest one.
Mesh search_edge_length(const Remesher& remesh, double area, int faces);

inline constexpr double kFacesTolerance = 0.03;  ///< a fraction of the number of faces
inline constexpr int kMostTries = 10;

/// A closed mesh of near-equilateral triangles, with vertices on the surface of `mesh`. Source: Botsch and Kobbelt, A
/// remeshing approach to multiresolution modeling, 2004. Sharp edges are rounded off. The number of faces is searched
/// by `search_edge_length`. Throws Error{precondition} if `mesh` has a boundary.
Mesh resample(const Mesh& mesh, int faces);

/// Whether this build has CGAL's GPL-licensed remeshing.
bool has_cgal_remeshing();

/// A closed mesh of `faces` near-equilateral triangles, by `search_edge_length` and CGAL's
/// Polygon_mesh_processing::isotropic_remeshing, which is under the GPL. Vertices lie on the surface of `mesh`. Throws
/// Error{precondition} if `mesh` has a boundary, or in a build without CGAL.
Mesh remesh_with_cgal(const Mesh& mesh, int faces);

/// The mesh with some of its edges collapsed, by the least quadric error first, until it has about `faces` faces.
/// Vertices of the result are vertices of the input. A collapse that turns a normal by more than 60 degrees is left
/// out.
///
/// Source: Garland and Heckbert, Surface simplification using quadric error metrics, 1997; OpenMesh's decimater.
/// Triangles of the result have worse shapes than those of an isotropic remeshing, as decimated scans do.
Mesh decimate(const Mesh& mesh, int faces);

/// The same faces with vertices moved towards random neighbours, until `percent_below_30` of all triangles have an
/// angle below 30 degrees or kMostJitterRounds are over. A move that turns a normal by more than 60 degrees, or that
/// makes a triangle of Q below 0.1, is left out. Equal seeds give equal meshes.
Mesh jitter(const Mesh& mesh, double percent_below_30, std::uint64_t seed);

inline constexpr std::size_t kMostJitterRounds = 20;

/// The unit sphere, as an icosahedron with every face cut in four `subdivisions` times: 20 * 4^subdivisions faces.
Mesh make_icosphere(int subdivisions);

}  // namespace gvd::paper
