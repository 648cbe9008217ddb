// Computes the shares of the cells in cut faces from the areas of the diagram's pieces.
//
// A piece is a polygon in barycentric coordinates, so that its area relative to the face needs no positions. Pieces of
// the same cell in the same face are added up in the order of the diagram. The list is sorted twice: first by face and
// generator to unite the pieces, then by face and descending fraction. Both sorts are stable, so that the sums do not
// depend on
// the sorting.
#include "face_shares.hpp"

#include <utility>

#include "gvd/error.hpp"

namespace gvd {

double fraction_of(std::span<const FaceShare> shares, GeneratorId generator) {
  for (const FaceShare& share : shares) {
    if (share.generator == generator) return share.fraction;
  }
  return 0;
}

FaceShares::FaceShares(const Diagram& diagram) {
  std::vector<FaceShare> pieces;
  for (const FacePiece& piece : diagram.pieces) {
    pieces.push_back({piece.face, piece.generator, compute_area_fraction(piece)});
  }
  std::ranges::stable_sort(pieces, {}, [](const FaceShare& s) { return std::pair(s.face, s.generator); });
  for (const FaceShare& piece : pieces) {
    if (!shares_.empty() && shares_.back().face == piece.face && shares_.back().generator == piece.generator) {
      shares_.back().fraction += piece.fraction;
    } else {
      shares_.push_back(piece);
    }
  }
  std::ranges::stable_sort(shares_, {}, [](const FaceShare& s) { return std::pair(s.face, -s.fraction); });
}

void check_belongs(const Mesh& mesh, const Diagram& diagram) {
  const auto is_face = [&](FaceId f) { return f.valid() && f.value() < mesh.face_count(); };
  const auto is_label = [&](GeneratorId g) { return !g.valid() || g.index() < diagram.generators.size(); };
  const auto is_point = [&](const SurfacePoint& point) { return is_face(point.face); };
  const auto is_piece = [&](const FacePiece& piece) {
    return is_face(piece.face) && piece.generator.valid() && is_label(piece.generator);
  };
  if (diagram.face_label.count() == mesh.face_count() && std::ranges::all_of(diagram.face_label, is_label) &&
      std::ranges::all_of(diagram.generators, is_point) && std::ranges::all_of(diagram.pieces, is_piece)) {
    return;
  }
  throw Error(ErrorCode::precondition, "the diagram was not made of this mesh; compute it again");
}

}  // namespace gvd
