#pragma once

#include <filesystem>
#include <vector>

namespace gvd::test {

/// Meshes to try everything on, by name: those of the folder that GVD_CORPUS names; or those of Debian's package
/// libcgal-demo, which the test before this one unpacks; or, with a word, the few of the project's own data folder.
std::vector<std::filesystem::path> corpus();

}  // namespace gvd::test
