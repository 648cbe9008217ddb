#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_curve.hpp"
#include "gvd/mesh.hpp"
#include "gvd/progress.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// A point that becomes a vertex: a generator or a point of a curve. Without curves, points and generators have the
/// same numbers.
using PointId = Id<struct PointTag>;

/// A point on an edge: (1 - t) from(halfedge) + t to(halfedge), where `halfedge` is the first halfedge of the edge.
struct PointOnEdge {
  HalfedgeId halfedge;
  double t;  ///< in ]0, 1[
  PointId point;
};

/// Points, sorted by the kind of element on which they lie.
struct SortedPoints {
  std::vector<std::pair<VertexId, PointId>> on_vertices;  ///< ascending by point
  std::vector<PointOnEdge> on_edges;                      ///< ascending by (halfedge, t, point)
  std::map<FaceId, std::vector<PointId>> in_faces;        ///< per face ascending by point
};

/// Sorts the points. Throws Error{precondition} if there is no point or the face of a point does not exist. Cost: O(n
/// log n).
SortedPoints sort_points(const Mesh& mesh, const std::vector<SurfacePoint>& points);

/// The generators of a working mesh that are curves: chains of its edges.
struct CurveEdges {
  std::vector<std::pair<VertexId, GeneratorId>> vertices;  ///< the vertices of all curves, each once; ascending
  std::vector<HalfedgeId> edges;  ///< one halfedge of each edge, ascending; both ends lie on the same curve

  bool empty() const { return vertices.empty(); }
};

/// A copy of a mesh in which every generator is a vertex, or a chain of edges.
///
/// Generators inside a face or on an edge split it. The surface itself does not change. So every generator has a
/// vertex, no cell lies entirely inside a face, and the labels on the boundary of a face determine the cells inside it.
/// If all generators lie on vertices, the input itself is used and no mesh is copied. In any case the working mesh
/// refers to the input, which must outlive it.
class WorkingMesh {
 public:
  /// Inserts generators that are points. Throws Error{precondition} if the face of a generator does not exist or two
  /// generators coincide; the message names both. Reports the step "working mesh". Cost: O(n) for the copy; k
  /// generators in one face cost O(k^2) at worst.
  WorkingMesh(const Mesh& input, const std::vector<SurfacePoint>& generators, const Progress& progress = {});
  /// The same, and an error of generators that coincide is returned.
  static OrError<WorkingMesh> try_to_build(const Mesh& input, const std::vector<SurfacePoint>& generators,
                                           const Progress& progress = {});
  /// Inserts generators that are curves. A curve that crosses itself gets a vertex at the crossing. Throws as the other
  /// constructor does, also if two curves touch or cross, and throws what `check_curves` throws.
  WorkingMesh(const Mesh& input, const std::vector<GeneratorCurve>& curves, const Progress& progress = {});

  const Mesh& mesh() const { return split_ ? copy_ : *input_; }
  const Mesh& input() const { return *input_; }
  VertexId vertex(GeneratorId g) const { return generator_vertex_[g]; }
  /// The generator at vertex v of mesh(); invalid if there is none.
  GeneratorId generator(VertexId v) const { return vertex_generator_[v]; }
  /// The vertex of each generator; for a curve, the vertex of its first point.
  const IdVector<GeneratorId, VertexId>& generator_vertices() const { return generator_vertex_; }
  /// The generators that are curves; empty if all generators are points. A curve of a single point counts as a point.
  const CurveEdges& curves() const { return curves_; }

  /// The input's face that contains face f of mesh().
  FaceId parent(FaceId f) const { return split_ ? parent_[f] : f; }
  bool is_split(FaceId f) const { return split_ && child_slot_[f] >= 0; }
  /// The corners of f in the barycentric coordinates of parent(f).
  const std::array<Bary, 3>& corners(FaceId f) const {
    return is_split(f) ? child_corners_[child_slot_[f]] : kWholeTriangle;
  }

  /// Barycentric coordinates in parent(f) of a point of f.
  Bary parent_bary(FaceId f, const Bary& bary) const { return is_split(f) ? compose(corners(f), bary) : bary; }

 private:
  using Corners = std::array<Bary, 3>;

