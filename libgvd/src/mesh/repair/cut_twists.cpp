// Cuts one-sided components open, if the orientations in the file say where.
//
// A twist is an edge whose two faces disagree about the orientation. Imagine two copies of each face, one for each
// orientation, and let each edge join the copies that agree there. A component is one-sided if that joins the two
// copies of a face. If a one-sided component has few twists, its faces are joined again: first across all other edges,
// which gives parts that are consistent in themselves, and then across the seams between the parts, the longest seam
// first, unless that would join a face with its own reverse. The remaining twists are cut. So a single reversed face
// inside the component is not cut out.
// Invariant: afterwards, flips of faces can make the component consistent. No face is flipped here.
#include "mesh/repair/cut_twists.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/union_find.hpp"
#include "gvd/text.hpp"
#include "mesh/repair/defect_log.hpp"
#include "mesh/repair/work_faces.hpp"

namespace gvd {
namespace {

/// A one-sided component is cut open if fewer than one of this many edges is a twist. With more twists, the
/// orientations in the file do not tell where to cut.
constexpr std::int64_t kLeastEdgesPerTwist = 100;

/// The first halfedges of all twists, ascending.
std::vector<std::int32_t> find_twists(const WorkFaces& work) {
  std::vector<std::int32_t> twists;
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    for (std::int32_t i = 0; i < 3; ++i) {
      const std::int32_t h = 3 * f + i, twin = work.twin[h];
      if (twin > h && work.faces[f][i] == work.from(twin)) twists.push_back(h);
    }
  }
  return twists;
}

bool is_twist(const WorkFaces& work, std::int32_t h) { return work.from(h) == work.from(work.twin[h]); }

/// Joins faces and their reverses where they agree.
class Sides {
 public:
  explicit Sides(const WorkFaces& work) : work_(work), joined_(2 * work.faces.size()) {}

  /// Joins the faces of an edge of two faces.
  void join(std::int32_t h) {
    const std::int32_t a = h / 3, b = work_.twin[h] / 3;
    const bool turned = is_twist(work_, h);
    joined_.unite(a, turned ? reverse(b) : b);
    joined_.unite(reverse(a), turned ? b : reverse(b));
  }
  /// The smallest face, or reversed face, joined with f.
  std::int32_t part(std::int32_t f) { return joined_.find(f); }
  bool is_one_sided(std::int32_t f) { return part(f) == part(reverse(f)); }

 private:
  std::int32_t reverse(std::int32_t f) const { return f + work_.face_count(); }

  const WorkFaces& work_;
  UnionFind joined_;
};

/// For each face, 1 if its component is one-sided and has few twists.
std::vector<char> find_few_twists(const WorkFaces& work, const std::vector<std::int32_t>& twists) {
  Sides sides(work);
  for (std::int32_t h = 0; h < work.halfedge_count(); ++h) {
    if (work.twin[h] > h) sides.join(h);
  }
  // By the part that represents the component.
  std::vector<std::int64_t> edges(work.faces.size(), 0), twisted(work.faces.size(), 0);
  std::vector<char> is_few(work.faces.size(), 0);
  for (std::int32_t f = 0; f < work.face_count(); ++f) is_few[f] = sides.is_one_sided(f);
  // In a one-sided component, each face and its reverse belong to the part of the component's first face.
  for (std::int32_t h = 0; h < work.halfedge_count(); ++h) {
    if (is_few[h / 3] && (work.twin[h] < 0 || work.twin[h] > h)) ++edges[sides.part(h / 3)];
  }
  for (const std::int32_t h : twists) {
    if (is_few[h / 3]) ++twisted[sides.part(h / 3)];
  }
  for (std::int32_t f = 0; f < work.face_count(); ++f) {
    if (!is_few[f]) continue;
    const std::int32_t part = sides.part(f);
    is_few[f] = twisted[part] * kLeastEdgesPerTwist < edges[part];
  }
  return is_few;
}

/// The twists between two parts, or inside one part.
struct Seam {
  std::int32_t low, high;            // the parts
  std::vector<std::int32_t> twists;  // ascending
};

/// The seams of faces marked in `is_few`, the longest first. Seams of equal length are sorted by their first twist.
std::vector<Seam> find_seams(const WorkFaces& work, const std::vector<std::int32_t>& twists,
                             const std::vector<char>& is_few, Sides& sides) {
  std::vector<std::tuple<std::int32_t, std::int32_t, std::int32_t>> sorted;
  for (const std::int32_t h : twists) {
    if (!is_few[h / 3]) continue;
    const auto [low, high] = std::minmax({sides.part(h / 3), sides.part(work.twin[h] / 3)});
    sorted.emplace_back(low, high, h);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Seam> seams;
  for (const auto& [low, high, h] : sorted) {
    if (seams.empty() || seams.back().low != low || seams.back().high != high) seams.push_back({low, high, {}});
    seams.back().twists.push_back(h);
  }
  std::ranges::sort(seams, {}, [](const Seam& s) { return std::pair(-std::ssize(s.twists), s.twists.front()); });
  return seams;
}

/// Chooses the twists to cut, in ascending order.
std::vector<std::int32_t> choose_cuts(const WorkFaces& work, const std::vector<std::int32_t>& twists) {
  const std::vector<char> is_few = find_few_twists(work, twists);
  if (std::find(is_few.begin(), is_few.end(), 1) == is_few.end()) return {};
  Sides sides(work);
  for (std::int32_t h = 0; h < work.halfedge_count(); ++h) {
    if (is_few[h / 3] && work.twin[h] > h && !is_twist(work, h)) sides.join(h);
  }
  std::vector<std::int32_t> cuts;
  for (const Seam& seam : find_seams(work, twists, is_few, sides)) {
    // Either all twists of a seam would join a face with its own reverse, or none would.
    const std::int32_t h = seam.twists.front();
    if (sides.part(h / 3) == sides.part(work.twin[h] / 3)) {
      cuts.insert(cuts.end(), seam.twists.begin(), seam.twists.end());
    } else {
      sides.join(h);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

}  // namespace

std::vector<std::int32_t> cut_twists(WorkFaces& work, DefectLog& log) {
  const std::vector<std::int32_t> twists = find_twists(work);
  if (twists.empty()) return {};
  const std::vector<std::int32_t> cuts = choose_cuts(work, twists);
  if (cuts.empty()) return {};
  std::vector<std::int32_t> ends;
  for (const std::int32_t h : cuts) {
    work.twin[work.twin[h]] = -1;
    work.twin[h] = -1;
    ends.insert(ends.end(), {work.from(h), work.to(h)});
  }
  const auto [low, high] = std::minmax({ends[0], ends[1]});
  const std::int32_t face = work.origin[cuts.front() / 3];
  log.add(DefectKind::one_sided_edges, std::ssize(cuts), face,
          fmt::format("{} the surface one-sided, like a Moebius strip, first the one between vertices {} and {} of "
                      "face {}",
                      counted(std::ssize(cuts), "edge between faces of opposite orientations makes",
                              "edges between faces of opposite orientations make"),
                      low, high, face),
          "cut open there");
  return ends;
}

}  // namespace gvd
