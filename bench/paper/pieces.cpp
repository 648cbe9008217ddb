// Pieces of faces: convex polygons, cut by linear functions, and the lines along which two pieces touch.
//
// Polygons have barycentric coordinates in their face. Clipping keeps points on the face's sides exactly there, so that
// pieces of adjacent faces meet. A side that lies on an edge of the mesh touches those that the other face has on this
// edge; all other sides touch sides of their own face. Contacts ascend by face, and those across edges follow by edge.
//
// Source: Sutherland and Hodgman, Reentrant polygon clipping, 1974. Values of a linear form that rounding can't tell
// from zero are zero: a line through a corner then cuts no sliver off. A cut of two cells uses one form and its
// negative, so that the two parts cover the polygon and share the two points of the cut, bit by bit.
#include "pieces.hpp"

#include <algorithm>
#include <cmath>

#include "base/barycentric.hpp"

namespace gvd::paper {

double evaluate(const LinearForm& form, const Bary& bary) {
  const double value = interpolate(bary, form[0], form[1], form[2]);
  const double scale = std::max({std::abs(form[0]), std::abs(form[1]), std::abs(form[2])});
  return std::abs(value) <= kZeroValue * scale ? 0 : value;
}

Polygon clip_polygon(const Polygon& polygon, const LinearForm& form, bool keep_zero) {
  std::vector<double> values;
  for (const Bary& corner : polygon) values.push_back(evaluate(form, corner));
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  if (values.empty() || *least > 0) return polygon;
  if (*most == 0) return *least == 0 && keep_zero ? polygon : Polygon();
  if (*most < 0) return {};
  if (*least == 0) return polygon;
  Polygon kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const std::size_t j = (i + 1) % polygon.size();
    if (values[i] >= 0) kept.push_back(polygon[i]);
    if (values[i] * values[j] < 0) kept.push_back(mix(polygon[i], polygon[j], values[i] / (values[i] - values[j])));
  }
  return kept;
}

namespace {

/// A side of a piece: the piece is on its left.
struct Side {
  std::int32_t piece;
  Bary begin, end;
};

/// The corner of the face whose halfedge carries the side, or -1 for a side inside of the face.
int carrying_corner(const Side& side) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (side.begin[i] == 0 && side.end[i] == 0) return static_cast<int>((i + 1) % 3);
  }
  return -1;
}

/// The part of one side that runs along another one in the opposite direction; whether there is one.
bool find_common_part(const Side& side, const Side& other, Contact& contact) {
  const Vec2 origin = affine_point(side.begin), along = affine_point(side.end) - origin;
  const double length = along.norm();
  if (!(length > kLeastContact)) return false;
  const Vec2 from = affine_point(other.end) - origin, to = affine_point(other.begin) - origin;
  if (std::abs(cross(along, from)) > kLeastContact * length) return false;
  if (std::abs(cross(along, to)) > kLeastContact * length) return false;
  const double first = from.dot(along) / (length * length), last = to.dot(along) / (length * length);
  const double begin = std::max(0.0, first), end = std::min(1.0, last);
  if ((end - begin) * length <= kLeastContact) return false;
  contact.left = side.piece;
  contact.right = other.piece;
  contact.begin = begin == 0 ? side.begin : other.end;
  contact.end = end == 1 ? side.end : other.begin;
  return true;
}

class ContactFinder {
 public:
  ContactFinder(const Mesh& mesh, const Pieces& pieces)
      : mesh_(mesh), pieces_(pieces), border_(mesh.halfedge_count()) {}

  std::vector<Contact> find() {
    for (std::size_t i = 0; i < pieces_.size();) {
      inner_.clear();
      const FaceId f = pieces_[i].face;
      for (; i < pieces_.size() && pieces_[i].face == f; ++i) add_sides(static_cast<std::int32_t>(i));
      find_in_face(f);
    }
    for (const EdgeId e : mesh_.edges()) find_across(mesh_.halfedge(e));
    return std::move(contacts_);
  }

 private:
  void add_sides(std::int32_t index) {
    const FacePiece& piece = pieces_[index];
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
      const Side side{index, piece.corners[i], piece.corners[(i + 1) % piece.corners.size()]};
      const int corner = carrying_corner(side);
      (corner < 0 ? inner_ : border_[Mesh::halfedge(piece.face, corner)]).push_back(side);
    }
  }

  void find_in_face(FaceId f) {
    Contact contact{0, 0, f, {}, {}};
    for (std::size_t i = 0; i < inner_.size(); ++i) {
      for (std::size_t j = i + 1; j < inner_.size(); ++j) {
        if (inner_[i].piece == inner_[j].piece || !find_common_part(inner_[i], inner_[j], contact)) continue;
        contacts_.push_back(contact);
      }
    }
  }

  /// A side on the halfedge's edge, as the face of h sees it.
  static Side seen_across(HalfedgeId h, HalfedgeId twin, const Side& side) {
    const auto seen = [&](const Bary& bary) {
      const int i = Mesh::corner(twin), j = Mesh::corner(h);
      Bary result{0, 0, 0};
      result[j] = bary[(i + 1) % 3];
      result[(j + 1) % 3] = bary[i];
      return result;
    };
    return {side.piece, seen(side.begin), seen(side.end)};
  }

  void find_across(HalfedgeId h) {
    const HalfedgeId twin = mesh_.twin(h);
    if (!twin.valid()) return;
    Contact contact{0, 0, Mesh::face(h), {}, {}};
    for (const Side& other : border_[twin]) {
      const Side seen = seen_across(h, twin, other);
      for (const Side& side : border_[h]) {
        if (find_common_part(side, seen, contact)) contacts_.push_back(contact);
      }
    }
  }

  const Mesh& mesh_;
  const Pieces& pieces_;
  IdVector<HalfedgeId, std::vector<Side>> border_;  // the sides on each halfedge
  std::vector<Side> inner_;                         // the other sides of the current face
  std::vector<Contact> contacts_;
};

}  // namespace

std::vector<Contact> find_contacts(const Mesh& mesh, const Pieces& pieces) {
  return ContactFinder(mesh, pieces).find();
}

Pieces take_to_input(const WorkingMesh& working, Pieces pieces) {
  for (FacePiece& piece : pieces) {
    for (Bary& corner : piece.corners) corner = working.parent_bary(piece.face, corner);
    piece.face = working.parent(piece.face);
  }
  std::ranges::stable_sort(pieces, {}, &FacePiece::face);
  return pieces;
}

}  // namespace gvd::paper
