// Measures cells without a diagram, for the early iterations of a relaxation.
//
// The windows of a face tell which images of generators are near it, and thus the parts of cells in the face. Squared
// distances from two images differ by a linear function of the plane, so the parts form a lower envelope of linear
// functions. Each part is integrated at its centroid, with the spread of its points about the centroid, which is exact
// for quadratic functions. Computing energies and gradients takes about half the time of a diagram with its integrals.
// The parts of a face cover it without overlaps, so no area is lost or counted twice.
// Two counting sorts, by the second cell and then by the first, order the segments of bisectors in linear time.
#include "measured_cells.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

#include "base/plane.hpp"
#include "gvd/diagram_steps.hpp"
#include "lower_envelope.hpp"

namespace gvd {
namespace {

/// A counting sort, which keeps the order of segments with the same cell.
void sort_by(GeneratorId BisectorSegment::*cell, std::vector<BisectorSegment>& segments) {
  std::vector<std::size_t> begin;  // where each cell's segments begin
  for (const BisectorSegment& segment : segments) {
    const std::size_t next = (segment.*cell).index() + 1;
    if (begin.size() <= next) begin.resize(next + 1, 0);
    ++begin[next];
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<BisectorSegment> sorted(segments.size());
  for (const BisectorSegment& segment : segments) sorted[begin[(segment.*cell).index()]++] = segment;
  segments = std::move(sorted);
}

/// A face is far from generators if none is nearer than this, in units of its longest side.
constexpr double kFarDistance = 2;

/// Points of a face for which the nearest image is found: the centroid, and points near the corners and near the
/// middles of the sides, where most small parts of cells lie. Parts without such a point are missed, except parts of
/// direct images near generators.
constexpr std::array<Bary, 7> kProbes{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                       {0.96, 0.02, 0.02},
                                       {0.02, 0.96, 0.02},
                                       {0.02, 0.02, 0.96},
                                       {0.02, 0.49, 0.49},
                                       {0.49, 0.02, 0.49},
                                       {0.49, 0.49, 0.02}}};

/// Logarithms are smooth over a face if the logarithms of any two corners are at most this many times as far apart as
/// the corners. The factor is 1 in a plane, and 1.1 on a sphere at 0.75 radii from the generator.
constexpr double kMostStretch = 1.1;

/// The input of all threads.
struct MeasuredField {
  const WorkingMesh& working;
  const WindowField& windows;
  const Departures& departures;
  const IdVector<VertexId, Vec2>& log;  // of the vertices
  const Integrand& integrand;
};

/// Distance of the Gauss points from the middle of an interval of length 1: 1 / sqrt(12).
constexpr double kGaussPoint = 0.28867513459481287;

/// If a segment is shorter than this, in units of its distance from its generators, its middle replaces both Gauss
/// points. The square of a logarithm is then off by less than 1 / 1200.
constexpr double kShort = 0.1;

/// Measures the parts of cells in faces of the working mesh, face by face.
class FaceMeasurer {
 public:
  explicit FaceMeasurer(const MeasuredField& field)
      : sums(field.integrand.watched),
        field_(field),
        mesh_(field.working.mesh()),
        paths_(mesh_, field.windows, field.departures) {}

  void add(FaceId face) {
    face_ = face;
    if (has_one_label() && label(0).valid() && add_smooth()) return;
    paths_.enter(face);
    if (has_one_label()) {
      const NearestPath path = paths_.at(paths_.position(kProbes[0]));
      if (path.generator.valid() && path.generator == label(0)) return add_whole(path);
    }
    find_images();
    if (images_.empty()) return;
    for (const EnvelopePart& part : envelope_.compute(square_distances())) add(part);
  }

  /// Adds only the segments of bisectors in a face, and nothing to the sums. Skips faces with the same label at all
  /// corners, which hardly ever have segments.
  void add_segments_only(FaceId face) {
    face_ = face;
    if (has_one_label()) return;
    paths_.enter(face);
    find_images();
    if (images_.empty()) return;
    for (const EnvelopePart& part : envelope_.compute(square_distances())) add_sides(part);
  }

