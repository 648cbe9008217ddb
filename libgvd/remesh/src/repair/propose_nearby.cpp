#include "repair/propose_nearby.hpp"

#include <algorithm>
#include <optional>

#include "repair/local_dual.hpp"
#include "repair/propose_generators.hpp"

namespace gvd {
namespace {

/// A part of more than one in so many of the mesh's faces takes as long as a round on the whole mesh, which repairs in
/// all places at once.
constexpr std::size_t kFacesPerPartFace = 4;

/// Repairs that take more rounds are left to rounds on the whole mesh, which are counted and end.
constexpr int kMostRounds = 8;

/// The cells in the faces of the points, ascending.
std::vector<GeneratorId> list_cells_around(const Mesh& mesh, const Diagram& diagram,
                                           const std::vector<SurfacePoint>& points) {
  std::vector<GeneratorId> cells;
  const auto by_face = [](const FacePiece& piece, FaceId f) { return piece.face < f; };
  for (const SurfacePoint& point : points) {
    for (const FaceId f : faces_around(mesh, point)) {
      if (diagram.face_label[f].valid()) cells.push_back(diagram.face_label[f]);
      auto piece = std::lower_bound(diagram.pieces.begin(), diagram.pieces.end(), f, by_face);
      for (; piece != diagram.pieces.end() && piece->face == f; ++piece) cells.push_back(piece->generator);
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// One round on the part: points of the whole mesh, none where nothing is left to repair or the part can't tell.
std::vector<SurfacePoint> propose_in_part(const LocalDual& local, const std::vector<SurfacePoint>& added,
                                          std::size_t max_count) {
  const auto result = local.compute(added);
  if (!result || result->defects.empty()) return {};
  if (result->defects.front().property == DualProperty::not_flipped) return {};
  ProposedGenerators proposed = propose_generators(local.part().mesh(), result->diagram, result->defects, max_count);
  if (proposed.narrow) return {};
  for (SurfacePoint& point : proposed.points) point = local.part().to_whole(point);
  return std::move(proposed.points);
}

}  // namespace

std::vector<SurfacePoint> propose_nearby(const Mesh& mesh, const Diagram& diagram,
                                         const std::vector<SurfacePoint>& added, std::size_t max_count,
                                         const DiagramOptions& options) {
  const LocalDual local(mesh, diagram, list_cells_around(mesh, diagram, added), {}, options);
  if (kFacesPerPartFace * local.part().size() > static_cast<std::size_t>(mesh.face_count())) return {};
  std::vector<SurfacePoint> all = added;
  for (int round = 0; round < kMostRounds && all.size() < added.size() + max_count; ++round) {
    const auto more = propose_in_part(local, all, added.size() + max_count - all.size());
    if (more.empty()) break;
    all.insert(all.end(), more.begin(), more.end());
  }
  all.erase(all.begin(), all.begin() + std::ssize(added));
  return all;
}

}  // namespace gvd
