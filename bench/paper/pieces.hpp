#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "comparators.hpp"
#include "gvd/diagram.hpp"
#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"
#include "mesh/working_mesh.hpp"

namespace gvd::paper {

/// A convex polygon in a face: barycentric coordinates of its corners, counter-clockwise.
using Polygon = std::vector<std::array<double, 3>>;

inline Polygon whole_face() { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}; }

/// A linear function in a face: its values at the three corners.
using LinearForm = std::array<double, 3>;

/// Values of a form at or below this fraction of its largest corner value are 0. Dimensionless: a hundred times the
/// rounding error of a sum of three products.
inline constexpr double kZeroValue = 1e-13;

/// The form's value at a point; exactly 0 where rounding leaves the sign open.
double evaluate(const LinearForm& form, const std::array<double, 3>& bary);

/// The part of a convex polygon where the form is >= 0; empty where that part has no interior.
///
/// Source: Sutherland and Hodgman 1974, for one line. Points on a side of the face stay on it exactly.
/// `keep_zero`: what to return where the form is 0 at every corner of the polygon: all of it, or nothing. Of two
/// generators that are equally near to a whole face, one has to have it.
Polygon clip_polygon(const Polygon& polygon, const LinearForm& form, bool keep_zero);

/// Pieces that cover the faces of a mesh, ascending by face. A face that is not cut is one piece. The generator is
/// invalid where no cell owns the piece. Pieces of one face do not overlap.
using Pieces = std::vector<FacePiece>;

/// A line that two pieces have in common: in a face, or on the edge between two faces.
struct Contact {
  std::int32_t left;            ///< index of the piece on the left from `begin` to `end`
  std::int32_t right;           ///< index of the other piece
  FaceId face;                  ///< of the left piece
  std::array<double, 3> begin;  ///< barycentric coordinates in `face`
  std::array<double, 3> end;
};

/// Contacts shorter than this are left out, and lines closer than this are one: relative to the face or edge.
inline constexpr double kLeastContact = 1e-9;

/// All contacts, each once. Cost: O(n + k) for n pieces and k pairs of sides in faces with several pieces.
std::vector<Contact> find_contacts(const Mesh& mesh, const Pieces& pieces);

/// The pieces of a working mesh as pieces of its input, ascending by face. A face that generators have split is cut
/// into pieces of its own, even if they have one label.
Pieces take_to_input(const WorkingMesh& working, Pieces pieces);

/// Smaller components are no islands: a fraction of the mesh's area. Where three generators are equally far from a
/// vertex, rounding leaves its label a triangle of some 1e-12 edges.
inline constexpr double kLeastIsland = 1e-12;

/// The connected components of all cells.
struct CellParts {
  std::vector<std::int32_t> part_of;   ///< [piece] its component, numbered from 0 in the order of their first pieces
  std::vector<GeneratorId> generator;  ///< [component] its label; invalid where no cell owns it
  std::vector<char> has_generator;     ///< [component] whether the generator lies in it
  std::vector<double> area;            ///< [component] square mesh units

  double total_area = 0;  ///< of all components

  /// A component of a cell without its generator, larger than kLeastIsland.
  bool is_island(std::int32_t part) const {
    return generator[part].valid() && has_generator[part] == 0 && area[part] > kLeastIsland * total_area;
  }
};

/// Pieces of one label with a contact belong to one component. Cost: O(pieces + contacts).
CellParts find_cell_parts(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Pieces& pieces,
                          const std::vector<Contact>& contacts);

/// A straight piece of a bisector in one face: from `begin` to `end` the cell `left` is on the left.
struct Segment {
  GeneratorId left, right;
  SurfacePoint begin, end;
};

/// Ends of segments closer than this are one point: a fraction of the bounding box's diagonal.
inline constexpr double kSameEnd = 1e-9;

struct Chains {
  std::vector<Bisector> bisectors;
  std::int64_t open_ends = 0;  ///< points inside the mesh at which a single segment ends
};

/// Joins segments between the same two cells to polylines. A chain ends where other cells are, on the boundary, or
/// where nothing continues it. Cost: O(k log k) for k segments.
Chains chain_segments(const Mesh& mesh, const std::vector<Segment>& segments);

/// Fills the diagram and the faults of a comparison from the pieces that a comparator has made; adds to the faults that
/// it counted itself. A bisector runs wherever pieces of two generators have a contact, along an edge of the mesh too.
/// Nothing is repaired. Cost: O(n + k log k) for n pieces and k segments of bisectors.
void collect_pieces(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Pieces pieces,
                    Comparison& comparison);

}  // namespace gvd::paper
