#include "support/models.hpp"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <fstream>

#include "gvd/error.hpp"
#include "support/catch.hpp"
#include "support/simple_obj.hpp"

namespace gvd::test {

static_assert(std::endian::native == std::endian::little, "the reference distances are little-endian");

namespace {

namespace fs = std::filesystem;

const std::string kSuffix = ".dist.f64";

/// Where models are looked for, the first place first. Places that are not there are left out.
std::vector<fs::path> model_folders() {
  const char* given = std::getenv("GVD_MODELS");
  const fs::path beside = fs::path(GVD_SOURCE_DIR) / ".." / "shared";
  std::vector<fs::path> folders{given ? given : "", beside / "models", beside / "reference", GVD_CORPUS_DIR};
  std::erase_if(folders, [](const fs::path& folder) { return !fs::is_directory(folder); });
  return folders;
}

void warn_missing(const std::string& what) {
  WARN("skipped: no " << what << " in GVD_MODELS, ../shared or Debian's libcgal-demo");
}

}  // namespace

std::optional<fs::path> find_model(const std::string& file) {
  for (const fs::path& folder : model_folders()) {
    for (const fs::path& path : {folder / file, (folder / file).replace_extension(".off")}) {
      if (fs::exists(path)) return path;
    }
  }
  warn_missing(file);
  return std::nullopt;
}

std::vector<std::string> list_references() {
  std::vector<std::string> names;
  for (const fs::path& folder : model_folders()) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      const std::string file = entry.path().filename().string();
      if (file.ends_with(kSuffix)) names.push_back(file.substr(0, file.size() - kSuffix.size()));
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  if (names.empty()) warn_missing("mesh with exact distances");
  return names;
}

Reference read_reference(const std::string& name) {
  const std::optional<fs::path> path = find_model(name + kSuffix);
  if (!path) throw Error(ErrorCode::unreadable_input, "there are no distances of " + name);
  const fs::path folder = path->parent_path();
  Reference reference{name, read_simple_obj(folder / (name + ".obj")), {}, {}};
  std::ifstream generators(folder / (name + ".generators.txt"));
  for (int v = 0; generators >> v;) reference.generators.emplace_back(v);
  const auto count = static_cast<std::size_t>(reference.mesh.vertex_count());
  std::ifstream distances(*path, std::ios::binary);
  for (std::size_t g = 0; g < reference.generators.size(); ++g) {
    std::vector<double>& row = reference.distances.emplace_back(count);
    distances.read(reinterpret_cast<char*>(row.data()), static_cast<std::streamsize>(count * sizeof(double)));
  }
  if (reference.generators.empty() || !distances || distances.peek() != std::ifstream::traits_type::eof()) {
    throw Error(ErrorCode::unreadable_input, "the distances of " + name + " do not fit its mesh");
  }
  return reference;
}

std::optional<Reference> find_reference(const std::string& name) {
  if (!find_model(name + kSuffix)) return std::nullopt;
  return read_reference(name);
}

std::vector<SurfacePoint> Reference::generator_points() const {
  std::vector<SurfacePoint> points;
  for (const VertexId v : generators) points.push_back(vertex_point(mesh, v));
  return points;
}

}  // namespace gvd::test
