// Defects of the dual at creases, and the generators that bring its edges back to them.
//
// The joined label intervals of a curve's edges give the labels along the curve, by length from its first vertex. Along
// each curve, every part between two consecutive generators has to belong to their two cells. A part that belongs to
// another cell is a defect, and takes a generator. Opposite generators of two parallel curves do not disturb each
// other, however close the curves are. Two curves that leave a corner at an acute angle would disturb each other
// without end, unless their generators are equally far from the corner. Powers of two achieve that. Source: J. Ruppert,
// A Delaunay refinement algorithm for quality 2-dimensional mesh generation, 1995.

#include "crease_defects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "base/least.hpp"
#include "edge_labels.hpp"
#include "mesh/creases.hpp"
#include "repair/added_generators.hpp"

namespace gvd {
namespace {

/// A generator on an edge or a curve, at a parameter or a length as in LabelInterval.
struct GeneratorOnCurve {
  double at = 0;
  GeneratorId generator;
};

/// A curve with the generators and the label intervals on it, by length from its first vertex. On a closed curve,
/// lengths go around twice, so that no search along it has to treat the first vertex as a special case.
struct LabelledCurve {
  const Mesh& mesh;
  const CreaseCurve& curve;
  std::vector<double> vertex_at;             // length at each of the curve's vertices
  std::vector<GeneratorOnCurve> generators;  // ascending; one at the ends of a closed curve is at its beginning
  std::vector<LabelInterval> labels;
  bool begins_at_generator = false, ends_at_generator = false;  // whether its first, its last vertex is one

  double length() const { return vertex_at.back(); }

  /// Whether a curve that ends where it begins has fewer than three generators. If it is open and begins and ends at
  /// the same corner, a generator there counts at both ends.
  bool has_too_few() const {
    if (curve.vertices.front() != curve.vertices.back()) return false;
    return generators.size() < (curve.closed ? 3 : 4);
  }

  /// The generators of a curve. On a closed curve, the first one is repeated at the end.
  std::vector<GeneratorOnCurve> closed_generators() const {
    std::vector<GeneratorOnCurve> all = generators;
    if (curve.closed) all.push_back({generators.front().at + length(), generators.front().generator});
    return all;
  }

  /// The label intervals of a curve. On a closed curve they go around twice.
  std::vector<LabelInterval> repeated_labels() const {
    std::vector<LabelInterval> all = labels;
    if (!curve.closed) return all;
    for (const LabelInterval& l : labels) all.push_back({l.begin + length(), l.end + length(), l.cell});
    return all;
  }

  /// The point at a length.
  SurfacePoint point(double at) const {
    if (curve.closed) at = std::fmod(at, length());
    const auto edge = std::upper_bound(vertex_at.begin() + 1, vertex_at.end() - 1, at) - vertex_at.begin() - 1;
    const SurfacePoint p = point_on_edge(mesh, curve.edges[edge], curve.vertices[edge], at - vertex_at[edge]);
    return make_surface_point(p.face, p.bary);
  }

  /// The length at the k-th vertex.
  double at(std::size_t k) const {
    const std::size_t edges = curve.edges.size();
    return k < edges ? vertex_at[k] : vertex_at[k - edges] + length();
  }

  std::size_t first_after(double length) const {
    return std::upper_bound(vertex_at.begin(), vertex_at.end(), length) - vertex_at.begin();
  }

  /// The length, from `begin` to `end`, at which the curve is nearest to a point.
  double find_nearest(double begin, double end, const Vec3& to) const {
    Least<double> nearest{(begin + end) / 2};
    const std::size_t edges = curve.edges.size(), rounds = curve.closed ? 2 : 1;
    for (std::size_t k = first_after(begin) - 1; k < rounds * edges && at(k) <= end; ++k) {
      const double start = at(k);
      const Vec3 &a = mesh.position(curve.vertices[k % edges]), &b = mesh.position(curve.vertices[k % edges + 1]);
      const double length = (b - a).norm();
      if (start + length < begin || !(length > 0)) continue;
      const double here =
          std::clamp(start + (to - a).dot(b - a) / length, std::max(start, begin), std::min(start + length, end));
      nearest.offer((a + (here - start) / length * (b - a) - to).squaredNorm(), here);
    }
    return nearest.value;
  }

