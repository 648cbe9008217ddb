// Feeds the readers of generator lists: text, CSV, JSON, and the detection of the format. The first byte chooses. All
// of them may be curves, too, and OBJ and PLY as well.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/targets/require.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/generator_list.hpp"

namespace {

using namespace gvd;
using fuzz::attempt;
using fuzz::require;

/// Two squares that share an edge, each of two faces, and a face apart from them with a needle's angle.
Mesh make_mesh() {
  std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {2, 0, 1}, {0, 1, 0},   {1, 1, 0},
                              {2, 1, 1}, {5, 0, 0}, {6, 0, 0}, {6, 1e-6, 0}};
  std::vector<std::array<VertexId, 3>> faces;
  for (const std::array<int, 3>& f : {std::array{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {6, 7, 8}}) {
    faces.push_back({VertexId(f[0]), VertexId(f[1]), VertexId(f[2])});
  }
  return Mesh(std::move(positions), std::move(faces));
}

void check_point(const Mesh& mesh, const SurfacePoint& point) {
  require(point.face.valid() && point.face.value() < mesh.face_count(), "a generator is in no face");
  for (const double b : point.bary) require(b >= 0 && b <= 1, "a barycentric coordinate is out of range");
  require(std::abs(point.bary[0] + point.bary[1] + point.bary[2] - 1) <= 1e-9, "coordinates do not add up to 1");
}

bool same_bits(const SurfacePoint& a, const SurfacePoint& b) {
  return a.face == b.face && std::equal(a.bary.begin(), a.bary.end(), b.bary.begin(), [](double x, double y) {
           return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
         });
}

/// What was read must come back with the same bits from each format.
void check_written(const Mesh& mesh, const std::vector<SurfacePoint>& points) {
  for (const GeneratorFormat format :
       {GeneratorFormat::text, GeneratorFormat::csv, GeneratorFormat::json, GeneratorFormat::ply}) {
    attempt({}, [&] {
      const std::string content = format_generators(mesh, points, format);
      require(detect_generator_format(content) == format, "a written list is taken for another format");
      const auto again = resolve_generators(mesh, parse_generators(content, format, "the written list"));
      require(std::equal(points.begin(), points.end(), again.points.begin(), again.points.end(), same_bits),
              fmt::format("another list comes back from:\n{}", content));
    });
  }
}

void check_list(const std::string& content, GeneratorFormat format) {
  static const Mesh mesh = make_mesh();
  GeneratorList list;
  if (!attempt({ErrorCode::unreadable_input}, [&] { list = parse_generators(content, format, "list"); })) return;
  require(!list.entries.empty(), "a list without entries");
  for (const GeneratorEntry& entry : list.entries) {
    require(entry.index >= 0, "a negative index");
    require(entry.line >= 1 || format == GeneratorFormat::ply, "an entry without a line");
    for (const double value : entry.values) require(std::isfinite(value), "a number is not finite");
  }
  ResolveOptions options;
  options.merge_coincident = true;
  ResolvedGenerators resolved;
  if (!attempt({ErrorCode::precondition}, [&] { resolved = resolve_generators(mesh, list, options); })) return;
  require(resolved.points.size() + static_cast<std::size_t>(resolved.merged) == list.entries.size(), "lost entries");
  for (const SurfacePoint& point : resolved.points) check_point(mesh, point);
  check_written(mesh, resolved.points);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string content(reinterpret_cast<const char*>(data + 1), size - 1);
  const int choice = data[0] % 6;
  attempt({ErrorCode::unreadable_input, ErrorCode::precondition}, [&] {
    const CurveList curves = parse_curves(content, "curves");
    require(curves.curve.size() == curves.points.entries.size(), "a point of no curve");
    for (const auto& [a, b] : curves.segments) {
      require(a >= 0 && b >= 0 && std::max(a, b) < std::ssize(curves.curve), "a segment of no points");
      require(curves.curve[a] == curves.curve[b], "a segment between two curves");
    }
  });
  check_list(content, choice == 5 ? detect_generator_format(content) : static_cast<GeneratorFormat>(choice));
  return 0;
}
