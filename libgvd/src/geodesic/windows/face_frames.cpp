// Lengths, angles and kinds of faces and vertices for the propagation, in one place for the cache.
//
// Idea: cosines and sines of the corners come from the sides' vectors, and the total angle of a vertex from products of
// them. Therefore no window needs a division by a length, and no vertex needs an inverse trigonometric function.
// Source: the kinds of vertices are those of Mitchell, Mount and Papadimitriou (1987): shortest paths bend only at
// saddles and at reflex vertices of the boundary.
// Invariant: if rounding hides the kind of a vertex at needles, the vertex sends windows in all directions, which is
// always correct.
#include "geodesic/windows/face_frames.hpp"

#include <algorithm>
#include <cmath>

#include "geodesic/windows/window_geometry.hpp"
#include "gvd/diagram_steps.hpp"
#include "mesh/vertex_ring.hpp"

namespace gvd {
namespace {

/// A sum of angles in [0, pi], kept as a number of half turns with its cosine and sine, so that no inverse
/// trigonometric function is needed.
struct AngleSum {
  double cosine = 1, sine = 0;
  double least_sine = 1;        // least sine of the corners of the faces round the vertex
  std::int32_t half_turns = 0;  // number of multiples of pi that the sum has crossed

  void add(double c, double s, double least_sine_of_face) {
    const double turned_cosine = cosine * c - sine * s, turned_sine = sine * c + cosine * s;
    // One angle is at most pi, so it crosses at most one multiple of pi. The sine changes its sign there.
    half_turns += (turned_sine < 0) != (sine < 0) ? 1 : 0;
    cosine = turned_cosine;
    sine = turned_sine;
    least_sine = std::min(least_sine, least_sine_of_face);
  }
  /// Whether the sum is `half` times pi, to within an angle below pi / 2 that has the sine `tolerance`.
  bool is_near(std::int32_t half, double tolerance) const {
    if (!(std::abs(sine) < tolerance) || (cosine > 0) != (half % 2 == 0)) return false;
    // The sine's sign is chance near a multiple of pi, so the last multiple may or may not have been counted. Sums
    // that differ by two half turns have the same cosine and sine; only their count tells them apart.
    return half_turns == half || half_turns == half - 1;
  }
};

/// A face with a corner of a smaller sine than this is a needle. The position of a window's end on a long side is
/// rounded by kPositionRounding of that side. Over the length of a short side this is an angle of kPositionRounding
/// over the least sine, which for a needle is more than kGrazingAngle.
constexpr double kNeedleSine = kPositionRounding / kGrazingAngle;

/// A face with a corner of a smaller sine than this is thin. Windows wind round a tube of such faces up to 1 / sine
/// times before a shorter path beats them. Just above this bound, a spindle of 16 faces carries 42 windows a face.
constexpr double kThinSine = 0.05;

VertexKind kind_of(const AngleSum& total, bool boundary) {
  const std::int32_t straight = boundary ? 1 : 2;
  if (total.least_sine < kPositionRounding) return VertexKind::ambiguous;
  if (total.least_sine < kNeedleSine && total.is_near(straight, kPositionRounding / total.least_sine)) {
    return VertexKind::ambiguous;
  }
  if (total.is_near(straight, kFlatAngle)) return boundary ? VertexKind::plain : VertexKind::flat;
  if (total.half_turns < straight) return VertexKind::plain;
  return boundary ? VertexKind::reflex : VertexKind::saddle;
}

/// The sine that the widest angle of a face without area gets, so that paths can cross the face from its middle corner
/// through the longest side. It is relative to the two shorter sides, so that lengths still agree however unequal these
/// are: the square of the height is 1e-24 of their squares. Paths become longer by at most 1e-12 of the shorter side.
constexpr double kLeastSine = 1e-12;

/// Least height of a face on its longest side, as a fraction of that side, for which the mesh's area is accurate. That
/// area has an error of 1e-16 of the side's square, so that faces with a larger height keep 12 digits.
constexpr double kAccurateHeight = 1e-4;

/// Twice the area of a face whose height is less, computed from its two shortest sides. The error is 1e-16 of their
/// product, so that the angles of a needle keep all digits. The result is never zero unless a side has no length.
double twice_area_from_short_sides(const std::array<Vec3, 3>& side, const std::array<double, 3>& length) {
  const auto longest = std::max_element(length.begin(), length.end()) - length.begin();
  const auto i = (longest + 1) % 3, j = (longest + 2) % 3;
  return std::max(side[i].cross(side[j]).stableNorm(), kLeastSine * length[i] * length[j]);
}

/// Number of faces whose frames one thread makes at a time.
constexpr std::size_t kFramesPerChunk = 1 << 12;

}  // namespace

FaceFrame make_face_frame(const Mesh& mesh, FaceId f) {
  FaceFrame frame{};
  const auto& corners = mesh.vertices(f);
  const FaceShape& shape = mesh.shape(f);
  std::array<Vec3, 3> side;
  for (std::size_t i = 0; i < 3; ++i) side[i] = mesh.position(corners[(i + 1) % 3]) - mesh.position(corners[i]);
  frame.length = shape.length;
  const double longest = std::max({shape.length[0], shape.length[1], shape.length[2]});
  const bool is_accurate = shape.twice_area > kAccurateHeight * longest * longest;
  const double twice_area = is_accurate ? shape.twice_area : twice_area_from_short_sides(side, shape.length);
  for (int i = 0; i < 3; ++i) {
    const int before = (i + 2) % 3;
    // This uses the vectors of the sides, because the law of cosines would lose the digits of a needle's lengths.
    const double product = shape.length[i] * shape.length[before];
    // Two generators can lie at the same point. A side without length counts as perpendicular to the others.
    const double scale = 1 / product;
    frame.cosine[i] = product > 0 ? -side[i].dot(side[before]) * scale : 0;
    frame.sine[i] = product > 0 ? twice_area * scale : 1;
    frame.vertex[i] = first_copy(corners[i]);
    frame.twin[i] = mesh.twin(Mesh::halfedge(f, i));
  }
  return frame;
}

FaceFrames::FaceFrames(const Mesh& mesh, const ParallelChunks& parallel)
    : frame(mesh.face_count()), kind(mesh.vertex_count()) {
  const std::vector<Chunk> chunks = cut_into_chunks(frame.size(), kFramesPerChunk);
  parallel.run(chunks.size(), {steps::kDistances}, [&](std::size_t i) {
    for (std::size_t f = chunks[i].begin; f < chunks[i].end; ++f) frame[FaceId(f)] = make_face_frame(mesh, FaceId(f));
  });
  IdVector<VertexCopyId, AngleSum> total(kind.size());
  for (const FaceFrame& f : frame) {
    const double least_of_face = std::min({f.sine[0], f.sine[1], f.sine[2]});
    least_sine = std::min(least_sine, least_of_face);
    for (std::size_t i = 0; i < 3; ++i) {
      total[f.vertex[i]].add(f.cosine[i], f.sine[i], least_of_face);
    }
  }
  set_least_sine(least_sine);
  for (const VertexId v : mesh.vertices()) {
    kind[first_copy(v)] = kind_of(total[first_copy(v)], mesh.is_boundary(v));
  }
}

void FaceFrames::set_least_sine(double least) {
  least_sine = least;
  has_needles = least_sine < kNeedleSine;
  has_thin_faces = least_sine < kThinSine;
}

void FaceFrames::update(const Mesh& mesh, std::span<const FaceId> changed) {
  frame.resize(mesh.face_count());
  kind.resize(mesh.vertex_count());
  for (const FaceId f : changed) frame[f] = make_face_frame(mesh, f);
  std::vector<VertexId> vertices;
  for (const FaceId f : changed) vertices.insert(vertices.end(), mesh.vertices(f).begin(), mesh.vertices(f).end());
  std::ranges::sort(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  std::vector<HalfedgeId> outgoing;
  for (const VertexId v : vertices) {
    outgoing.clear();
    for_each_outgoing(mesh, v, [&](HalfedgeId h) { outgoing.push_back(h); });
    std::ranges::sort(outgoing);  // rounding of the sum depends on the order
    AngleSum total;
    for (const HalfedgeId h : outgoing) {
      const FaceFrame& around = frame[Mesh::face(h)];
      total.add(around.cosine[Mesh::corner(h)], around.sine[Mesh::corner(h)], least_sine_of(Mesh::face(h)));
    }
    kind[first_copy(v)] = kind_of(total, mesh.is_boundary(v));
  }
}

CornerAngles::CornerAngles(const Mesh& mesh, const FaceFrames& frames, const ParallelChunks& parallel)
    : corner_(mesh.halfedge_count()), side_(mesh.halfedge_count()) {
  const auto faces = cut_into_chunks(mesh.face_count(), kScanChunk);
  parallel.run(faces.size(), {steps::kDistances}, [&](std::size_t chunk) {
    for (std::size_t i = faces[chunk].begin; i < faces[chunk].end; ++i) {
      const FaceFrame& f = frames.frame[FaceId(i)];
      for (int k = 0; k < 3; ++k) {
        corner_[Mesh::halfedge(FaceId(i), k)] = Departure::of_angle(std::atan2(f.sine[k], f.cosine[k]));
      }
    }
  });
  const auto vertices = cut_into_chunks(mesh.vertex_count(), kScanChunk);
  parallel.run(vertices.size(), {steps::kDistances}, [&](std::size_t chunk) {
    for (std::size_t i = vertices[chunk].begin; i < vertices[chunk].end; ++i) {
      double sum = 0;
      for_each_outgoing(mesh, VertexId(i), [&](HalfedgeId h) {
        side_[h] = Departure::of_side(sum);
        sum += corner_[h].turned();
      });
    }
  });
}

}  // namespace gvd
