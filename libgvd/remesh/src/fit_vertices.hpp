#pragma once

#include <Eigen/Core>
#include <vector>

#include "cell_quadrics.hpp"
#include "gvd/closest_point.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// The position at which a vertex has better triangles, and the direction across them.
struct VertexShape {
  Vec3 position;
  Vec3 normal;  ///< of its faces by their areas; zero where they have none
};

/// The positions at which the vertices would have better triangles.
///
/// For each face of a vertex, take the equilateral triangle over the opposite edge, in the plane of the face. The
/// position is the weighted mean of the apexes of these triangles; a vertex without faces stays. The weight of a face
/// is the reciprocal of its quality 4 sqrt(3) area / (sum of square edge lengths), so that bad triangles improve first.
/// Moving all vertices there is one Jacobi step of a smoothing. Cost: O(n).
std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh);

/// The freedom of a vertex in the rounds of a fit.
enum class VertexRole : char {
  free,         ///< goes along the surface to where its triangles are good
  near_crease,  ///< a neighbour of vertices at creases: nothing but the samples moves it along the surface
  at_crease,    ///< goes across the crease to where its triangles meet it
  held,         ///< stays where the rounds begin: at its generator if fixed, else at the boundary's quadric minimum
};

/// The data that the springs of the vertices depend on, besides their positions.
struct SpringPlan {
  const Mesh* remesh = nullptr;  ///< with its vertices at the generators
  IdVector<GeneratorId, CreaseCell> creases;
  std::vector<VertexRole> roles;
  std::vector<double> areas;  ///< of the cells, > 0, square mesh units
  double stiffness = 1;       ///< factor of the springs along the surface, > 0
};

/// The freedom of each vertex: held ones, ones at creases, their neighbours, and the rest. Cost: O(n).
std::vector<VertexRole> find_vertex_roles(const Mesh& remesh, const IdVector<GeneratorId, CreaseCell>& creases,
                                          const std::vector<char>& held);

/// A spring that holds a vertex near a position, in each direction with a strength of its own.
struct VertexAnchor {
  Vec3 position;
  Eigen::Matrix3d weight = Eigen::Matrix3d::Zero();  ///< square mesh units, positive definite
};

/// The springs for a round of the fit that starts with the vertices of `current`. Cost: O(n).
std::vector<VertexAnchor> make_springs(const Mesh& current, const SpringPlan& plan);

/// A point of a surface that stands for a part of it.
struct AreaSample {
  Vec3 position;
  Vec3 normal;  ///< of the face
  FaceId face;
  double area = 0;  ///< square mesh units
};

/// Cuts each face into equal triangles, about `count` in all and at least one for each face, and returns their
/// centroids. Cost: O(n + count).
std::vector<AreaSample> sample_surface(const Mesh& mesh, double count);

/// Reduces samples to at most `most`. Each of the result stands for consecutive samples with an equal share of the
/// area, or for a single sample with a larger one. Samples without area are all kept. Deterministic. Cost: O(n).
std::vector<AreaSample> thin_out(std::vector<AreaSample> samples, double most);

/// The surface that a mesh is fitted to.
struct FitTarget {
  const Mesh* surface = nullptr;
  const ClosestPointTree* tree = nullptr;  ///< of the surface
  std::vector<AreaSample> samples;         ///< of the surface
  double count = 0;                        ///< of samples of the mesh
  int threads = 0;
  Progress progress = {};  ///< may be empty
};

/// The square distances of the samples at one face of a mesh, as a function of the moves x of its three corners: x'
/// matrix x - 2 right' x plus a constant.
struct FaceSystem {
  using Block = Eigen::Matrix<double, 9, 9>;
  using Column = Eigen::Matrix<double, 9, 1>;
  Block matrix = Block::Zero();
  Column right = Column::Zero();
};
using FaceSystems = IdVector<FaceId, FaceSystem>;

/// The square distances of samples of a surface from a mesh, and of samples of the mesh from the surface.
///
/// The distance of a sample from its closest point is replaced by the distance from a plane through one of the two,
/// normal to the direction to the other: the plane of a triangle, or one that touches an edge or a vertex. Closest
/// points are found before the moves. Pairs of faces that face in opposite directions do not count, because they belong
/// to different sheets. Cost: O(n log n).
FaceSystems find_face_systems(const Mesh& remesh, const FitTarget& target);

/// The vertex positions with the least sum of the square distances of `systems` and the energy of the springs,
/// `anchors`, one for each vertex. If the system can't be solved, the vertices stay where they are. `progress` is told
/// of the step "fit"; it may be empty. Cost: a sparse Cholesky factorisation.
std::vector<Vec3> fit_vertices(const Mesh& remesh, const FaceSystems& systems, const std::vector<VertexAnchor>& anchors,
                               const Progress& progress = {});

}  // namespace gvd
