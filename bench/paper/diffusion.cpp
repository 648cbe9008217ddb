// The diffusion diagram: the cell of a generator is where most heat comes from it ([8] in the paper).
//
// One implicit step of the heat equation is solved for each generator: lumped mass, cotangent Laplacian, one sparse
// factorisation, a column each. The label of a vertex is the generator from which most heat comes. In a face the heat
// of each generator is linear, so that a straight line parts two labels. A face with more of them is split at its
// midpoints, again and again, up to a cap; there three cells meet in the centre.
//
// Source: P. Herholz, F. Haase, M. Alexa, Diffusion diagrams: Voronoi cells and centroids from diffusion, 2017. It
// compares heat and no distance derived from it. Section 5.4 of the paper tells of distances instead, and of splits
// until their change is linear; here the labels alone end a split, so that no error of linear heat is noticed.
// Heat orders generators as distance does only for a short time step and far from boundaries, which reflect it. So
// labels near bisectors are wrong, and bisectors zig-zag with the triangles: figure 10 of the paper. The cost is m
// solutions of one factorised system, and m values at each vertex; the other methods store the nearest generators.
#include "diffusion.hpp"

#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/barycentric.hpp"
#include "clocks.hpp"
#include "comparators.hpp"
#include "gvd/error.hpp"
#include "mesh/working_mesh.hpp"
#include "pieces.hpp"

namespace gvd::paper {

namespace {

using Matrix = Eigen::SparseMatrix<double>;
using Entries = std::vector<Eigen::Triplet<double>>;

/// Faces without area get this height, relative to their longest side: cotangents stay finite.
constexpr double kLeastHeight = 1e-9;

/// The entries of one face: a third of its area to each corner, and the cotangents of its angles to its edges.
void add_face(const Mesh& mesh, FaceId f, double time, Entries& entries) {
  const auto& length = mesh.shape(f).length;
  const double longest = *std::max_element(length.begin(), length.end());
  const double twice_area = std::max(mesh.shape(f).twice_area, kLeastHeight * longest * longest);
  for (std::size_t i = 0; i < 3; ++i) {
    const int a = mesh.vertices(f)[i].value(), b = mesh.vertices(f)[(i + 1) % 3].value();
    const double own = length[i], left = length[(i + 1) % 3], right = length[(i + 2) % 3];
    const double cotangent = (left * left + right * right - own * own) / (2 * twice_area);
    const double weight = 0.5 * time * cotangent;
    entries.emplace_back(a, a, weight + twice_area / 6);
    entries.emplace_back(b, b, weight);
    entries.emplace_back(a, b, -weight);
    entries.emplace_back(b, a, -weight);
  }
}

/// M + t L, in units of the squared mean edge length, so that the mesh's unit does not matter.
Matrix build_matrix(const Mesh& mesh, double time) {
  Entries entries;
  entries.reserve(12 * mesh.face_count());
  for (const FaceId f : mesh.faces()) add_face(mesh, f, time, entries);
  Matrix matrix(mesh.vertex_count(), mesh.vertex_count());
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix / (mesh.mean_edge_length() * mesh.mean_edge_length());
}

}  // namespace

HeatField compute_heat(const Mesh& mesh, const std::vector<VertexId>& generators, double time) {
  const Eigen::SimplicialLDLT<Matrix> solver(build_matrix(mesh, time));
  if (solver.info() != Eigen::Success) {
    throw Error(ErrorCode::no_valid_result, "the heat equation's matrix can't be factorised");
  }
  HeatField field;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(mesh.vertex_count());
  for (const VertexId v : generators) {
    right[v.value()] = HeatField::kScale;
    const Eigen::VectorXd heat = solver.solve(right);
    right[v.value()] = 0;
    std::vector<double>& column = field.heat.emplace_back(heat.begin(), heat.end());
    for (double& value : column) value = value > HeatField::kFloor ? value : 0;
  }
  return field;
}

namespace {

/// Cuts a face where the linear fields of two generators' heat are equal.
///
/// A triangle whose corners have one label is whole: the fields are linear. Where corners and midpoints of sides have
/// two labels, the line on which their fields are equal cuts it. Otherwise it is split at the midpoints. At the cap,
/// three labels meet in its centre.
class HeatEnvelope {
 public:
  /// `most_splits`: the cap, >= 0. All arguments must outlive this.
  HeatEnvelope(const Mesh& mesh, const HeatField& field, int most_splits)
      : mesh_(mesh), field_(field), most_splits_(most_splits), label_(mesh.vertex_count()) {
    std::vector<double> most(label_.size(), 0);
    for (std::size_t g = 0; g < field.heat.size(); ++g) {
      for (std::size_t v = 0; v < most.size(); ++v) {
        if (!(field.heat[g][v] > most[v])) continue;
        most[v] = field.heat[g][v];
        label_.raw()[v] = GeneratorId(g);
      }
    }
  }

