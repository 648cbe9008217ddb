#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>

#include "support/catch.hpp"

namespace gvd::test {

/// Folder with reference distances and larger models, where there is one: the environment variable GVD_SHARED, or
/// `../shared` beside the project.
inline std::optional<std::filesystem::path> shared_folder() {
  const char* given = std::getenv("GVD_SHARED");
  const std::filesystem::path folder = given ? given : std::filesystem::path(GVD_SOURCE_DIR) / ".." / "shared";
  if (std::filesystem::exists(folder / "reference")) return folder;
  WARN("skipped: no shared data at " + folder.string() + " (set GVD_SHARED)");
  return std::nullopt;
}

}  // namespace gvd::test