  /// The largest distance of the curve's vertices between two lengths from the line through two points.
  double largest_distance(double begin, double end, const std::array<Vec3, 2>& line) const {
    const Vec3 way = (line[1] - line[0]).normalized();
    const std::size_t edges = curve.edges.size();
    double largest = 0;
    for (std::size_t k = first_after(begin); k < 2 * edges && at(k) < end; ++k) {
      const Vec3 to = mesh.position(curve.vertices[k % edges]) - line[0];
      largest = std::max(largest, (to - to.dot(way) * way).norm());
    }
    return largest;
  }
};

class CurveLabeller {
 public:
  CurveLabeller(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
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
  }

  LabelledCurve label(const CreaseCurve& curve) const {
    LabelledCurve labelled{mesh_, curve, {0}, {}, {}, false, false};
    for (std::size_t i = 0; i < curve.edges.size(); ++i) {
      const bool is_generator = add_vertex(curve.vertices[i], labelled);
      if (i == 0) labelled.begins_at_generator = is_generator;
      add_edge(i, labelled);
    }
    if (!curve.closed) labelled.ends_at_generator = add_vertex(curve.vertices.back(), labelled);
    std::ranges::stable_sort(labelled.generators, {}, &GeneratorOnCurve::at);
    return labelled;
  }

 private:
  /// Adds the generator at a vertex. False if there is none.
  bool add_vertex(VertexId v, LabelledCurve& labelled) const {
    const auto here = at_vertex_.find(v);
    if (here == at_vertex_.end()) return false;
    labelled.generators.push_back({labelled.length(), here->second});
    return true;
  }

  void add_edge(std::size_t i, LabelledCurve& labelled) const {
    const EdgeId e = labelled.curve.edges[i];
    const HalfedgeId h = mesh_.halfedge(e);
    const double passed = labelled.length(), length = mesh_.length(h);
    const bool forwards = mesh_.from(h) == labelled.curve.vertices[i];
    if (const auto here = on_edge_.find(e); here != on_edge_.end()) {
      for (const GeneratorOnCurve& g : here->second) {
        labelled.generators.push_back({passed + length * (forwards ? g.at : 1 - g.at), g.generator});
      }
    }
    for (const LabelInterval& l : label_edge(mesh_, diagram_, e)) {
      const double begin = forwards ? l.begin : 1 - l.end, end = forwards ? l.end : 1 - l.begin;
      labelled.labels.push_back({passed + length * begin, passed + length * end, l.cell});
    }
    labelled.vertex_at.push_back(passed + length);
  }

  const Mesh& mesh_;
  const Diagram& diagram_;
  std::map<EdgeId, std::vector<GeneratorOnCurve>> on_edge_;  // at parameters along the edge's halfedge
  std::map<VertexId, GeneratorId> at_vertex_;
};

std::vector<LabelledCurve> label_curves(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                        const Diagram& diagram) {
  const CurveLabeller labeller(mesh, diagram);
  std::vector<LabelledCurve> labelled;
  for (const CreaseCurve& curve : curves) labelled.push_back(labeller.label(curve));
  return labelled;
}

/// The power of two between one and two thirds of the length.
double shell_distance(double length) { return std::exp2(std::floor(std::log2(length * 2 / 3))); }

/// Height of an arc that turns by kLargestBend over its chord, relative to the chord: tan(bend / 4) / 2.
const double kLargestSagitta = std::tan(kLargestBend / 4 * std::numbers::pi / 180) / 2;

/// The foreign cells between two consecutive generators of a curve.
struct ForeignCells {
  std::size_t index = 0;              // of the first generator
  std::vector<LabelInterval> labels;  // one at least

