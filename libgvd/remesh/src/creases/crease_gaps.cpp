#include "creases/crease_gaps.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace gvd {
namespace {

/// The power of two from a third of the length to two thirds.
double shell_distance(double length) { return std::exp2(std::floor(std::log2(length * 2 / 3))); }

/// Height of an arc that turns by kLargestBend over its chord, relative to the chord: tan(bend / 4) / 2.
const double kLargestSagitta = std::tan(kLargestBend / 4 * std::numbers::pi / 180) / 2;

}  // namespace

/// A curve with its generators and cells, by length from its first vertex. A closed one begins at its first generator.
struct CreaseGaps::Course {
  const CreaseCurve& curve;
  std::vector<double> vertex_at;  // of each of the curve's vertices
  std::vector<Mark> marks;        // ascending
  std::vector<Part> parts;

  double length() const { return vertex_at.back(); }

  /// Of the k-th vertex; of a closed curve, also on a second way round.
  double at(std::size_t k) const {
    const std::size_t edges = curve.edges.size();
    return k < edges ? vertex_at[k] : vertex_at[k - edges] + length();
  }

  /// The first vertex after a point.
  std::size_t first_after(double point) const {
    return static_cast<std::size_t>(std::upper_bound(vertex_at.begin(), vertex_at.end(), point) - vertex_at.begin());
  }

  /// The marks; of a closed curve, the first one again at the end.
  std::vector<Mark> all_marks() const {
    std::vector<Mark> all = marks;
    if (curve.closed) all.push_back({marks.front().at + length(), marks.front().generator});
    return all;
  }

  /// Whether a curve that ends where it begins has less than three generators. A generator at its corner has a mark at
  /// both ends.
  bool has_too_few() const {
    if (curve.vertices.front() != curve.vertices.back()) return false;
    return marks.size() < (curve.closed ? 3 : 4);
  }

  SurfacePoint point(const Mesh& mesh, double at) const {
    if (curve.closed) at = std::fmod(at, length());
    const auto after = std::upper_bound(vertex_at.begin() + 1, vertex_at.end() - 1, at);
    const auto edge = static_cast<std::size_t>(after - vertex_at.begin()) - 1;
    const SurfacePoint p = point_on_curve(mesh, curve, edge, at - vertex_at[edge]);
    return make_surface_point(p.face, p.bary);
  }
};

/// The parts between two consecutive generators that belong to neither of them.
struct CreaseGaps::Gap {
  std::size_t index = 0;      // of the mark at its begin
  std::vector<Part> foreign;  // one at least

  double first() const {
    const auto begins_before = [](const Part& a, const Part& b) { return a.begin < b.begin; };
    return std::min_element(foreign.begin(), foreign.end(), begins_before)->begin;
  }
  double last() const {
    const auto ends_before = [](const Part& a, const Part& b) { return a.end < b.end; };
    return std::max_element(foreign.begin(), foreign.end(), ends_before)->end;
  }
};

CreaseGaps::CreaseGaps(const Mesh& mesh, const std::vector<CreaseCurve>& curves, const Diagram& diagram, double spacing)
    : mesh_(mesh), curves_(curves), generators_(diagram.generators), spacing_(spacing), labels_(mesh, diagram) {
  for (std::size_t i = 0; i < diagram.generators.size(); ++i) {
    const SurfacePoint& p = diagram.generators[i];
    const GeneratorId g(i);
    if (p.kind() == SurfacePoint::Kind::vertex) at_vertex_[vertex(mesh, p)] = g;
    if (p.kind() != SurfacePoint::Kind::edge) continue;
    const HalfedgeId h = halfedge(p);
    const EdgeId e = mesh.edge(h);
    const double along = p.bary[Mesh::corner(Mesh::next(h))];
    on_edge_[e].push_back({mesh.halfedge(e) == h ? along : 1 - along, g});
  }
  for (const CreaseCurve& curve : curves) {
    if (curve.closed) continue;
    for (const Mark& mark : marks_on(curve)) {
      std::vector<VertexId>& ends = ends_of_curves_[mark.generator];
      ends.insert(ends.end(), {curve.vertices.front(), curve.vertices.back()});
    }
  }
}

std::vector<CreaseGap> CreaseGaps::find() const {
  std::vector<CreaseGap> gaps;
  for (const CreaseCurve& curve : curves_) {
    Course course{curve, {0}, marks_on(curve), {}};
    for (const EdgeId e : curve.edges) {
      course.vertex_at.push_back(course.vertex_at.back() + mesh_.length(mesh_.halfedge(e)));
    }
    course.parts = parts_of(curve);
    add_gaps(course, gaps);
  }
  std::stable_sort(gaps.begin(), gaps.end(), [](const CreaseGap& a, const CreaseGap& b) {
    return a.at_corner != b.at_corner ? a.at_corner : !a.at_corner && a.length > b.length;
  });
  return gaps;
}

