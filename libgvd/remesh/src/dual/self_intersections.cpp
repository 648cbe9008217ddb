// Pairs of faces of a mesh that intersect, and those that a remesh has from its surface.
//
// A tree of the faces' boxes finds the pairs that may intersect, and `faces_intersect` decides on each. The result is
// sorted, so that neither the tree nor the number of threads shows in it. If the surface intersects itself, its remesh
// may have to. A pair of faces may be inherited if cells at the corners of one face intersect cells at the corners of
// the other, which is the case if two intersecting faces of the surface have pieces in these cells.
#include "dual/self_intersections.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "base/parallel_chunks.hpp"
#include "diagram/cell_parts.hpp"
#include "dual/faces_intersect.hpp"
#include "dual/placed_faces.hpp"

namespace gvd {
namespace {

/// The part of a face in one cell.
struct PlacedPart {
  GeneratorId cell;
  Box3 box;
};

/// The parts of f whose boxes overlap that of g.
std::vector<PlacedPart> parts_near(const Mesh& surface, const Diagram& diagram, FaceId f, FaceId g) {
  std::vector<PlacedPart> parts;
  for_each_cell_part(diagram, f, [&](const FacePart& part) {
    Box3 box;
    for (const Bary& bary : part.corners) box.extend(position(surface, {f, bary}));
    if (box.intersects(face_box(surface, g))) parts.push_back({part.generator, box});
  });
  return parts;
}

/// `are_parted` multiplies eight lengths, and an exact determinant rounding errors of three. With coordinates up to
/// 2^40 all of that fits the exponents of a double, as long as lengths are above 2^-100.
constexpr int kMostExponent = 40;

/// The positions times a power of two, if the largest coordinate would let products of lengths overflow or underflow.
/// Such a factor rounds nothing but coordinates that fall below 1e-308, and these are 1e-290 of the largest one.
std::optional<std::vector<Vec3>> scale_to_unit(const std::vector<Vec3>& positions) {
  double largest = 0;
  for (const Vec3& p : positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  const int exponent = largest > 0 ? std::ilogb(largest) : 0;
  if (std::abs(exponent) <= kMostExponent) return std::nullopt;
  std::vector<Vec3> scaled = positions;
  for (Vec3& p : scaled) p = p.unaryExpr([&](double x) { return std::ldexp(x, -exponent); });
  return scaled;
}

/// Steps between reports of progress.
constexpr std::size_t kProgressStride = 4096;

}  // namespace

std::vector<FacePair> find_self_intersections(const PlacedFaces& faces, int threads, const Progress& progress,
                                              const std::vector<char>& counts) {
  if (const auto scaled = scale_to_unit(faces.positions)) {
    return find_self_intersections(PlacedFaces(faces.mesh, *scaled), threads, progress, counts);
  }
  const auto is_wanted = [&](FaceId f, FaceId g) { return counts.empty() || counts[f.index()] || counts[g.index()]; };
  constexpr std::size_t kFacesPerChunk = 256;
  const FaceBoxes boxes(faces, faces.mesh.faces());
  const auto chunks = cut_into_chunks(faces.mesh.face_count(), kFacesPerChunk);
  auto pairs = ParallelChunks(threads, progress).collect(chunks, {"self-intersections"}, [&](const Chunk& chunk) {
    std::vector<FacePair> found;
    for (std::size_t i = chunk.begin; i < chunk.end; ++i) {
      const FaceId f(i);
      boxes.any_of(face_box(faces, f), [&](FaceId g) {
        if (f < g && is_wanted(f, g) && faces_intersect(faces, f, g)) found.push_back({f, g});
        return false;
      });
    }
    return found;
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<FacePair> find_self_intersections(const Mesh& mesh, int threads, const Progress& progress) {
  return find_self_intersections(PlacedFaces(mesh), threads, progress);
}

std::vector<CellPair> find_intersecting_cells(const Mesh& surface, const Diagram& diagram,
                                              const std::vector<FacePair>& given, const Progress& progress) {
  std::vector<CellPair> cells;
  for (std::size_t i = 0; i < given.size(); ++i) {
    if (i % kProgressStride == 0) report_progress(progress, "self-intersections", double(i) / double(given.size()));
    const auto firsts = parts_near(surface, diagram, given[i].first, given[i].second);
    const auto seconds = parts_near(surface, diagram, given[i].second, given[i].first);
    for (const PlacedPart& p : firsts) {
      for (const PlacedPart& q : seconds) {
        if (p.box.intersects(q.box)) cells.push_back({std::min(p.cell, q.cell), std::max(p.cell, q.cell)});
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

std::vector<FacePair> find_inherited(const Mesh& remesh, const std::vector<FacePair>& pairs,
                                     const std::vector<CellPair>& cells) {
  const auto intersect = [&](VertexId v, VertexId w) {
    const GeneratorId a(v.value()), b(w.value());
    return std::binary_search(cells.begin(), cells.end(), CellPair{std::min(a, b), std::max(a, b)});
  };
  std::vector<FacePair> inherited;
  std::ranges::copy_if(pairs, std::back_inserter(inherited), [&](const FacePair& pair) {
    return std::ranges::any_of(remesh.vertices(pair.first), [&](VertexId v) {
      return std::ranges::any_of(remesh.vertices(pair.second), [&](VertexId w) { return intersect(v, w); });
    });
  });
  return inherited;
}

}  // namespace gvd
