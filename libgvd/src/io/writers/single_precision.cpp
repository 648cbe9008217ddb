// Measures the effect of 32-bit floats on positions: which meshes they can't hold, how far they move vertices, and
// where GLB puts its origin.
//
// A float has 24 bits, so a survey at a northing of 5,400,000 m is stored in steps of half a metre, whatever its size.
// STL, GIFTI and FreeSurfer's surfaces have only floats, so users can only be warned. A node of GLB has a translation,
// written as numbers of JSON, and the positions of a mesh far from the origin are relative to it. The coordinates of
// the translation are floats themselves, because most readers store them as floats, and multiples of a power of two
// near the mesh's size, so that they have few digits and positions lose next to nothing when they are subtracted.
// Invariant: near the origin there is no translation, and the file holds the positions themselves.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "io/writers/format_writers.hpp"

namespace gvd::io {
namespace {

using SingleLimits = std::numeric_limits<float>;
using Vec3f = Eigen::Vector3f;

/// A mesh counts as far from the origin if a coordinate exceeds its diagonal this many times. Floats round by 2^-24 of
/// a coordinate, so farther away they round by more than 2^-20 of the diagonal, which is a thousandth of an edge in a
/// mesh with a million faces.
constexpr double kFarDiagonals = 16;

/// The translation of GLB is a multiple of a power of two of at most this fraction of the diagonal. Local coordinates
/// are then less than the diagonal.
constexpr double kTranslationGrid = 1.0 / 4;

/// A face counts as damaged if a corner moves by more than this fraction of its mean edge, which changes angles by
/// about a degree.
constexpr double kDamagedEdge = 1.0 / 64;

/// The damage is reported if damaged faces have more than this share of the area. The needles that cutting leaves have
/// less.
constexpr double kDamagedShare = 1e-3;

Eigen::AlignedBox3d bounding_box(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : mesh.positions()) box.extend(p);
  return box;
}

bool is_far(const Mesh& mesh) { return mesh.largest_coordinate() > kFarDiagonals * mesh.bbox_diagonal(); }

}  // namespace

Vec3 glb_translation(const Mesh& mesh) {
  if (!is_far(mesh)) return Vec3::Zero();
  const Vec3 centre = bounding_box(mesh).center();
  const double grid = std::exp2(std::floor(std::log2(kTranslationGrid * mesh.bbox_diagonal())));
  Vec3 translation = Vec3::Zero();
  for (int i = 0; i < 3; ++i) {
    if (std::abs(centre[i]) <= mesh.bbox_diagonal()) continue;  // this axis loses nothing
    // A grid finer than doubles at the centre, or none at all, as for a single point, leaves the centre.
    const double multiple = grid > 0 ? std::round(centre[i] / grid) * grid : centre[i];
    translation[i] = static_cast<double>(static_cast<float>(std::isfinite(multiple) ? multiple : centre[i]));
  }
  return translation;
}

std::string why_not_floats(const Mesh& mesh, const Vec3& origin) {
  const double largest = mesh.largest_coordinate();
  if (largest > SingleLimits::max()) return fmt::format("the coordinate {} is too large for one", largest);
  // A mesh smaller than the distance between neighbouring floats at its largest coordinate would collapse.
  const double local = origin.isZero(0) ? largest : largest_local_coordinate(mesh, origin);
  const double step = std::max<double>(local * SingleLimits::epsilon(), SingleLimits::min());
  if (mesh.bbox_diagonal() > step) return "";
  return fmt::format("a mesh of size {} at the coordinate {} is smaller than the distance between neighbouring floats",
                     mesh.bbox_diagonal(), largest);
}

double largest_local_coordinate(const Mesh& mesh, const Vec3& origin) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, (p - origin).cwiseAbs().maxCoeff());
  return largest;
}

PositionLoss measure_float_loss(const Mesh& mesh, const Vec3& origin) {
  PositionLoss loss;
  double area = 0, damaged = 0;
  for (const FaceId f : mesh.faces()) {
    std::array<Vec3f, 3> rounded;
    double moved = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 local = mesh.position(mesh.vertices(f)[i]) - origin;
      rounded[i] = local.cast<float>();
      moved = std::max(moved, (rounded[i].cast<double>() - local).norm());
    }
    loss.farthest_move = std::max(loss.farthest_move, moved);
    const Vec3 u = (rounded[1] - rounded[0]).cast<double>(), v = (rounded[2] - rounded[0]).cast<double>();
    if (mesh.area(f) > 0 && u.cross(v).isZero(0)) ++loss.collapsed_faces;
    const auto& length = mesh.shape(f).length;
    area += mesh.area(f);
    if (moved > kDamagedEdge * (length[0] + length[1] + length[2]) / 3) damaged += mesh.area(f);
  }
  loss.is_notable = damaged > kDamagedShare * area;
  return loss;
}

}  // namespace gvd::io
