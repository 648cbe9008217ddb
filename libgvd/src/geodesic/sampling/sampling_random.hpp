#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "gvd/mesh.hpp"
#include "gvd/surface_point.hpp"

namespace gvd {

/// Two points of a sampling never lie closer than this part of the bounding box's diagonal: what else in the library
/// takes two generators for one begins there.
inline constexpr double kLeastSpacing = 1e-12;

/// Random numbers that are the same on every platform: the standard fixes the engine, and not its distributions.
class SeededRandom {
 public:
  explicit SeededRandom(std::uint64_t seed) : engine_(seed) {}
  /// In [0, 1), a multiple of 2^-53.
  double real() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

/// Draws faces with a chance in proportion to their area.
class AreaSampler {
 public:
  /// Draws from all faces of `mesh`, in the order of `faces`.
  AreaSampler(const Mesh& mesh, std::vector<FaceId> faces);

  /// Area of all faces, square mesh units.
  double area() const { return sums_.back(); }
  std::size_t size() const { return faces_.size(); }
  /// A face among the places [first, last) of the list; the last of them where they have no area.
  FaceId draw_face(SeededRandom& random, std::size_t first, std::size_t last) const;
  /// A point inside any face, uniform by area.
  SurfacePoint draw_point(SeededRandom& random) const;

 private:
  std::vector<FaceId> faces_;
  std::vector<double> sums_;  // area of the faces before each place, and of all
};

/// `count` points inside faces, uniform by area, no two closer than kLeastSpacing.
/// Throws Error{precondition} where the mesh has no area, or no room.
std::vector<SurfacePoint> sample_random(const Mesh& mesh, std::int64_t count, std::uint64_t seed);

/// All faces in order.
std::vector<FaceId> list_faces(const Mesh& mesh);

/// Sum of the face areas, square mesh units.
double compute_area(const Mesh& mesh);

/// The same. Throws Error{precondition} where it is 0 or not finite.
double require_area(const Mesh& mesh);

}  // namespace gvd