  CellSums sums;
  std::vector<BisectorSegment> segments;

 private:
  GeneratorId label(int corner) const { return field_.windows.label[mesh_.vertices(face_)[corner]]; }
  bool has_one_label() const { return label(0) == label(1) && label(1) == label(2); }
  double density_at(const Bary& point) const {
    return field_.integrand.density.at(field_.working.parent(face_), field_.working.parent_bary(face_, point));
  }

  /// The mean squared distance of the face's points from the face's centroid.
  double spread() const {
    double squares = 0;
    for (int i = 0; i < 3; ++i) squares += std::pow(mesh_.length(Mesh::halfedge(face_, i)), 2);
    return squares / 36;
  }

  /// Adds the whole face by the logarithms of its corners, if they are smooth, and returns whether it did. They are not
  /// smooth if paths to two corners pass on different sides of a vertex. Exact for the logarithms of a plane.
  bool add_smooth() {
    const auto& corners = mesh_.vertices(face_);
    Vec2 mean(0, 0);
    double squares = 0;
    for (int i = 0; i < 3; ++i) {
      const Vec2 &from = field_.log[corners[i]], &to = field_.log[corners[(i + 1) % 3]];
      const double longest = kMostStretch * mesh_.length(Mesh::halfedge(face_, i));
      if ((to - from).squaredNorm() > longest * longest) return false;
      mean += from / 3;
      squares += from.squaredNorm() / 3;
    }
    // In a plane, the squared distance at the centroid is less than the mean of the squares at the corners by four
    // times the spread.
    add_whole({label(0), std::sqrt(std::max(0.0, squares - 4 * spread())), mean});
    return true;
  }

  void add_whole(const NearestPath& path) {
    sums.add(path.generator, mesh_.area(face_), mesh_.area(face_) * density_at(kProbes[0]), path, spread());
  }

  /// Lists the images that the probes see and, near generators, all direct images, because there small parts of cells
  /// are not small compared with the cell. Direct images may count beyond the ends of their windows, too, because there
  /// they are no nearer than other images. Images of pseudo-sources could be nearer there.
  void find_images() {
    images_.clear();
    const bool takes_direct = !is_far();
    for (std::size_t image = 0; takes_direct && image < paths_.image_count(); ++image) {
      if (paths_.is_direct(image)) images_.push_back(image);
    }
    for (const Bary& probe : kProbes) {
      const std::size_t image = paths_.nearest_image(paths_.position(probe));
      if (image != NearestPaths::kNoImage && std::find(images_.begin(), images_.end(), image) == images_.end()) {
        images_.push_back(image);
      }
    }
  }

  bool is_far() const {
    double nearest = kInfinity, longest = 0;
    for (int i = 0; i < 3; ++i) {
      nearest = std::min(nearest, field_.windows.distance[mesh_.vertices(face_)[i]]);
      longest = std::max(longest, mesh_.length(Mesh::halfedge(face_, i)));
    }
    return nearest > kFarDistance * longest;
  }

  /// The squared distances of the images from the corners of the face. Differences of squared distances from two points
  /// are linear in the plane, so the envelope of these values has the true bisectors, except that bisectors of
  /// pseudo-sources become straight.
  const std::vector<std::array<double, 3>>& square_distances() {
    const std::array<Vec2, 3> corners{paths_.position({1, 0, 0}), paths_.position({0, 1, 0}),
                                      paths_.position({0, 0, 1})};
    values_.clear();
    for (const std::size_t image : images_) {
      const auto square = [&](const Vec2& corner) { return paths_.square_distance(image, corner); };
      values_.push_back({square(corners[0]), square(corners[1]), square(corners[2])});
    }
    return values_;
  }

  void add(const EnvelopePart& part) {
    const GeneratorId g = paths_.generator(images_[part.function]);
    const PolygonMoments polygon = polygon_moments(part);
    if (!(polygon.area > 0)) return;
    const NearestPath path = paths_.from(images_[part.function], paths_.position(polygon.centroid));
    sums.add(g, polygon.area, polygon.area * density_at(polygon.centroid), path, polygon.spread);
    add_sides(part);
  }

