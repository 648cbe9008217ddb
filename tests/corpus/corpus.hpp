#pragma once

#include <filesystem>
#include <vector>

namespace gvd::test {

/// The meshes of the corpus, sorted by name. They come from the folder that GVD_CORPUS names. Without it they are those
/// of Debian's package libcgal-demo, which an earlier test unpacks. Where that is missing too, a warning is printed,
/// and they are the few of the project's data folder.
std::vector<std::filesystem::path> corpus();

}  // namespace gvd::test
