#include "io/view/view_sample.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/barycentric.hpp"

namespace gvd::test {
namespace {

/// The part of a bisector inside one face, from `enters` to `leaves`, or to a branch point where `leaves` is invalid.
struct Segment {
  FaceId face;
  GeneratorId left, right;
  HalfedgeId enters, leaves;
  Bary from, to;
  BranchPointId end;
  bool used = false;
};

struct Sampler {
  const Mesh& mesh;
  Diagram diagram;
  std::vector<Segment> segments;
  std::map<GeneratorId, std::set<GeneratorId>> neighbours;

  GeneratorId label(VertexId v) const { return diagram.vertex_label[v]; }

  double distance(VertexId v, GeneratorId g) const {
    const Vec3 centre = position(mesh, diagram.generators[g.index()]);
    return std::acos(std::clamp(mesh.position(v).normalized().dot(centre.normalized()), -1.0, 1.0));
  }

  void label_vertices(int m) {
    for (int g = 0; g < m; ++g) {
      const double z = 1 - (2.0 * g + 1) / m, turn = 2.399963229728653 * g;  // a Fibonacci spiral
      const Vec3 wanted(std::sqrt(1 - z * z) * std::cos(turn), z, std::sqrt(1 - z * z) * std::sin(turn));
      VertexId best(0);
      for (int v = 0; v < mesh.vertex_count(); ++v) {
        if (mesh.position(VertexId(v)).dot(wanted) > mesh.position(best).dot(wanted)) best = VertexId(v);
      }
      diagram.generators.push_back(vertex_point(mesh, best));
    }
    for (int v = 0; v < mesh.vertex_count(); ++v) {
      GeneratorId best(0);
      for (int g = 1; g < m; ++g) {
        if (distance(VertexId(v), GeneratorId(g)) < distance(VertexId(v), best)) best = GeneratorId(g);
      }
      diagram.vertex_label.push_back(best);
      diagram.vertex_distance.push_back(distance(VertexId(v), best));
    }
    diagram.cells.resize(static_cast<std::size_t>(m));
    for (int g = 0; g < m; ++g) {
      diagram.cells[GeneratorId(g)].generator = GeneratorId(g);
      diagram.cells[GeneratorId(g)].euler_characteristic = 1;
      diagram.cells[GeneratorId(g)].components = 1;
      diagram.cells[GeneratorId(g)].boundary_loops = 1;
    }
  }

  /// Parameter from the start of the halfedge, in (0, 1), at which the distances of both labels are equal.
  double balance(HalfedgeId h) const {
    const VertexId u = mesh.from(h), v = mesh.to(h);
    const double at_u = distance(u, label(v)) - distance(u, label(u)),
                 at_v = distance(v, label(u)) - distance(v, label(v));
    return at_u + at_v > 0 ? std::clamp(at_u / (at_u + at_v), 0.02, 0.98) : 0.5;
  }

  Bary on_edge(FaceId f, int corner) const {
    const HalfedgeId h = Mesh::halfedge(f, corner), own = mesh.halfedge(mesh.edge(h));
    const double t = own == h ? balance(h) : 1 - balance(own);
    Bary bary{0, 0, 0};
    bary[corner] = 1 - t;
    bary[(corner + 1) % 3] = t;
    return bary;
  }

  static Bary at_corner(int corner) {
    Bary bary{0, 0, 0};
    bary[corner % 3] = 1;
    return bary;
  }

  double area(FaceId f, const std::vector<Bary>& corners) const {
    double sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Bary &a = corners[i], &b = corners[(i + 1) % corners.size()];
      sum += a[1] * b[2] - a[2] * b[1];
    }
    return sum * mesh.area(f);
  }

  void add_piece(FaceId f, GeneratorId g, std::vector<Bary> corners) {
    diagram.cells[g].area += area(f, corners);
    diagram.pieces.push_back({f, g, std::move(corners)});
  }

  void add_segment(const Segment& segment) {
    segments.push_back(segment);
    neighbours[segment.left].insert(segment.right);
    neighbours[segment.right].insert(segment.left);
  }

  /// The unused segment on the other side of h.
  Segment* across(HalfedgeId h) {
    for (Segment& s : segments) {
      if (!s.used && (s.enters == mesh.twin(h) || s.leaves == mesh.twin(h))) return &s;
    }
    return nullptr;
  }