  void add_sides(const EnvelopePart& part) {
    for (std::size_t i = 0; i < part.corners.size(); ++i) {
      if (part.across[i] == kTriangleSide) continue;
      const std::size_t left = images_[part.function], right = images_[part.across[i]];
      if (!(paths_.generator(left) < paths_.generator(right))) continue;
      add_segment(left, right, paths_.position(part.corners[i]),
                  paths_.position(part.corners[(i + 1) % part.corners.size()]));
    }
  }

  struct PolygonMoments {
    double area = 0;
    Bary centroid{};
    double spread = 0;  // mean squared distance of the points from the centroid
  };

  /// The moments of a part, summed over the triangles of a fan.
  PolygonMoments polygon_moments(const EnvelopePart& part) const {
    PolygonMoments polygon;
    Vec2 centroid(0, 0);
    double second = 0;  // integral of the squared distance from the first corner
    const Vec2 origin = paths_.position(part.corners[0]);
    for (std::size_t i = 1; i + 1 < part.corners.size(); ++i) {
      const Vec2 u = paths_.position(part.corners[i]) - origin, v = paths_.position(part.corners[i + 1]) - origin;
      const double area = std::max(0.0, cross(u, v) / 2);
      polygon.area += area;
      for (std::size_t k = 0; k < 3; ++k) {
        polygon.centroid[k] += area * (part.corners[0][k] + part.corners[i][k] + part.corners[i + 1][k]) / 3;
      }
      centroid += area * (u + v) / 3;
      second += area * (u.squaredNorm() + v.squaredNorm() + u.dot(v)) / 6;
    }
    if (!(polygon.area > 0)) return polygon;
    for (double& coordinate : polygon.centroid) coordinate /= polygon.area;
    polygon.spread = std::max(0.0, second / polygon.area - (centroid / polygon.area).squaredNorm());
    return polygon;
  }

  /// Adds the segment from p to q of the bisector of two images. The difference of their squared distances has a slope
  /// of twice the distance between the images.
  void add_segment(std::size_t left, std::size_t right, const Vec2& p, const Vec2& q) {
    const auto excess = [&](const Vec2& at) {
      return paths_.square_distance(left, at) - paths_.square_distance(right, at);
    };
    const Vec2 middle = 0.5 * (p + q), aside = 0.5 * Vec2(p.y() - q.y(), q.x() - p.x());
    const double rise = std::abs(excess(middle + aside) - excess(middle - aside));
    BisectorSegment segment{paths_.generator(left), paths_.generator(right), (q - p).norm()};
    const bool is_short = (q - p).squaredNorm() < kShort * kShort * paths_.square_distance(left, middle);
    for (std::size_t k = 0; k < (is_short ? 1 : 2); ++k) {
      const double share = is_short ? 0 : k == 0 ? -kGaussPoint : kGaussPoint;
      const Vec2 at = middle + share * (q - p);
      segment.at_left[k] = paths_.from(left, at).log;
      segment.at_right[k] = paths_.from(right, at).log;
    }
    if (is_short) segment.at_left[1] = segment.at_left[0], segment.at_right[1] = segment.at_right[0];
    if (rise > 0) segment.weight = density_at(kProbes[0]) * 2 * (q - p).squaredNorm() / rise;
    segments.push_back(segment);
  }