  /// Appends the pieces of face f; whether the cap ended a split.
  bool cut(FaceId f, Pieces& pieces) {
    face_ = f;
    capped_ = false;
    const auto& [a, b, c] = mesh_.vertices(f);
    if (label_[a] == label_[b] && label_[b] == label_[c]) {
      pieces.push_back({f, label_[a], whole_face()});
      return false;
    }
    find_candidates(f);
    cut({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, 0, pieces);
    return capped_;
  }

  /// The generator with the largest heat at a vertex, the lower one of equals; invalid where no heat arrives.
  GeneratorId warmest(VertexId v) const { return label_[v]; }

 private:
  using Triangle = std::array<Bary, 3>;

  /// A generator whose largest heat in the face is below another one's least heat there is left out.
  void find_candidates(FaceId f) {
    const auto& corners = mesh_.vertices(f);
    const auto form = [&](std::size_t g) {
      const auto& heat = field_.heat[g];
      return LinearForm{heat[corners[0].index()], heat[corners[1].index()], heat[corners[2].index()]};
    };
    candidates_.clear();
    forms_.clear();
    double most_of_least = 0;
    for (std::size_t g = 0; g < field_.heat.size(); ++g) {
      most_of_least = std::max(most_of_least, std::ranges::min(form(g)));
    }
    for (std::size_t g = 0; g < field_.heat.size(); ++g) {
      const double most = std::ranges::max(form(g));
      if (!(most > 0) || most < most_of_least) continue;
      candidates_.emplace_back(g);
      forms_.push_back(form(g));
    }
  }

  /// The heat at the face's corners. Where no heat arrives, none of the candidates does: then it is the floor.
  LinearForm heat(GeneratorId g) const {
    const auto it = std::find(candidates_.begin(), candidates_.end(), g);
    if (it == candidates_.end()) return {HeatField::kFloor, HeatField::kFloor, HeatField::kFloor};
    return forms_[it - candidates_.begin()];
  }

  GeneratorId warmest(const Bary& bary) const {
    GeneratorId best;
    double most = 0;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      const double heat = interpolate(bary, forms_[i][0], forms_[i][1], forms_[i][2]);
      if (!(heat > most)) continue;
      most = heat;
      best = candidates_[i];
    }
    return best;
  }

  LinearForm difference(GeneratorId a, GeneratorId b) const {
    const LinearForm first = heat(a), second = heat(b);
    return {first[0] - second[0], first[1] - second[1], first[2] - second[2]};
  }

  void cut(const Triangle& triangle, int splits, Pieces& pieces) {
    std::array<GeneratorId, 3> label;
    std::set<GeneratorId> labels;
    for (std::size_t i = 0; i < 3; ++i) labels.insert(label[i] = warmest(triangle[i]));
    if (labels.size() == 1) {
      pieces.push_back({face_, label[0], {triangle.begin(), triangle.end()}});
      return;
    }
    const Triangle middles{mix(triangle[0], triangle[1], 0.5), mix(triangle[1], triangle[2], 0.5),
                           mix(triangle[2], triangle[0], 0.5)};
    for (const Bary& middle : middles) labels.insert(warmest(middle));
    if (labels.size() == 2) {
      cut_in_two(triangle, *labels.begin(), *labels.rbegin(), pieces);
    } else if (splits < most_splits_) {
      for (std::size_t i = 0; i < 3; ++i) cut({triangle[i], middles[i], middles[(i + 2) % 3]}, splits + 1, pieces);
      cut(middles, splits + 1, pieces);
    } else {
      capped_ = true;
      join_in_centre(triangle, label, pieces);
    }
  }