  /// Links the segments that end in branch points to whole bisectors; on a sphere with many cells there are no others.
  void link_bisectors() {
    for (std::size_t i = 0; i < segments.size(); ++i) {
      Segment* s = &segments[i];
      if (s->used || s->leaves.valid()) continue;
      Bisector bisector;
      bisector.left = s->right;  // walked backwards, away from the branch point
      bisector.right = s->left;
      bisector.ends[0] = s->end;
      bisector.points = {{s->face, s->to}, {s->face, s->from}};
      s->used = true;
      for (HalfedgeId h = s->enters; h.valid() && (s = across(h)) != nullptr;) {
        const bool forwards = s->enters == mesh.twin(h);
        bisector.points.push_back({s->face, forwards ? s->to : s->from});
        h = forwards ? s->leaves : s->enters;
        s->used = true;
        if (!h.valid()) bisector.ends[1] = s->end;
      }
      for (std::size_t k = 1; k < bisector.points.size(); ++k) {
        diagram.length += (position(mesh, bisector.points[k]) - position(mesh, bisector.points[k - 1])).norm();
      }
      diagram.bisectors.push_back(std::move(bisector));
    }
  }

  void cut_in_three(FaceId f, const std::array<GeneratorId, 3>& labels) {
    const Bary centre{1.0 / 3, 1.0 / 3, 1.0 / 3};
    const SurfacePoint point{f, centre};
    const BranchPointId end =
        diagram.branch_points.push_back({point, position(mesh, point), {labels.begin(), labels.end()}, 0});
    for (int i = 0; i < 3; ++i) {
      add_piece(f, labels[std::size_t(i)], {at_corner(i), on_edge(f, i), centre, on_edge(f, (i + 2) % 3)});
      add_segment({f, labels[std::size_t((i + 1) % 3)], labels[std::size_t(i)], Mesh::halfedge(f, i), HalfedgeId(),
                   on_edge(f, i), centre, end});
    }
  }

  /// Corner `tip` has its own label, the other two share one.
  void cut_in_two(FaceId f, int tip, GeneratorId own, GeneratorId other) {
    const Bary first = on_edge(f, tip), second = on_edge(f, (tip + 2) % 3);
    add_piece(f, own, {at_corner(tip), first, second});
    add_piece(f, other, {first, at_corner(tip + 1), at_corner(tip + 2), second});
    add_segment({f, other, own, Mesh::halfedge(f, tip), Mesh::halfedge(f, (tip + 2) % 3), first, second, {}});
  }

  void cut_face(FaceId f) {
    const auto& [u, v, w] = mesh.vertices(f);
    const std::array<GeneratorId, 3> labels{label(u), label(v), label(w)};
    diagram.face_label.push_back(labels[0] == labels[1] && labels[1] == labels[2] ? labels[0] : GeneratorId());
    if (diagram.face_label[f].valid()) {
      diagram.cells[labels[0]].area += mesh.area(f);
    } else if (labels[0] != labels[1] && labels[1] != labels[2] && labels[2] != labels[0]) {
      cut_in_three(f, labels);
    } else {
      const int tip = labels[1] == labels[2] ? 0 : labels[2] == labels[0] ? 1 : 2;
      cut_in_two(f, tip, labels[std::size_t(tip)], labels[std::size_t((tip + 1) % 3)]);
    }
  }
};

}  // namespace

Diagram make_sphere_sample(const Mesh& sphere, int m) {
  Sampler sampler{sphere, {}, {}, {}};
  sampler.label_vertices(m);
  for (int f = 0; f < sphere.face_count(); ++f) sampler.cut_face(FaceId(f));
  sampler.link_bisectors();
  for (const auto& [g, others] : sampler.neighbours) {
    sampler.diagram.cells[g].neighbours.assign(others.begin(), others.end());
  }
  return std::move(sampler.diagram);
}

ViewScene make_remesh_sample(const Mesh& sphere, const Mesh& other) {
  ViewScene scene;
  scene.mesh = &sphere;
  scene.generators = scene.vertex_generators = sphere.positions();
  scene.overlay = ViewOverlay{"The other sphere", &other};
  scene.wireframe = true;
  scene.smooth = false;
  ViewSurfaceDistance& distance = scene.surface_distance.emplace();
  distance.other = "the other sphere";
  distance.reference = 4;
  distance.scale_end = kSampleBump;
  distance.samples.at_vertex = IdVector<VertexId, double>(static_cast<std::size_t>(sphere.vertex_count()), 0.0);
  constexpr int kSteps = 6;
  distance.samples.steps = IdVector<FaceId, std::int32_t>(static_cast<std::size_t>(sphere.face_count()), kSteps);
  for (int f = 0; f < sphere.face_count(); ++f) {
    for (int i = 0; i <= kSteps; ++i) {
      for (int j = 0; j <= kSteps - i; ++j) distance.samples.lattice.push_back(i == 2 && j == 2 ? kSampleBump : 0);
    }
  }
  return scene;
}

}  // namespace gvd::test
