// From pieces of faces to a diagram and its faults.
//
// Pieces of one label that touch are one component of a cell; components without their generator are islands. Where
// pieces of two cells touch runs a bisector: segments with common ends are chained, and an end that nothing continues
// is counted. Nothing is repaired here, so that a comparator shows what it leaves wrong. Order follows pieces and
// contacts.
//
// Every comparator ends here, so that the differences in islands, open ends and lengths are those of the methods. A
// piece of a face that is cut by rounding alone would be a fault of ours: corners next to a vertex or a side are moved
// there first, and components of a millionth of a millionth of the surface are no islands.
#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "base/barycentric.hpp"
#include "base/union_find.hpp"
#include "diagram/collect_cells.hpp"
#include "gvd/surface_point.hpp"
#include "pieces.hpp"

namespace gvd::paper {

namespace {

/// A point this far outside of a piece counts as inside, in barycentric coordinates: a thousand times the rounding.
constexpr double kInside = 1e-9;

/// Whether a point lies in a polygon that need not be convex, or near its border.
bool contains(const FacePiece& piece, const Bary& bary) {
  const std::size_t n = piece.corners.size();
  const Vec2 p = affine_point(bary);
  bool inside = false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 a = affine_point(piece.corners[i]) - p, b = affine_point(piece.corners[(i + 1) % n]) - p;
    const Vec2 side = b - a;
    if ((a + nearest_on_segment(a, side, Vec2(0, 0)) * side).norm() <= kInside) return true;
    if ((a.y() > 0) != (b.y() > 0) && (cross(a, b) > 0) == (b.y() > a.y())) inside = !inside;
  }
  return inside;
}

/// Marks the components of a generator's cell that contain the generator.
void mark_own_parts(const Mesh& mesh, const Pieces& pieces, GeneratorId g, const SurfacePoint& point,
                    CellParts& parts) {
  for (const SurfacePoint& view : find_views(mesh, point)) {
    auto it = std::ranges::lower_bound(pieces, view.face, {}, &FacePiece::face);
    for (; it != pieces.end() && it->face == view.face; ++it) {
      if (it->generator != g || !contains(*it, view.bary)) continue;
      parts.has_generator[parts.part_of[it - pieces.begin()]] = 1;
    }
  }
}

/// Numbers the sets of pieces in the order of their first pieces, and adds up their areas.
CellParts number_parts(const Mesh& mesh, const Pieces& pieces, UnionFind& sets) {
  CellParts parts;
  parts.part_of.resize(pieces.size(), -1);
  for (int i = 0; i < std::ssize(pieces); ++i) {
    const int root = sets.find(i);
    if (parts.part_of[root] < 0) {
      parts.part_of[root] = static_cast<std::int32_t>(parts.area.size());
      parts.generator.push_back(pieces[root].generator);
      parts.area.push_back(0);
    }
    parts.part_of[i] = parts.part_of[root];
    const double area = mesh.area(pieces[i].face) * area_share(pieces[i].corners);
    parts.area[parts.part_of[i]] += area;
    parts.total_area += area;
  }
  parts.has_generator.resize(parts.area.size(), 0);
  return parts;
}

}  // namespace

CellParts find_cell_parts(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Pieces& pieces,
                          const std::vector<Contact>& contacts) {
  UnionFind sets(pieces.size());
  const auto label = [&](std::int32_t i) { return pieces[i].generator; };
  for (const Contact& c : contacts) {
    if (label(c.left) == label(c.right)) sets.unite(c.left, c.right);
  }
  CellParts parts = number_parts(mesh, pieces, sets);
  for (std::size_t i = 0; i < generators.size(); ++i) {
    mark_own_parts(mesh, pieces, GeneratorId(i), generators[i], parts);
  }
  return parts;
}

namespace {

constexpr std::int32_t kNone = -1;

/// Numbers points so that those within a distance have one number: sorted along x, only neighbours are compared.
std::vector<std::int32_t> number_points(const std::vector<Vec3>& points, double distance) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int i) { return points[i].x(); });
  UnionFind sets(points.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Vec3& p = points[order[i]];
    for (std::size_t j = i + 1; j < order.size() && points[order[j]].x() - p.x() <= distance; ++j) {
      if ((points[order[j]] - p).norm() <= distance) sets.unite(order[i], order[j]);
    }
  }
  std::vector<std::int32_t> numbers(points.size());
  for (int i = 0; i < std::ssize(points); ++i) numbers[i] = sets.find(i);
  return numbers;
}

