#include <fmt/format.h>

#include <iterator>

#include "gvd/generator_list.hpp"

namespace gvd {
namespace {

// fmt writes a double with the fewest digits that read back to the same bits, whatever the locale.

std::string text_of(const std::vector<SurfacePoint>& points) {
  std::string out = "# generators: face b0 b1 b2\n";
  for (const auto& [face, bary] : points) {
    fmt::format_to(std::back_inserter(out), "{} {} {} {}\n", face.value(), bary[0], bary[1], bary[2]);
  }
  return out;
}

std::string csv_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "face,b0,b1,b2,x,y,z\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{},{},{},{},{},{},{}\n", point.face.value(), point.bary[0], point.bary[1],
                   point.bary[2], p.x(), p.y(), p.z());
  }
  return out;
}

std::string json_of(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  std::string out = "{\"schema\":\"gvd-generators/1\",\"generators\":[";
  const char* separator = "\n";
  for (const SurfacePoint& point : points) {
    const Vec3 p = position(mesh, point);
    fmt::format_to(std::back_inserter(out), "{}{{\"face\":{},\"bary\":[{},{},{}],\"position\":[{},{},{}]}}", separator,
                   point.face.value(), point.bary[0], point.bary[1], point.bary[2], p.x(), p.y(), p.z());
    separator = ",\n";
  }
  return out + "\n]}\n";
}

}  // namespace

std::string format_generators(const Mesh& mesh, const std::vector<SurfacePoint>& points, GeneratorFormat format) {
  switch (format) {
    case GeneratorFormat::csv:
      return csv_of(mesh, points);
    case GeneratorFormat::json:
      return json_of(mesh, points);
    case GeneratorFormat::text:
      break;
  }
  return text_of(points);
}

}  // namespace gvd