  double first() const { return std::ranges::min(labels, {}, &LabelInterval::begin).begin; }
  double last() const { return std::ranges::max(labels, {}, &LabelInterval::end).end; }
  GeneratorId longest() const {
    return std::ranges::max_element(labels, {}, [](const LabelInterval& l) { return l.end - l.begin; })->cell;
  }
};

/// The foreign cells between consecutive generators, where there are any.
std::vector<ForeignCells> list_foreign(const std::vector<LabelInterval>& labels,
                                       const std::vector<GeneratorOnCurve>& generators) {
  std::vector<ForeignCells> all(generators.empty() ? 0 : generators.size() - 1);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].index = i;
  for (const LabelInterval& label : labels) {
    const auto after = std::ranges::upper_bound(generators, label.begin, {}, &GeneratorOnCurve::at);
    std::size_t i = std::max<std::ptrdiff_t>(after - generators.begin() - 1, 0);
    for (; i + 1 < generators.size() && generators[i].at < label.end; ++i) {
      const GeneratorOnCurve &a = generators[i], &b = generators[i + 1];
      if (label.cell == a.generator || label.cell == b.generator) continue;
      const LabelInterval inside{std::max(label.begin, a.at), std::min(label.end, b.at), label.cell};
      if (inside.end - inside.begin > kLeastForeignShare * (b.at - a.at)) all[i].labels.push_back(inside);
    }
  }
  std::erase_if(all, [](const ForeignCells& foreign) { return foreign.labels.empty(); });
  return all;
}

class DefectFinder {
 public:
  DefectFinder(const Mesh& mesh, const std::vector<CreaseCurve>& curves, const Diagram& diagram, double spacing)
      : mesh_(mesh), generators_(diagram.generators), spacing_(spacing), curves_(label_curves(mesh, curves, diagram)) {
    for (const LabelledCurve& labelled : curves_) {
      if (labelled.curve.closed) continue;
      for (const GeneratorOnCurve& g : labelled.generators) {
        std::vector<VertexId>& ends = ends_of_curves_[g.generator];
        ends.insert(ends.end(), {labelled.curve.vertices.front(), labelled.curve.vertices.back()});
      }
    }
  }

  std::vector<CreaseDefect> run() {
    for (const LabelledCurve& curve : curves_) add_defects(curve);
    std::stable_sort(defects_.begin(), defects_.end(), [](const CreaseDefect& a, const CreaseDefect& b) {
      return a.at_corner != b.at_corner ? a.at_corner : !a.at_corner && a.length > b.length;
    });
    return std::move(defects_);
  }

 private:
  void add_defects(const LabelledCurve& labelled) {
    const bool lacks_corner = add_corners(labelled);
    if (!lacks_corner && labelled.has_too_few()) {
      defects_.push_back(whole_curve(labelled));
      return;
    }
    for (CreaseDefect& defect : list_between(labelled)) {
      defect.waits = lacks_corner;
      defects_.push_back(std::move(defect));
    }
  }

  /// Adds the parts beside corners without a generator. False if there is none.
  bool add_corners(const LabelledCurve& labelled) {
    if (labelled.curve.closed) return false;
    const auto& on_curve = labelled.generators;
    const bool lacks_first = !labelled.begins_at_generator, lacks_last = !labelled.ends_at_generator;
    // Without any generator, the whole curve is beside its first corner, and nothing is left for the last one.
    const double begin = on_curve.empty() ? labelled.length() : on_curve.front().at;
    const double end = on_curve.empty() ? labelled.length() : on_curve.back().at;
    const auto add = [&](VertexId corner, double length) {
      defects_.push_back({{vertex_point(mesh_, corner)}, length, true});
    };
    if (lacks_first) add(labelled.curve.vertices.front(), begin);
    if (lacks_last) add(labelled.curve.vertices.back(), labelled.length() - end);
    return lacks_first || lacks_last;
  }

  static CreaseDefect whole_curve(const LabelledCurve& labelled) {
    CreaseDefect defect{{}, labelled.length()};
    const bool is_empty = labelled.generators.empty();
    const double first = is_empty ? 0 : labelled.generators.front().at;
    for (int third = is_empty ? 0 : 1; third < 3; ++third) {
      defect.places.push_back(labelled.point(first + labelled.length() * third / 3));
    }
    return defect;
  }

  /// The defects between consecutive generators: foreign cells, and bends where there are none.
  std::vector<CreaseDefect> list_between(const LabelledCurve& labelled) const {
    const std::vector<GeneratorOnCurve> on_curve = labelled.closed_generators();
    std::vector<char> is_followed(on_curve.size(), 1);
    std::vector<CreaseDefect> defects;
    for (const ForeignCells& foreign : list_foreign(labelled.repeated_labels(), on_curve)) {
      defects.push_back({{labelled.point(find_place(labelled, on_curve, foreign))}, foreign.last() - foreign.first()});
      is_followed[foreign.index] = 0;
    }
    for (std::size_t i = 0; i + 1 < on_curve.size(); ++i) {
      const double begin = on_curve[i].at, end = on_curve[i + 1].at;
      if (is_followed[i] && cuts_off_bend(labelled, begin, end)) {
        defects.push_back({{labelled.point((begin + end) / 2)}, 0});
      }
    }
    return defects;
  }

