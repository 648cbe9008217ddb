#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gvd/closest_point.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/placement.hpp"
#include "gvd/self_intersections.hpp"
#include "gvd/surface_point.hpp"

// The steps of place_vertices, in their order: what the cells want, springs, the fit, the angles, the guard.

namespace gvd {

// cell_quadrics.cpp

/// A weighted sum of square distances from planes and lines. As a function of an offset d from a fixed point it is
/// d' matrix d - 2 vector' d, and a constant.
struct Quadric {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
  Vec3 vector = Vec3::Zero();
  double area = 0;  ///< of the faces, square mesh units

  /// Adds a plane through `through`, an offset, with a unit normal.
  void add_plane(const Vec3& normal, const Vec3& through, double weight) {
    matrix += weight * normal * normal.transpose();
    vector += weight * normal.dot(through) * normal;
  }
  /// Adds a line through `through` along a unit vector.
  void add_line(const Vec3& along, const Vec3& through, double weight) {
    const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
    matrix += weight * across;
    vector += weight * across * through;
  }
  /// The least offset among those with the least sum. Directions in which the sum hardly changes are left out: those of
  /// eigenvalues below `truncation` times the largest one. Zero for an empty sum.
  Vec3 minimize(double truncation) const;
};

/// The quadrics of all cells, with offsets from their generators. Planes of faces weigh by their areas in the cell.
/// Lines of boundary edges weigh by their lengths in the cell times the square root of the cell's area. Cost: O(n).
IdVector<GeneratorId, Quadric> compute_cell_quadrics(const Mesh& mesh, const Diagram& diagram);

/// An edge is sharp where the normals of its two faces differ by more than this, degrees.
inline constexpr double kSharpAngle = 40;

/// A cell has a crease if its sharp edges carry at least this share of its bending. Bending is the sum of lengths times
/// angles between normals, over the parts of edges in the cell. On creases of CAD models the share is nearly 1. Noise
/// and folds have sharp edges between others that bend as well.
inline constexpr double kLeastBendingShare = 0.7;

/// Creases go on: smaller groups of neighbouring cells with sharp edges are those of coarse, curved surfaces. Measured
/// with 2000 generators: at most 4 on the elephant and 2 on spot, and 391 on the fandisk. Among few generators an
/// eighth of them is enough.
inline constexpr std::int64_t kLeastCreaseCells = 12;

/// The wishes of the sharp edges and of the boundary for the vertex of a cell.
struct CreaseCell {
  bool is_creased = false;        ///< its triangles should meet a crease, or the boundary while the generator is off it
  Vec3 direction = Vec3::Zero();  ///< unit, along the crease; zero where there is none, or where several meet
  bool is_met = false;            ///< the generator is on a crease: its vertex leaves it for no angle
};

/// The crease cells among all cells. `remesh`: has its vertices at the generators. Cost: O(n log n).
IdVector<GeneratorId, CreaseCell> find_crease_cells(const Mesh& surface, const Diagram& diagram, const Mesh& remesh);

// fit_vertices.cpp

/// A vertex's position of better triangles, and the direction across them.
struct VertexShape {
  Vec3 position;
  Vec3 normal;  ///< of its faces by their areas; zero where they have none
};

/// The positions at which the vertices would have better triangles.
///
/// Each face of a vertex has an edge opposite to it, over which an equilateral triangle in the face's plane stands. The
/// position is the weighted mean of the apexes of these triangles; a vertex without faces stays. A face weighs by the
/// reciprocal of its quality 4 sqrt(3) area / (sum of square edge lengths), so that bad triangles improve first. Moves
/// of a vertex to there are Jacobi steps of a smoothing. Cost: O(n).
std::vector<VertexShape> find_vertex_shapes(const Mesh& mesh);

/// The freedom of a vertex in the rounds of a fit.
enum class VertexRole : char {
  free,         ///< goes along the surface to where its triangles are good
  near_crease,  ///< a neighbour of vertices at creases: nothing but the samples moves it along the surface
  at_crease,    ///< goes across the crease to where its triangles meet it
  held,         ///< stays where the rounds begin: at its generator if fixed, else at the boundary's quadric minimum
};

/// The data that the springs of the vertices depend on, beside their positions.
struct SpringPlan {
  const Mesh* remesh = nullptr;  ///< with its vertices at the generators
  IdVector<GeneratorId, CreaseCell> creases;
  std::vector<VertexRole> roles;
  std::vector<double> areas;  ///< of the cells, > 0, square mesh units
  double stiffness = 1;       ///< factor of the springs along the surface, > 0
};

/// The roles of the vertices: `held` ones, those at creases, their neighbours, and the rest. Cost: O(n).
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

/// Cuts each face into equal triangles, about `count` in all and at least one a face, and gives their centroids. Cost:
/// O(n + count).
std::vector<AreaSample> sample_surface(const Mesh& mesh, double count);

/// At most `most` samples where there are more: each stands for some that follow each other and have an equal share of
/// the area, or for a larger one alone. Samples without area are all kept. Deterministic. Cost: O(n).
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

/// The square distances of the samples at one face of a mesh, as a function of the moves x of its three corners:
/// x' matrix x - 2 right' x, and a constant.
struct FaceSystem {
  using Block = Eigen::Matrix<double, 9, 9>;
  using Column = Eigen::Matrix<double, 9, 1>;
  Block matrix = Block::Zero();
  Column right = Column::Zero();
};
using FaceSystems = IdVector<FaceId, FaceSystem>;

/// The square distances of samples of a surface from a mesh, and of samples of the mesh from the surface.
///
/// A pair of a sample and its closest point counts by a plane through one of them, normal to the direction to the
/// other. It is the plane of a triangle, or one that touches an edge or a vertex. The pairs are those of the mesh
/// before the moves. Pairs of faces that look in opposite directions do not count: they belong to different sheets.
/// Cost: O(n log n).
FaceSystems find_face_systems(const Mesh& remesh, const FitTarget& target);

/// The vertex positions with the least sum of the square distances `systems` and the stretch of the springs. `anchors`:
/// one for each vertex. Gives the positions before where the system can't be solved.
/// `progress`: of the step "fit"; may be empty. Cost: a sparse Cholesky factorisation.
std::vector<Vec3> fit_vertices(const Mesh& remesh, const FaceSystems& systems, const std::vector<VertexAnchor>& anchors,
                               const Progress& progress = {});

// raise_angles.cpp

class MoveGuard;

/// The search of raise_angles, beside the positions that it starts with. All of it must outlive the search.
struct AngleSearch {
  const Mesh* mesh = nullptr;  ///< with the positions that the systems belong to
  const FaceSystems* systems = nullptr;
  const MoveGuard* guard = nullptr;
  const SpringPlan* plan = nullptr;  ///< its held vertices stay
  Progress progress = {};            ///< may be empty
};

/// The price of thin triangles.
struct AnglePrice {
  double angle = 0;   ///< triangles with a smaller one are thin; degrees, > 0
  double weight = 0;  ///< against square distances, each in units of a cell's: 1 is the square of its area
};

/// Passes of raise_angles over the vertices, and places that a vertex tries in one.
inline constexpr int kAnglePasses = 6, kAngleTrials = 32;

/// Moves vertices of thin triangles, one after the other, to where the sum of square distances and the price of thin
/// triangles is smaller.
///
/// A vertex tries eight directions along the surface with steps that get shorter, and keeps the best place. At each it
/// rises or falls to where the square distances are least. A vertex whose generator is on a crease goes along it alone:
/// creases that generators follow (`--features`) stay. The price of a triangle grows with the square of the angle
/// that it lacks. An angle that the guard forbids costs more. Deterministic.
/// Cost: O(n), and O(valence) for each of kAngleTrials places of a vertex with thin triangles, a pass.
std::vector<Vec3> raise_angles(const AngleSearch& search, const AnglePrice& price, std::vector<Vec3> positions);

// place_vertices.cpp

/// The faces of a mesh with other vertex positions. Throws Error{precondition} where an edge has no length.
Mesh with_positions(const Mesh& mesh, std::vector<Vec3> positions);

/// Moves the vertices of a remesh as far as its triangles stay valid.
class MoveGuard {
 public:
  /// `remesh` has its vertices at the generators. What is wrong with it already is no concern of the guard. Both
  /// meshes must outlive it.
  MoveGuard(const Mesh& surface, const Mesh& remesh, const std::vector<SurfacePoint>& generators,
            const std::vector<SurfacePoint>& face_points, const PlacementOptions& options);