  /// Both parts of a polygon on either side of the line on which two generators' heat is equal.
  void cut_in_two(const Triangle& triangle, GeneratorId a, GeneratorId b, Pieces& pieces) const {
    const Polygon polygon(triangle.begin(), triangle.end());
    for (const GeneratorId g : {a, b}) {
      Polygon part = clip_polygon(polygon, difference(g, g == a ? b : a), g == a);
      if (!part.empty()) pieces.push_back({face_, g, std::move(part)});
    }
  }

  /// Two labels at the corners: the line of these two. Three: their crossings with the sides meet in the centre.
  void join_in_centre(const Triangle& triangle, const std::array<GeneratorId, 3>& label, Pieces& pieces) const {
    const auto [least, most] = std::minmax({label[0], label[1], label[2]});
    if (label[0] == label[1] || label[1] == label[2] || label[2] == label[0]) {
      return cut_in_two(triangle, least, most, pieces);
    }
    Bary centre{};
    Triangle crossing;
    for (std::size_t i = 0; i < 3; ++i) {
      for (const Bary& corner : triangle) centre[i] += corner[i] / 3;
      const std::size_t j = (i + 1) % 3;
      const LinearForm form = difference(label[i], label[j]);
      const double from = evaluate(form, triangle[i]), to = evaluate(form, triangle[j]);
      crossing[i] = mix(triangle[i], triangle[j], from > to ? std::clamp(from / (from - to), 0.0, 1.0) : 0.5);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      pieces.push_back({face_, label[i], {triangle[i], crossing[i], centre, crossing[(i + 2) % 3]}});
    }
  }

  const Mesh& mesh_;
  const HeatField& field_;
  int most_splits_;
  IdVector<VertexId, GeneratorId> label_;
  FaceId face_;                          // the current one
  std::vector<GeneratorId> candidates_;  // that can be the warmest in it
  std::vector<LinearForm> forms_;        // their heat at its corners
  bool capped_ = false;
};

/// 4^12 triangles in one face are more than any time step needs.
constexpr int kMostSplits = 12;

/// Throws Error{invalid_option} for a value out of its range.
void check(const DiffusionOptions& options) {
  if (!(options.time_factor > 0) || !std::isfinite(options.time_factor)) {
    throw Error(ErrorCode::invalid_option, "the time factor of diffusion must be positive and finite");
  }
  if (options.most_splits < 0 || options.most_splits > kMostSplits) {
    throw Error(ErrorCode::invalid_option, "the number of splits must be between 0 and 12");
  }
}

}  // namespace

Comparison compute_diffusion(const Mesh& mesh, const std::vector<SurfacePoint>& generators,
                             const DiffusionOptions& options) {
  check(options);
  const WorkingMesh working(mesh, generators);
  const Mesh& copy = working.mesh();
  Comparison result;
  const double start = bench::cpu_milliseconds();
  const double time = options.time_factor * mesh.mean_edge_length() * mesh.mean_edge_length();
  const HeatField field = compute_heat(copy, working.generator_vertices().raw(), time);
  const double diffused = bench::cpu_milliseconds();
  HeatEnvelope envelope(copy, field, options.most_splits);
  Pieces pieces;
  for (const FaceId f : copy.faces()) result.faults.forced_faces += envelope.cut(f, pieces) ? 1 : 0;
  result.field_ms = diffused - start;
  result.diagram_ms = bench::cpu_milliseconds() - diffused;
  for (const VertexId v : copy.vertices()) result.faults.unreached_vertices += envelope.warmest(v).valid() ? 0 : 1;
  collect_pieces(mesh, generators, take_to_input(working, std::move(pieces)), result);
  return result;
}

}  // namespace gvd::paper
