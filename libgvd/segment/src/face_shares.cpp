#include "face_shares.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "base/barycentric.hpp"
#include "gvd/error.hpp"

namespace gvd {

double compute_area_fraction(const FacePiece& piece) { return std::clamp(area_share(piece.corners), 0.0, 1.0); }

FaceShares::FaceShares(const Diagram& diagram) {
  for (const FacePiece& piece : diagram.pieces) {
    shares_.push_back({piece.face, piece.generator, compute_area_fraction(piece)});
  }
  std::stable_sort(shares_.begin(), shares_.end(), [](const FaceShare& a, const FaceShare& b) {
    return std::tie(a.face, a.generator) < std::tie(b.face, b.generator);
  });
  std::vector<FaceShare> united;
  for (const FaceShare& share : shares_) {
    if (!united.empty() && united.back().face == share.face && united.back().generator == share.generator) {
      united.back().fraction += share.fraction;
    } else {
      united.push_back(share);
    }
  }
  std::stable_sort(united.begin(), united.end(), [](const FaceShare& a, const FaceShare& b) {
    return a.face != b.face ? a.face < b.face : a.fraction > b.fraction;
  });
  shares_ = std::move(united);
}

std::span<const FaceShare> FaceShares::of(FaceId face) const {
  const auto [first, last] = std::equal_range(shares_.begin(), shares_.end(), FaceShare{face, {}, 0},
                                              [](const FaceShare& a, const FaceShare& b) { return a.face < b.face; });
  return {first, last};
}

double FaceShares::fraction(FaceId face, GeneratorId generator) const {
  for (const FaceShare& share : of(face)) {
    if (share.generator == generator) return share.fraction;
  }
  return 0;
}

void check_belongs(const Mesh& mesh, const Diagram& diagram) {
  const auto faces = static_cast<std::size_t>(mesh.face_count());
  const auto known = [&](GeneratorId g) { return !g.valid() || g.index() < diagram.generators.size(); };
  bool good =
      diagram.face_label.size() == faces && std::all_of(diagram.face_label.begin(), diagram.face_label.end(), known);
  for (const SurfacePoint& point : diagram.generators) good = good && point.face.valid() && point.face.index() < faces;
  for (const FacePiece& piece : diagram.pieces) {
    good =
        good && piece.face.valid() && piece.face.index() < faces && piece.generator.valid() && known(piece.generator);
  }
  if (!good) throw Error(ErrorCode::precondition, "the diagram was not made of this mesh; compute it again");
}

}  // namespace gvd
