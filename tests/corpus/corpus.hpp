#pragma once

#include <filesystem>
#include <vector>

namespace gvd::test {

/// The meshes of the corpus, sorted by name: those of the folder that GVD_CORPUS names, or else those of Debian's
/// package libcgal-demo, which an earlier test unpacks, or else, with a warning, the few of the project's data folder.
std::vector<std::filesystem::path> corpus();

}  // namespace gvd::test
