#include "corpus/corpus.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>

#include "support/catch.hpp"

namespace gvd::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> meshes_in(const char* folder) {
  constexpr std::array kExtensions{".obj", ".off", ".ply", ".stl"};
  std::vector<fs::path> files;
  if (folder == nullptr || !fs::is_directory(folder)) return files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string extension = entry.path().extension().string();
    if (std::count(kExtensions.begin(), kExtensions.end(), extension) > 0) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> corpus() {
  for (const char* variable : {"GVD_CORPUS", "GVD_UNPACKED_CORPUS"}) {
    std::vector<fs::path> files = meshes_in(std::getenv(variable));
    if (!files.empty()) return files;
  }
  WARN("skipped: real meshes, there are none in GVD_CORPUS and Debian's libcgal-demo is not installed; data/ instead");
  return meshes_in(GVD_SOURCE_DIR "/data");
}

}  // namespace gvd::test