/// Joins segments where one ends and another one of the same two cells begins. A branch point needs no rule of its own:
/// there no two segments have both cells in common.
class Chainer {
 public:
  Chainer(const Mesh& mesh, const std::vector<Segment>& segments)
      : mesh_(mesh), segments_(segments), next_(segments.size(), kNone), previous_(segments.size(), kNone) {}

  Chains chain() {
    join();
    Chains chains;
    chains.open_ends = open_ends_;
    std::vector<char> done(segments_.size(), 0);
    // First the chains with two ends, then what is left: closed ones.
    for (const bool closed : {false, true}) {
      for (std::size_t i = 0; i < segments_.size(); ++i) {
        if (done[i] == 0 && (closed || previous_[i] == kNone)) chains.bisectors.push_back(follow(i, closed, done));
      }
    }
    return chains;
  }

 private:
  struct End {
    std::size_t segment;
    bool is_begin;
  };

  /// Links each segment to the one that continues it.
  void join() {
    std::vector<Vec3> points;
    for (const Segment& s : segments_) {
      points.push_back(position(mesh_, s.begin));
      points.push_back(position(mesh_, s.end));
    }
    const auto numbers = number_points(points, kSameEnd * mesh_.bbox_diagonal());
    std::map<std::int32_t, std::vector<End>> ends;  // by the numbers of their points
    for (std::size_t i = 0; i < points.size(); ++i) ends[numbers[i]].push_back({i / 2, i % 2 == 0});
    for (const auto& [number, together] : ends) join_at_point(together);
  }

  void join_at_point(const std::vector<End>& ends) {
    if (ends.size() == 1 && !is_on_boundary(mesh_, end_point(ends.front()))) ++open_ends_;
    for (const End& from : ends) {
      for (const End& to : ends) {
        if (!from.is_begin && to.is_begin) link(from.segment, to.segment);
      }
    }
  }

  const SurfacePoint& end_point(const End& end) const {
    return end.is_begin ? segments_[end.segment].begin : segments_[end.segment].end;
  }

  /// Lets one segment continue another, if both have the same cells and neither has a neighbour there yet.
  void link(std::size_t from, std::size_t to) {
    const Segment &a = segments_[from], &b = segments_[to];
    if (from == to || a.left != b.left || a.right != b.right) return;
    if (next_[from] != kNone || previous_[to] != kNone) return;
    if (!find_common_view(mesh_, a.begin, b.begin)) return;  // rounding has moved the point off their common edge
    next_[from] = static_cast<std::int32_t>(to);
    previous_[to] = static_cast<std::int32_t>(from);
  }

  /// The chain from its first segment on.
  Bisector follow(std::size_t first, bool closed, std::vector<char>& done) const {
    Bisector bisector;
    bisector.left = segments_[first].left;
    bisector.right = segments_[first].right;
    bisector.closed = closed;
    std::size_t i = first;
    while (done[i] == 0) {
      done[i] = 1;
      bisector.points.push_back(segments_[i].begin);
      if (next_[i] == kNone) {
        bisector.points.push_back(segments_[i].end);
      } else {
        i = next_[i];
      }
    }
    return bisector;
  }

  const Mesh& mesh_;
  const std::vector<Segment>& segments_;
  std::vector<std::int32_t> next_, previous_;
  std::int64_t open_ends_ = 0;
};

}  // namespace

Chains chain_segments(const Mesh& mesh, const std::vector<Segment>& segments) {
  return Chainer(mesh, segments).chain();
}

