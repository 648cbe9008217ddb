#include "support/reference.hpp"

#include <algorithm>
#include <bit>
#include <fstream>

#include "gvd/error.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test {

static_assert(std::endian::native == std::endian::little, "the reference distances are little-endian");

namespace {

const std::string kSuffix = ".dist.f64";

}  // namespace

std::vector<std::string> list_references(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string file = entry.path().filename().string();
    if (file.ends_with(kSuffix)) names.push_back(file.substr(0, file.size() - kSuffix.size()));
  }
  std::sort(names.begin(), names.end());
  return names;
}

Reference read_reference(const std::filesystem::path& folder, const std::string& name) {
  Reference reference{name, read_simple_obj(folder / (name + ".obj")), {}, {}};
  std::ifstream generators(folder / (name + ".generators.txt"));
  for (int v = 0; generators >> v;) reference.generators.emplace_back(v);
  const auto count = static_cast<std::size_t>(reference.mesh.vertex_count());
  std::ifstream distances(folder / (name + kSuffix), std::ios::binary);
  for (std::size_t g = 0; g < reference.generators.size(); ++g) {
    std::vector<double>& row = reference.distances.emplace_back(count);
    distances.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(count * sizeof(double)));
  }
  if (reference.generators.empty() || !distances || distances.peek() != std::ifstream::traits_type::eof()) {
    throw Error(ErrorCode::unreadable_input, "the distances of " + name + " do not fit its mesh");
  }
  return reference;
}

std::vector<SurfacePoint> Reference::generator_points() const {
  std::vector<SurfacePoint> points;
  for (const VertexId v : generators) points.push_back(vertex_point(mesh, v));
  return points;
}

}  // namespace gvd::test
