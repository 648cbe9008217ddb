#include <filesystem>
#include <fstream>
#include <string>

#include "gvd/gvd.hpp"
#include "support/catch.hpp"

namespace gvd::test_version {

/// Whether a file of the repository has this text.
bool has(const char* file, const std::string& text) {
  std::ifstream stream(std::filesystem::path(GVD_SOURCE_DIR) / file);
  return std::string(std::istreambuf_iterator<char>(stream), {}).find(text) != std::string::npos;
}

TEST_CASE("the version is that of the changelog and the citation") {
  const std::string release(version());
  CHECK(has("CHANGELOG.md", "\n## " + release + " ("));
  CHECK(has("CITATION.cff", "\nversion: " + release + "\n"));
}

TEST_CASE("one header has the whole library") {
  const Mesh mesh({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{VertexId(0), VertexId(1), VertexId(2)}});
  CHECK(compute_diagram(mesh, {vertex_point(mesh, VertexId(0))}).cells.size() == 1);
}

}  // namespace gvd::test_version
