#pragma once

#include <cstdio>
#include <filesystem>

// Files without a name, which Linux has on most file systems: the system removes them with the process, even where that
// is killed.
namespace gvd::detail {

/// Opens one for writing on the file system of `folder`. Null where that has none, or where it could get no name later.
std::FILE* open_unnamed(const std::filesystem::path& folder);

/// Gives the file a name on its file system. Everything written to it must be flushed. Returns whether it did; errno
/// has the reason, EEXIST where the name is taken.
bool give_name(std::FILE* unnamed, const std::filesystem::path& name);

}  // namespace gvd::detail