void CreaseGaps::add_gaps(const Course& course, std::vector<CreaseGap>& gaps) const {
  const bool lacks_corner = add_corners(course, gaps);
  if (!lacks_corner && course.has_too_few()) {
    gaps.push_back(whole_curve(course));
    return;
  }
  for (CreaseGap& gap : gaps_between(course)) {
    gap.waits = lacks_corner;
    gaps.push_back(std::move(gap));
  }
}

/// The generators of a curve, each once: that at the ends of a closed curve stands at its beginning.
std::vector<CreaseGaps::Mark> CreaseGaps::marks_on(const CreaseCurve& curve) const {
  std::vector<Mark> marks;
  double passed = 0;
  for (std::size_t i = 0; i < curve.vertices.size(); ++i) {
    const bool is_end = i == curve.edges.size();
    if (const auto here = at_vertex_.find(curve.vertices[i]); here != at_vertex_.end() && !(is_end && curve.closed)) {
      marks.push_back({passed, here->second});
    }
    if (is_end) break;
    const HalfedgeId h = mesh_.halfedge(curve.edges[i]);
    if (const auto here = on_edge_.find(curve.edges[i]); here != on_edge_.end()) {
      const bool forwards = mesh_.from(h) == curve.vertices[i];
      for (const Mark& mark : here->second) {
        marks.push_back({passed + mesh_.length(h) * (forwards ? mark.at : 1 - mark.at), mark.generator});
      }
    }
    passed += mesh_.length(h);
  }
  std::stable_sort(marks.begin(), marks.end(), [](const Mark& a, const Mark& b) { return a.at < b.at; });
  return marks;
}

std::vector<CreaseGaps::Part> CreaseGaps::parts_of(const CreaseCurve& curve) const {
  std::vector<Part> parts;
  double passed = 0;
  for (std::size_t i = 0; i < curve.edges.size(); ++i) {
    const HalfedgeId h = mesh_.halfedge(curve.edges[i]);
    const double length = mesh_.length(h);
    const bool forwards = mesh_.from(h) == curve.vertices[i];
    for (const EdgeLabel& label : labels_.of(curve.edges[i])) {
      const double begin = forwards ? label.begin : 1 - label.end, end = forwards ? label.end : 1 - label.begin;
      parts.push_back({passed + length * begin, passed + length * end, label.cell});
    }
    passed += length;
  }
  return parts;
}

/// The parts beside corners without a generator. False where there is none.
bool CreaseGaps::add_corners(const Course& course, std::vector<CreaseGap>& gaps) const {
  if (course.curve.closed) return false;
  const VertexId first = course.curve.vertices.front(), last = course.curve.vertices.back();
  const bool lacks_first = at_vertex_.count(first) == 0, lacks_last = at_vertex_.count(last) == 0;
  // Without any generator, the whole curve is beside its first corner, and nothing is left for the last one.
  const double begin = course.marks.empty() ? course.length() : course.marks.front().at;
  const double end = course.marks.empty() ? course.length() : course.marks.back().at;
  if (lacks_first) gaps.push_back({{vertex_point(mesh_, first)}, begin, true});
  if (lacks_last) gaps.push_back({{vertex_point(mesh_, last)}, course.length() - end, true});
  return lacks_first || lacks_last;
}

CreaseGap CreaseGaps::whole_curve(const Course& course) const {
  CreaseGap gap{{}, course.length()};
  const double first = course.marks.empty() ? 0 : course.marks.front().at;
  for (int third = course.marks.empty() ? 0 : 1; third < 3; ++third) {
    gap.places.push_back(course.point(mesh_, first + course.length() * third / 3));
  }
  return gap;
}

/// The corner beside the i-th gap between these marks that a curve of the generator leaves, too; invalid if none is.
VertexId CreaseGaps::shared_corner(const Course& course, std::size_t i, std::size_t marks, GeneratorId of) const {
  if (course.curve.closed) return {};
  const auto ends = ends_of_curves_.find(of);
  if (ends == ends_of_curves_.end()) return {};
  const auto leaves = [&](VertexId v) {
    return std::find(ends->second.begin(), ends->second.end(), v) != ends->second.end();
  };
  const VertexId first = course.curve.vertices.front(), last = course.curve.vertices.back();
  if (i == 0 && leaves(first)) return first;
  if (i + 2 == marks && leaves(last)) return last;
  return {};
}

/// The point of the curve between two lengths that is nearest to `to`, by its length.
double CreaseGaps::nearest(const Course& course, double begin, double end, const Vec3& to) const {
  double best = (begin + end) / 2, least = std::numeric_limits<double>::infinity();
  const std::size_t edges = course.curve.edges.size(), rounds = course.curve.closed ? 2 : 1;
  for (std::size_t k = course.first_after(begin) - 1; k < rounds * edges && course.at(k) <= end; ++k) {
    const double start = course.at(k);
    const Vec3 &a = mesh_.position(course.curve.vertices[k % edges]),
               &b = mesh_.position(course.curve.vertices[k % edges + 1]);
    const double length = (b - a).norm();
    if (start + length < begin || !(length > 0)) continue;
    const double at =
        std::clamp(start + (to - a).dot(b - a) / length, std::max(start, begin), std::min(start + length, end));
    const double squared = (a + (at - start) / length * (b - a) - to).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best = at;
  }
  return best;
}

