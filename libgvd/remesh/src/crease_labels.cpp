// The cells and the generators along edges and along curves of edges.
//
// A face that is cut into pieces has the label intervals of its edges in the sides of its pieces. Joined edge by edge,
// they give the labels of a curve by length from its first vertex. The labels of an inner edge come from both of its
// faces, so each point of it is labelled twice. Lengths of a closed curve go on for a second way round, so that no
// search along it has to treat its first vertex apart.

#include "crease_labels.hpp"

#include <algorithm>
#include <cmath>

namespace gvd {

EdgeLabels::EdgeLabels(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), diagram_(diagram) {
  for (std::size_t i = 0; i < diagram.pieces.size(); ++i) first_piece_.try_emplace(diagram.pieces[i].face, i);
}

std::vector<LabelInterval> EdgeLabels::of(EdgeId edge) const {
  std::vector<LabelInterval> labels;
  const HalfedgeId h = mesh_.halfedge(edge), twin = mesh_.twin(h);
  append(h, true, labels);
  if (twin.valid()) append(twin, false, labels);
  return labels;
}

/// Appends the sides of the pieces of h's face that lie on h.
void EdgeLabels::append(HalfedgeId h, bool forwards, std::vector<LabelInterval>& labels) const {
  const FaceId f = Mesh::face(h);
  if (const GeneratorId whole = diagram_.face_label[f]; whole.valid()) labels.push_back({0, 1, whole});
  const auto first = first_piece_.find(f);
  if (first == first_piece_.end()) return;
  const int to = Mesh::corner(Mesh::next(h)), opposite = Mesh::corner(Mesh::previous(h));
  for (std::size_t i = first->second; i < diagram_.pieces.size() && diagram_.pieces[i].face == f; ++i) {
    const auto& corners = diagram_.pieces[i].corners;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto &a = corners[k], &b = corners[(k + 1) % corners.size()];
      if (a[opposite] != 0 || b[opposite] != 0) continue;
      const double from = forwards ? a[to] : 1 - a[to], end = forwards ? b[to] : 1 - b[to];
      labels.push_back({std::min(from, end), std::max(from, end), diagram_.pieces[i].generator});
    }
  }
}

/// A generator at the corner of an open curve with equal ends stands at both of them.
bool LabelledCurve::has_too_few() const {
  if (curve.vertices.front() != curve.vertices.back()) return false;
  return generators.size() < (curve.closed ? 3 : 4);
}

std::vector<GeneratorOnCurve> LabelledCurve::closed_generators() const {
  std::vector<GeneratorOnCurve> all = generators;
  if (curve.closed) all.push_back({generators.front().at + length(), generators.front().generator});
  return all;
}

std::vector<LabelInterval> LabelledCurve::repeated_labels() const {
  std::vector<LabelInterval> all = labels;
  if (!curve.closed) return all;
  for (const LabelInterval& l : labels) all.push_back({l.begin + length(), l.end + length(), l.cell});
  return all;
}

SurfacePoint LabelledCurve::point(double at) const {
  if (curve.closed) at = std::fmod(at, length());
  const auto edge = std::upper_bound(vertex_at.begin() + 1, vertex_at.end() - 1, at) - vertex_at.begin() - 1;
  const SurfacePoint p = point_on_curve(mesh, curve, edge, at - vertex_at[edge]);
  return make_surface_point(p.face, p.bary);
}

double LabelledCurve::at(std::size_t k) const {
  const std::size_t edges = curve.edges.size();
  return k < edges ? vertex_at[k] : vertex_at[k - edges] + length();
}

std::size_t LabelledCurve::first_after(double length) const {
  return std::upper_bound(vertex_at.begin(), vertex_at.end(), length) - vertex_at.begin();
}

double LabelledCurve::find_nearest(double begin, double end, const Vec3& to) const {
  double best = (begin + end) / 2, least = kInfinity;
  const std::size_t edges = curve.edges.size(), rounds = curve.closed ? 2 : 1;
  for (std::size_t k = first_after(begin) - 1; k < rounds * edges && at(k) <= end; ++k) {
    const double start = at(k);
    const Vec3 &a = mesh.position(curve.vertices[k % edges]), &b = mesh.position(curve.vertices[k % edges + 1]);
    const double length = (b - a).norm();
    if (start + length < begin || !(length > 0)) continue;
    const double here =
        std::clamp(start + (to - a).dot(b - a) / length, std::max(start, begin), std::min(start + length, end));
    const double squared = (a + (here - start) / length * (b - a) - to).squaredNorm();
    if (squared >= least) continue;
    least = squared;
    best = here;
  }
  return best;
}

double LabelledCurve::largest_distance(double begin, double end, const std::array<Vec3, 2>& line) const {
  const Vec3 way = (line[1] - line[0]).normalized();
  const std::size_t edges = curve.edges.size();
  double largest = 0;
  for (std::size_t k = first_after(begin); k < 2 * edges && at(k) < end; ++k) {
    const Vec3 to = mesh.position(curve.vertices[k % edges]) - line[0];
    largest = std::max(largest, (to - to.dot(way) * way).norm());
  }
  return largest;
}

namespace {

class CurveLabeller {
 public:
  CurveLabeller(const Mesh& mesh, const Diagram& diagram) : mesh_(mesh), labels_(mesh, diagram) {
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
  /// Adds the generator at a vertex; false where there is none.
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
    for (const LabelInterval& l : labels_.of(e)) {
      const double begin = forwards ? l.begin : 1 - l.end, end = forwards ? l.end : 1 - l.begin;
      labelled.labels.push_back({passed + length * begin, passed + length * end, l.cell});
    }
    labelled.vertex_at.push_back(passed + length);
  }

  const Mesh& mesh_;
  EdgeLabels labels_;
  std::map<EdgeId, std::vector<GeneratorOnCurve>> on_edge_;  // at parameters along the edge's halfedge
  std::map<VertexId, GeneratorId> at_vertex_;
};

}  // namespace

std::vector<LabelledCurve> label_curves(const Mesh& mesh, const std::vector<CreaseCurve>& curves,
                                        const Diagram& diagram) {
  const CurveLabeller labeller(mesh, diagram);
  std::vector<LabelledCurve> labelled;
  for (const CreaseCurve& curve : curves) labelled.push_back(labeller.label(curve));
  return labelled;
}

}  // namespace gvd
