#include "geodesic/windows/face_frames.hpp"

#include <algorithm>
#include <cmath>

#include "geodesic/windows/window.hpp"

namespace gvd {
namespace {

/// The sum of angles in [0, pi], as whole turns and the rest's cosine and sine: no inverse trigonometry.
struct Turning {
  double cosine = 1, sine = 0;
  double least_sine = 1;        // of the corners of the faces round the vertex
  std::int32_t half_turns = 0;  // how often the sum has crossed a multiple of pi

  void add(double c, double s, double least_sine_of_face) {
    const double turned_cosine = cosine * c - sine * s, turned_sine = sine * c + cosine * s;
    // One angle is at most pi: it crosses one multiple of pi at the most, and there the sine changes sign.
    half_turns += static_cast<std::int32_t>((turned_sine < 0) != (sine < 0));
    cosine = turned_cosine;
    sine = turned_sine;
    least_sine = std::min(least_sine, least_sine_of_face);
  }
  /// Whether the sum is `half` times pi, to within an angle below pi / 2 that has the sine `tolerance`.
  bool is_near(std::int32_t half, double tolerance) const {
    if (!(std::abs(sine) < tolerance) || (cosine > 0) != (half % 2 == 0)) return false;
    // The sine's sign is chance there: the last multiple is crossed or not. Two half turns more look the same but for
    // their number.
    return half_turns == half || half_turns == half - 1;
  }
};

/// A face whose least corner has less of a sine than this is a needle. Where a window's end lies on a long side is
/// rounded by kRounding of that side; seen over the length of a short one, this is an angle of kRounding over the least
/// sine, and for a needle more than kGrazingAngle.
constexpr double kNeedleSine = kRounding / kGrazingAngle;

/// A face whose least corner has less of a sine than this is thin. Round a tube of such faces windows wind up to 1 /
/// sine times before a shorter path beats them. Just above it, a spindle of 16 faces carries 42 windows a face.
constexpr double kThinSine = 0.05;

VertexKind kind_of(const Turning& total, bool boundary) {
  const std::int32_t straight = boundary ? 1 : 2;
  if (total.least_sine < kRounding) return VertexKind::ambiguous;
  if (total.least_sine < kNeedleSine && total.is_near(straight, kRounding / total.least_sine)) {
    return VertexKind::ambiguous;
  }
  if (total.is_near(straight, kFlatAngle)) return boundary ? VertexKind::plain : VertexKind::flat;
  if (total.half_turns < straight) return VertexKind::plain;
  return boundary ? VertexKind::reflex : VertexKind::saddle;
}

/// Sine of a face's widest angle where the face has no area, so that paths find the way across: from its middle corner
/// to what lies behind the longest side. Relative to the two sides at that angle, the shortest ones: their squares then
/// still add up (the height comes to 1e-24 of them), however unequal they are. It makes paths longer by 1e-12 of the
/// shorter one at the most.
constexpr double kLeastSine = 1e-12;

/// A face with less of its longest side's square than this is a sliver. Its area, as the mesh has it, is rounded by
/// 1e-16 of that square: above this it keeps 12 digits.
constexpr double kSliverArea = 1e-4;

/// Twice a sliver's area, from its two shortest sides: right to 1e-16 of their product, so that the angles of a needle
/// keep all digits, and above nothing.
double sliver_twice_area(const std::array<Vec3, 3>& side, const std::array<double, 3>& length) {
  const auto longest = static_cast<std::size_t>(std::max_element(length.begin(), length.end()) - length.begin());
  const std::size_t i = (longest + 1) % 3, j = (longest + 2) % 3;
  return std::max(side[i].cross(side[j]).stableNorm(), kLeastSine * length[i] * length[j]);
}

/// Faces whose frames one thread makes at a time.
constexpr std::size_t kChunkFaces = 1 << 12;

}  // namespace

FaceFrame make_face_frame(const Mesh& mesh, FaceId f) {
  FaceFrame frame{};
  const auto& corners = mesh.vertices(f);
  const FaceShape& shape = mesh.shape(f);
  std::array<Vec3, 3> side;
  for (std::size_t i = 0; i < 3; ++i) side[i] = mesh.position(corners[(i + 1) % 3]) - mesh.position(corners[i]);
  frame.length = shape.length;
  const double longest = std::max({shape.length[0], shape.length[1], shape.length[2]});
  const bool is_sliver = !(shape.twice_area > kSliverArea * longest * longest);
  const double twice_area = is_sliver ? sliver_twice_area(side, shape.length) : shape.twice_area;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t before = (i + 2) % 3;
    // From the sides themselves: the law of cosines would lose the digits of a needle's lengths.
    const double product = shape.length[i] * shape.length[before];
    // Two generators can come to lie on one point: a side without length stands upright on the others.
    const double scale = 1 / product;
    frame.cosine[i] = product > 0 ? -side[i].dot(side[before]) * scale : 0;
    frame.sine[i] = product > 0 ? twice_area * scale : 1;
    frame.vertex[i] = corners[i].value();
    frame.twin[i] = mesh.twin(Mesh::halfedge(f, static_cast<int>(i))).value();
  }
  return frame;
}

FaceFrames::FaceFrames(const Mesh& mesh, const ParallelChunks& parallel)
    : frame(static_cast<std::size_t>(mesh.face_count())), kind(static_cast<std::size_t>(mesh.vertex_count())) {
  const std::vector<Chunk> chunks = cut_into_chunks(frame.size(), kChunkFaces);
  parallel.run(chunks.size(), {"distances"}, [&](std::size_t i) {
    for (std::size_t f = chunks[i].begin; f < chunks[i].end; ++f) {
      const FaceId face(static_cast<std::int64_t>(f));
      frame[face] = make_face_frame(mesh, face);
    }
  });
  std::vector<Turning> total(kind.size());
  for (const FaceFrame& f : frame) {
    const double least_of_face = std::min({f.sine[0], f.sine[1], f.sine[2]});
    least_sine = std::min(least_sine, least_of_face);
    for (std::size_t i = 0; i < 3; ++i) {
      total[static_cast<std::size_t>(f.vertex[i])].add(f.cosine[i], f.sine[i], least_of_face);
    }
  }
  has_needles = least_sine < kNeedleSine;
  has_thin_faces = least_sine < kThinSine;
  for (std::int32_t i = 0; i < mesh.vertex_count(); ++i) {
    kind[VertexId(i)] = kind_of(total[static_cast<std::size_t>(i)], mesh.is_boundary(VertexId(i)));
  }
}

FaceFrames::FaceFrames(const Mesh& mesh) : FaceFrames(mesh, ParallelChunks(1, {})) {}

}  // namespace gvd