/// Where a gap takes a generator: see the table of the class.
double CreaseGaps::place_in(const Course& course, const std::vector<Mark>& marks, const Gap& gap) const {
  const double begin = marks[gap.index].at, end = marks[gap.index + 1].at, length = end - begin;
  const auto is_shorter = [](const Part& a, const Part& b) { return a.end - a.begin < b.end - b.begin; };
  const GeneratorId of = std::max_element(gap.foreign.begin(), gap.foreign.end(), is_shorter)->cell;
  const VertexId corner = shared_corner(course, gap.index, marks.size(), of);
  if (corner.valid()) {
    const bool at_begin = gap.index == 0 && corner == course.curve.vertices.front();
    return at_begin ? begin + shell_distance(length) : end - shell_distance(length);
  }
  const double opposite = nearest(course, begin, end, position(mesh_, generators_[of.index()]));
  if (std::min(opposite - begin, end - opposite) >= kLeastGapShare * length) return opposite;
  return (gap.first() + gap.last()) / 2;
}

/// The gaps between consecutive marks that have foreign parts.
std::vector<CreaseGaps::Gap> CreaseGaps::list_gaps(const std::vector<Part>& parts, const std::vector<Mark>& marks) {
  std::vector<Gap> gaps(marks.empty() ? 0 : marks.size() - 1);
  for (std::size_t i = 0; i < gaps.size(); ++i) gaps[i].index = i;
  for (const Part& part : parts) {
    const auto after = std::upper_bound(marks.begin(), marks.end(), part.begin,
                                        [](double at, const Mark& mark) { return at < mark.at; });
    auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - marks.begin() - 1, 0));
    for (; i + 1 < marks.size() && marks[i].at < part.end; ++i) {
      if (part.cell == marks[i].generator || part.cell == marks[i + 1].generator) continue;
      const Part inside{std::max(part.begin, marks[i].at), std::min(part.end, marks[i + 1].at), part.cell};
      const bool counts = inside.end - inside.begin > kLeastForeignPart * (marks[i + 1].at - marks[i].at);
      if (counts) gaps[i].foreign.push_back(inside);
    }
  }
  std::erase_if(gaps, [](const Gap& gap) { return gap.foreign.empty(); });
  return gaps;
}

/// Between consecutive generators: foreign parts, and bends where there are none.
std::vector<CreaseGap> CreaseGaps::gaps_between(const Course& course) const {
  std::vector<Part> parts = course.parts;
  if (course.curve.closed) {
    for (const Part& p : course.parts) parts.push_back({p.begin + course.length(), p.end + course.length(), p.cell});
  }
  const std::vector<Mark> marks = course.all_marks();
  std::vector<char> is_followed(marks.size(), 1);
  std::vector<CreaseGap> gaps;
  for (const Gap& gap : list_gaps(parts, marks)) {
    gaps.push_back({{course.point(mesh_, place_in(course, marks, gap))}, gap.last() - gap.first()});
    is_followed[gap.index] = 0;
  }
  for (std::size_t i = 0; i + 1 < marks.size(); ++i) {
    const double begin = marks[i].at, end = marks[i + 1].at;
    if (is_followed[i] && cuts_off_bend(course, begin, end)) {
      gaps.push_back({{course.point(mesh_, (begin + end) / 2)}, 0});
    }
  }
  return gaps;
}

/// Whether the edge between two points of a curve, by their lengths, is long and cuts off a bend.
bool CreaseGaps::cuts_off_bend(const Course& course, double begin, double end) const {
  if (mesh_.is_boundary(course.curve.edges.front())) return false;
  const Vec3 a = position(mesh_, course.point(mesh_, begin)), b = position(mesh_, course.point(mesh_, end));
  const double chord = (b - a).norm();
  return chord > spacing_ && distance_from_line(course, begin, end, {a, b}) > kLargestSagitta * chord;
}

/// The largest one of the curve's vertices between two lengths.
double CreaseGaps::distance_from_line(const Course& course, double begin, double end,
                                      const std::array<Vec3, 2>& line) const {
  const Vec3 way = (line[1] - line[0]).normalized();
  const std::size_t edges = course.curve.edges.size();
  double largest = 0;
  for (std::size_t k = course.first_after(begin); k < 2 * edges && course.at(k) < end; ++k) {
    const Vec3 to = mesh_.position(course.curve.vertices[k % edges]) - line[0];
    largest = std::max(largest, (to - to.dot(way) * way).norm());
  }
  return largest;
}

}  // namespace gvd