  /// Lets the triangles of these vertices have angles down to `least_angle`, degrees: they have to meet creases.
  void loosen(const std::vector<char>& vertices, double least_angle);

  /// The steps from one valid list of positions to another, each halved until all triangles are valid, or left out.
  /// Deterministic: all triangles are tested, then all steps are changed. Cost: O(n log n) a test.
  std::vector<Vec3> move(const std::vector<Vec3>& from, const std::vector<Vec3>& to) const;

  /// The least angle that each triangle may have, degrees.
  const IdVector<FaceId, double>& least_angles() const { return least_angle_; }

  /// The normal of the surface at each triangle, of any length.
  const IdVector<FaceId, Vec3>& normals() const { return normal_; }

 private:
  bool is_bad(FaceId f, const std::vector<Vec3>& positions) const;
  std::vector<FaceId> find_bad_faces(const std::vector<Vec3>& positions) const;
  std::vector<FaceId> find_crossed_faces(const std::vector<Vec3>& positions) const;

  const Mesh& remesh_;
  int threads_;
  Progress progress_;
  IdVector<FaceId, Vec3> normal_;         // of the surface at each face
  IdVector<FaceId, double> least_angle_;  // that each face may have, degrees
  std::vector<FacePair> crossed_before_;
};

}  // namespace gvd