  /// The length at which a generator is placed: see the table of find_crease_defects.
  double find_place(const LabelledCurve& labelled, const std::vector<GeneratorOnCurve>& on_curve,
                    const ForeignCells& foreign) const {
    const double begin = on_curve[foreign.index].at, end = on_curve[foreign.index + 1].at, length = end - begin;
    const GeneratorId intruder = foreign.longest();
    const CreaseCurve& curve = labelled.curve;
    if (!curve.closed && foreign.index == 0 && leaves(intruder, curve.vertices.front())) {
      return begin + shell_distance(length);
    }
    if (!curve.closed && foreign.index + 2 == on_curve.size() && leaves(intruder, curve.vertices.back())) {
      return end - shell_distance(length);
    }
    const double opposite = labelled.find_nearest(begin, end, position(mesh_, generators_[intruder.index()]));
    if (std::min(opposite - begin, end - opposite) >= kLeastEndShare * length) return opposite;
    return (foreign.first() + foreign.last()) / 2;
  }

  /// Whether an open curve with this generator on it ends at a corner.
  bool leaves(GeneratorId generator, VertexId corner) const {
    const auto ends = ends_of_curves_.find(generator);
    return ends != ends_of_curves_.end() &&
           std::find(ends->second.begin(), ends->second.end(), corner) != ends->second.end();
  }

  /// Whether the edge between two points of a curve, by their lengths, is long and cuts off a bend.
  bool cuts_off_bend(const LabelledCurve& labelled, double begin, double end) const {
    if (mesh_.is_boundary(labelled.curve.edges.front())) return false;
    const Vec3 a = position(mesh_, labelled.point(begin)), b = position(mesh_, labelled.point(end));
    const double chord = (b - a).norm();
    return chord > spacing_ && labelled.largest_distance(begin, end, {a, b}) > kLargestSagitta * chord;
  }

  const Mesh& mesh_;
  const std::vector<SurfacePoint>& generators_;
  double spacing_;
  std::vector<LabelledCurve> curves_;
  std::map<GeneratorId, std::vector<VertexId>> ends_of_curves_;  // of the open curves of each generator
  std::vector<CreaseDefect> defects_;
};

/// Adds the places of the defects that wait for a corner, or those of the others.
void add_places(const std::vector<CreaseDefect>& defects, bool waits, AddedGenerators& added) {
  for (const CreaseDefect& defect : defects) {
    if (defect.waits != waits) continue;
    for (const SurfacePoint& place : defect.places) added.add(place);
  }
}

}  // namespace

std::vector<CreaseDefect> find_crease_defects(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                              const Diagram& diagram, double spacing) {
  return DefectFinder(mesh, curves, diagram, spacing).run();
}

CreaseFollower::CreaseFollower(const Mesh& mesh, const std::vector<CreaseCurve>& creases, std::int64_t max_added,
                               double spacing)
    : mesh_(mesh), curves_(creases), max_added_(max_added), spacing_(spacing) {
  for (const CreaseCurve& curve : creases) {
    for (const EdgeId e : curve.edges) length_ += mesh.length(e);
  }
}

std::vector<SurfacePoint> CreaseFollower::propose(const Diagram& diagram, std::int64_t may_add) {
  if (curves_.empty()) return {};
  const std::vector<CreaseDefect> defects = find_crease_defects(mesh_, curves_, diagram, spacing_);
  double sum = 0;
  for (const CreaseDefect& defect : defects) sum += defect.length;
  gap_length_ = std::min(sum, length_);  // rounding alone can make the sum larger
  const std::int64_t most = std::min(may_add, max_added_ - added_);
  const bool wants_more = !defects.empty() && rounds_ < kCreaseRounds, may_add_decides = may_add < max_added_ - added_;
  is_held_back_ = wants_more && most <= 0 && may_add_decides;
  if (!wants_more || most <= 0) return {};
  ++rounds_;
  AddedGenerators added(mesh_, diagram.generators, most);
  // If no corner takes a generator, another one is too near to it, and there is nothing to wait for.
  for (const bool waits : {false, true}) {
    if (added.size() == 0) add_places(defects, waits, added);
  }
  is_held_back_ = added.is_full() && may_add_decides;
  added_ += static_cast<std::int64_t>(added.size());
  return added.take();
}

}  // namespace gvd
