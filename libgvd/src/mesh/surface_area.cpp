#include "gvd/surface_area.hpp"

namespace gvd {

double compute_area(const Mesh& mesh) {
  double area = 0;
  for (std::int32_t f = 0; f < mesh.face_count(); ++f) area += mesh.area(FaceId(f));
  return area;
}

}  // namespace gvd
