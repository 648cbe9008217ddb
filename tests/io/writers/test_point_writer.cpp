// Samples as PLY, XYZ and NPY, read back.
#include <array>
#include <bit>
#include <cstring>
#include <sstream>

#include "gvd/io/point_writer.hpp"
#include "gvd/surface_point.hpp"
#include "support/catch.hpp"
#include "support/generators.hpp"
#include "support/meshes.hpp"

namespace gvd::test_point_writer {

using Catch::Matchers::StartsWith;

const Mesh& sphere() {
  static const Mesh kMesh = test::make_sphere(1);
  return kMesh;
}

/// Points inside faces, on an edge and at a vertex, with areas that no short decimal number is.
std::vector<SurfaceSample> make_samples() {
  std::vector<SurfaceSample> samples;
  for (const SurfacePoint& p : test::random_generators(sphere(), 3, 7)) samples.push_back({p, 1.0 / 3, 0.1});
  samples.push_back({edge_point(sphere().halfedge(VertexId(4)), 0.3), 2.0 / 7, 1e-300});
  samples.push_back({vertex_point(sphere(), VertexId(2)), 0, 0});
  return samples;
}

/// The twelve numbers of a sample.
std::array<double, 12> columns(const SurfaceSample& s) {
  const Vec3 p = position(sphere(), s.point), n = surface_normal(sphere(), s.point);
  return {p.x(),           p.y(),           p.z(),           n.x(),  n.y(),   n.z(), double(s.point.face.value()),
          s.point.bary[0], s.point.bary[1], s.point.bary[2], s.area, s.energy};
}

std::string write(const std::vector<SurfaceSample>& samples, PointFormat format) {
  std::ostringstream out;
  write_points(out, sphere(), samples, format);
  return out.str();
}

template <class T>
T take(const std::string& bytes, std::size_t& at) {
  T value{};
  REQUIRE(at + sizeof(T) <= bytes.size());
  std::memcpy(&value, bytes.data() + at, sizeof(T));
  at += sizeof(T);
  return value;
}

TEST_CASE("point writer: NPY has the samples in rows of twelve doubles") {
  for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{5}}) {
    std::vector<SurfaceSample> samples = make_samples();
    samples.resize(count);
    const std::string bytes = write(samples, PointFormat::npy);
    REQUIRE(bytes.substr(0, 8) == std::string("\x93NUMPY\x01\x00", 8));
    std::size_t at = 8;
    const auto header = take<std::uint16_t>(bytes, at);
    CHECK((at + header) % 64 == 0);
    CHECK(bytes[at + header - 1] == '\n');
    CHECK_THAT(bytes.substr(at),
               StartsWith("{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(count) + ", 12), }"));
    at += header;
    for (const SurfaceSample& sample : samples) {
      for (const double value : columns(sample)) CHECK(take<double>(bytes, at) == value);
    }
    CHECK(at == bytes.size());
  }
}

TEST_CASE("point writer: PLY names its properties and has the same doubles") {
  const std::vector<SurfaceSample> samples = make_samples();
  const std::string bytes = write(samples, PointFormat::ply);
  CHECK_THAT(bytes, StartsWith("ply\nformat binary_little_endian 1.0\nelement vertex 5\nproperty double x\n"));
  const std::string end =
      "property double nz\nproperty int face\nproperty double b0\nproperty double b1\n"
      "property double b2\nproperty double area\nproperty double energy\nend_header\n";
  std::size_t at = bytes.find(end);
  REQUIRE(at != std::string::npos);
  at += end.size();
  for (const SurfaceSample& sample : samples) {
    const std::array<double, 12> expected = columns(sample);
    for (std::size_t i = 0; i < 12; ++i) {
      CHECK((i == 6 ? double(take<std::int32_t>(bytes, at)) : take<double>(bytes, at)) == expected[i]);
    }
  }
  CHECK(at == bytes.size());
}

TEST_CASE("point writer: XYZ has position and normal in each line") {
  const std::vector<SurfaceSample> samples = make_samples();
  std::istringstream lines(write(samples, PointFormat::xyz));
  for (const SurfaceSample& sample : samples) {
    std::string line;
    REQUIRE(std::getline(lines, line));
    std::istringstream numbers(line);
    for (std::size_t i = 0; i < 6; ++i) {
      std::string number;
      numbers >> number;
      CHECK(std::stod(number) == columns(sample)[i]);
    }
    CHECK((numbers >> std::ws).eof());
  }
  CHECK(lines.peek() == std::char_traits<char>::eof());
}

}  // namespace gvd::test_point_writer
