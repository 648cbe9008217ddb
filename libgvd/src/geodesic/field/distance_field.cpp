#include "geodesic/field/distance_field.hpp"

namespace gvd {

Vec2 FaceSource::entry(const Vec2& p) const {
  if (is_corner) return image;
  // The areas that the line from the image to p cuts off on both sides: >= 0 where it stays inside of the interval.
  const double to_begin = cross(p - image, begin - image), to_end = cross(end - image, p - image);
  if (to_begin <= 0) return begin;
  if (to_end <= 0) return end;
  return begin + to_begin / (to_begin + to_end) * (end - begin);
}

}  // namespace gvd