  WorkingMesh(const Mesh& input, std::size_t generators);
  void insert(const std::vector<SurfacePoint>& points, const Progress& progress);
  void copy_input();
  void insert_on_edges(const std::vector<PointOnEdge>& points, const Progress& progress);
  void insert_in_face(FaceId parent, const std::vector<PointId>& ids, const std::vector<SurfacePoint>& points,
                      const Progress& progress);
  /// Where a point lies among the children of its face.
  struct Location {
    FaceId child;
    Bary bary{};                   // in the child
    double smallest = -kInfinity;  // of the coordinates; < 0 if rounding puts the point outside
  };
  Location locate(const std::vector<FaceId>& children, const Bary& bary) const;
  bool splits_edge(HalfedgeId side, const Vec3& p, const Bary& bary) const;
  void insert_point(std::vector<FaceId>& children, PointId id, const SurfacePoint& point);
  VertexId vertex_at(const Mesh& mesh, const Vec3& p, HalfedgeId h) const;
  HalfedgeId find_copied(HalfedgeId h) const;
  std::vector<FaceId> split_edge(HalfedgeId h, PointId id, const Vec3& p, const Bary& here, const Bary& there);
  std::pair<FaceId, FaceId> split_face(FaceId f, PointId id, const Vec3& p, const Bary& bary);
  void make_delaunay(const std::vector<FaceId>& children);
  struct Quadrilateral;
  std::optional<Quadrilateral> quadrilateral(HalfedgeId h) const;
  void flip(HalfedgeId h, const Quadrilateral& quad);
  bool flip_if_convex(HalfedgeId h);
  bool flip_if_not_delaunay(HalfedgeId h);
  void set_corners(FaceId f, FaceId parent, const Corners& corners);
  void claim(VertexId v, PointId point);
  void claim_for(VertexId v, GeneratorId g);
  void check_inserted();
  void report_inserted(const Progress& progress);

  friend class CurveInsertion;  // turns the segments of curves into edges

  const Mesh* input_;
  bool split_ = false;
  Mesh copy_;
  IdVector<FaceId, FaceId> parent_;
  IdVector<FaceId, std::int32_t> child_slot_;  // into child_corners_; -1 for a face that is not split
  std::vector<Corners> child_corners_;
  IdVector<PointId, GeneratorId> owner_;      // the generator of each point; empty if each point is a generator
  IdVector<PointId, VertexId> point_vertex_;  // only with curves
  CurveEdges curves_;
  IdVector<GeneratorId, VertexId> generator_vertex_;
  IdVector<VertexId, GeneratorId> vertex_generator_;
  double coincidence_ = 0;           // mesh units
  std::size_t inserted_ = 0;         // generators inserted so far, without those on vertices
  std::optional<Error> coincident_;  // the first two generators that coincide: then this is no working mesh
};

/// A point by its barycentric coordinates in a triangle, and how far it lies outside the triangle.
struct PlacedInTriangle {
  Bary local{};
  double outside = 0;
};

/// Finds the faces of a working mesh in each face of the input that it splits.
class SplitFaces {
 public:
  struct Part {
    FaceId parent, face;          // in the input, in the working mesh
    std::array<Bary, 3> corners;  // in the parent
  };

  /// Cost: O(n), and O(k log k) for k parts.
  explicit SplitFaces(const WorkingMesh& working) {
    for (const FaceId face : working.mesh().faces()) {
      if (working.is_split(face)) parts_.push_back({working.parent(face), face, working.corners(face)});
    }
    std::ranges::sort(parts_, {}, [](const Part& part) { return std::pair(part.parent, part.face); });
  }

  /// The parts of a face of the input, ascending by face; none if the face is not split. Cost: O(log k).
  std::span<const Part> parts_of(FaceId parent) const {
    return {std::to_address(std::ranges::lower_bound(parts_, parent, {}, &Part::parent)),
            std::to_address(std::ranges::upper_bound(parts_, parent, {}, &Part::parent))};
  }

 private:
  std::vector<Part> parts_;  // ascending by parent and face
};

/// Finds the part in which a point of the parent lies, and the point's coordinates there. `place(corners)` returns a
/// PlacedInTriangle, and the first part for which the point is least outside wins. The face of the result is invalid if
/// `outside` is NaN or infinite for all parts.
template <class Place>
SurfacePoint locate_in_parts(std::span<const SplitFaces::Part> parts, Place place) {
  SurfacePoint best;
  double least = kInfinity;
  for (const SplitFaces::Part& part : parts) {
    const PlacedInTriangle placed = place(part.corners);
    if (!(placed.outside < least)) continue;
    least = placed.outside;
    best = {part.face, placed.local};
  }
  return best;
}

}  // namespace gvd