namespace {

/// Moves corners onto the sides and vertices of their face that they are next to. Where a bisector runs through a
/// vertex or along an edge, rounding leaves slivers there, which would tear it.
void snap_corners(Pieces& pieces) {
  for (FacePiece& piece : pieces) {
    for (Bary& corner : piece.corners) {
      double sum = 0;
      for (double& b : corner) sum += b = b > kLeastContact ? b : 0;
      for (double& b : corner) b /= sum;
    }
  }
}

/// A vertex takes the label of the first piece that has it as a corner.
void label_vertices(const Mesh& mesh, const Pieces& pieces, Diagram& diagram) {
  diagram.vertex_label.assign(mesh.vertex_count(), GeneratorId());
  for (const FacePiece& piece : pieces) {
    for (const Bary& corner : piece.corners) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (corner[i] != 1) continue;
        GeneratorId& label = diagram.vertex_label[mesh.vertices(piece.face)[i]];
        if (!label.valid()) label = piece.generator;
      }
    }
  }
}

/// Bisectors run along the contacts of different cells; each segment has the lower generator on its left.
void trace_contacts(const Mesh& mesh, const Pieces& pieces, const std::vector<Contact>& contacts,
                    Comparison& comparison) {
  std::vector<Segment> segments;
  for (const Contact& c : contacts) {
    const GeneratorId left = pieces[c.left].generator;
    const GeneratorId right = pieces[c.right].generator;
    if (left == right || !left.valid() || !right.valid()) continue;
    Segment segment{left, right, {c.face, c.begin}, {c.face, c.end}};
    if (right < left) segment = {right, left, {c.face, c.end}, {c.face, c.begin}};
    segments.push_back(segment);
    comparison.diagram.length += (position(mesh, segment.end) - position(mesh, segment.begin)).norm();
  }
  Chains chains = chain_segments(mesh, segments);
  for (Bisector& bisector : chains.bisectors) comparison.diagram.bisectors.push_back(std::move(bisector));
  comparison.faults.open_ends += chains.open_ends;
}

/// Islands, their area, pieces without an owner, and generators that no piece of their own contains.
void count_faults(const CellParts& parts, std::size_t generators, Comparison& comparison) {
  std::set<GeneratorId> found;
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    const GeneratorId g = parts.generator[i];
    if (!g.valid()) comparison.faults.unowned_area += parts.area[i];
    if (parts.has_generator[i] != 0) found.insert(g);
    if (!parts.is_island(static_cast<std::int32_t>(i))) continue;
    ++comparison.faults.islands;
    comparison.faults.island_area += parts.area[i];
  }
  comparison.faults.lost_generators += std::int64_t(generators - found.size());
}

/// Areas and components of the cells, from their parts, and neighbours, from the bisectors.
void fill_cells(const CellParts& parts, Diagram& diagram) {
  diagram.cells.resize(diagram.generators.size());
  for (const GeneratorId g : diagram.cells.ids()) diagram.cells[g].generator = g;
  for (std::size_t i = 0; i < parts.area.size(); ++i) {
    if (!parts.generator[i].valid()) continue;
    Cell& cell = diagram.cells[parts.generator[i]];
    cell.area += parts.area[i];
    ++cell.components;
  }
  find_neighbours(diagram);
}

/// Faces that are not cut get a label, the other ones keep their pieces.
void store_pieces(const Mesh& mesh, Pieces pieces, Diagram& diagram) {
  diagram.face_label.assign(mesh.face_count(), GeneratorId());
  for (std::size_t i = 0; i < pieces.size();) {
    std::size_t j = i;
    while (j < pieces.size() && pieces[j].face == pieces[i].face) ++j;
    if (j == i + 1) {
      diagram.face_label[pieces[i].face] = pieces[i].generator;
    } else {
      std::move(pieces.begin() + i, pieces.begin() + j, std::back_inserter(diagram.pieces));
    }
    i = j;
  }
}

}  // namespace

void collect_pieces(const Mesh& mesh, const std::vector<SurfacePoint>& generators, Pieces pieces,
                    Comparison& comparison) {
  snap_corners(pieces);
  const std::vector<Contact> contacts = find_contacts(mesh, pieces);
  const CellParts parts = find_cell_parts(mesh, generators, pieces, contacts);
  comparison.diagram.generators = generators;
  label_vertices(mesh, pieces, comparison.diagram);
  trace_contacts(mesh, pieces, contacts, comparison);
  count_faults(parts, generators.size(), comparison);
  fill_cells(parts, comparison.diagram);
  store_pieces(mesh, std::move(pieces), comparison.diagram);
}
}  // namespace gvd::paper