  const MeasuredField& field_;
  const Mesh& mesh_;
  NearestPaths paths_;
  std::vector<std::size_t> images_;            // the images that have parts of the face
  std::vector<std::array<double, 3>> values_;  // the squared distances of the images from the corners
  LowerEnvelope envelope_;
  FaceId face_;
};

/// The logarithms of the vertices at their nearest generators; 0 for vertices of generators and vertices that none
/// reaches.
IdVector<VertexId, Vec2> vertex_logs(const WindowField& field, const Departures& departures) {
  IdVector<VertexId, Vec2> logs;
  for (const VertexId v : field.distance.ids()) {
    const bool has_path = field.label[v].valid() && field.distance[v] > 0;
    logs.push_back(Vec2::Zero());
    if (has_path) logs[v] = field.distance[v] * departures.direction(field.label[v], field.departure[v]);
  }
  return logs;
}

/// Calls measure(measurer, face) for all faces of the working mesh, in chunks that do not depend on the number of
/// threads. Returns the sums of the chunks, and adds their segments to the geometry.
template <class Measure>
std::vector<CellSums> measure_faces(const MeasuredField& field, const ParallelChunks& parallel, const Measure& measure,
                                    CellGeometry& geometry) {
  const auto faces = cut_into_chunks(field.working.mesh().face_count(), kScanChunk);
  std::vector<CellSums> sums(faces.size(), CellSums(field.integrand.watched));
  std::vector<std::vector<BisectorSegment>> segments(faces.size());
  parallel.run(faces.size(), {steps::kCells}, [&](std::size_t i) {
    FaceMeasurer measurer(field);
    for (std::size_t f = faces[i].begin; f < faces[i].end; ++f) measure(measurer, FaceId(f));
    sums[i] = std::move(measurer.sums);
    segments[i] = std::move(measurer.segments);
  });
  for (const auto& part : segments) geometry.segments.insert(geometry.segments.end(), part.begin(), part.end());
  sort_by_cells(geometry.segments);
  return sums;
}

/// The geometry without segments, for the vertices of the working mesh; the input's vertices come first.
CellGeometry begin_geometry(const WindowField& windows, const Departures& departures) {
  return {{}, windows.label, windows.distance, vertex_logs(windows, departures)};
}

void cut_to_input(const WorkingMesh& working, CellGeometry& geometry) {
  const std::size_t count = working.input().vertex_count();
  geometry.label.resize(count);
  geometry.vertex_distance.resize(count);
  geometry.log.resize(count, Vec2(0, 0));
}

}  // namespace

void sort_by_cells(std::vector<BisectorSegment>& segments) {
  sort_by(&BisectorSegment::right, segments);
  sort_by(&BisectorSegment::left, segments);
}

std::vector<std::pair<GeneratorId, GeneratorId>> neighbouring_cells(const std::vector<BisectorSegment>& segments) {
  std::vector<std::pair<GeneratorId, GeneratorId>> pairs;
  for (const BisectorSegment& segment : segments) pairs.emplace_back(segment.left, segment.right);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

CellGeometry find_geometry(const WorkingMesh& working, const WindowField& windows,
                           const std::vector<SurfacePoint>& generators, const Density& density,
                           const ParallelChunks& parallel) {
  const Departures departures(working, generators);
  CellGeometry geometry = begin_geometry(windows, departures);
  const WatchedGenerators none;
  const Integrand integrand{density, none};
  measure_faces(
      {working, windows, departures, geometry.log, integrand}, parallel,
      [](FaceMeasurer& measurer, FaceId f) { measurer.add_segments_only(f); }, geometry);
  cut_to_input(working, geometry);
  return geometry;
}

MeasuredCells measure_cells(const Mesh& mesh, const std::vector<SurfacePoint>& generators, const Integrand& integrand,
                            int threads, const Progress& progress) {
  const auto read = [&](const WorkingMesh& working, const WindowField& windows) {
    const Departures departures(working, generators);
    MeasuredCells cells{{}, begin_geometry(windows, departures)};
    const auto sums = measure_faces(
        {working, windows, departures, cells.geometry.log, integrand}, ParallelChunks(threads, progress),
        [](FaceMeasurer& measurer, FaceId f) { measurer.add(f); }, cells.geometry);
    cells.integrals = CellSums::join(generators.size(), sums);
    cut_to_input(working, cells.geometry);
    return cells;
  };
  PropagationOptions options;
  options.threads = threads;
  return read_windows(mesh, generators, options, progress, read);
}

}  // namespace gvd
