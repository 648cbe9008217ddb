#include "geodesic/field/distance_field.hpp"

namespace gvd {

Vec2 FaceSource::entry(const Vec2& p) const {
  if (is_corner) return image;
  // Twice the areas between the line from the image to p and the two ends: >= 0 where the line crosses the opening.
  const double to_begin = cross(p - image, begin - image), to_end = cross(end - image, p - image);
  if (to_begin <= 0) return begin;
  if (to_end <= 0) return end;
  return begin + to_begin / (to_begin + to_end) * (end - begin);
}

}  // namespace gvd
