#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <string>

#include "gvd/progress.hpp"

namespace gvd {

/// A file that gets its name only when it is complete: it is written beside its target and renamed.
///
/// Properties: (1) the target is unchanged until `commit` returns; (2) without a commit (after an error, an exception or
/// a cancelled run) the temporary file is removed; (3) the first failed write throws, out of its own `<<` or `write`;
/// (4) on Linux, where the file system has files without a name, a process that is killed while it writes leaves no
/// temporary file either.
/// Data is not forced to the disk: (1) covers an interrupted run, not a power cut. A symbolic link is followed. An
/// existing file keeps its permissions. A device or a pipe can't be replaced and is written directly.
class AtomicFile {
 public:
  /// Opens the temporary file. `progress` may be empty. It is called about once a megabyte, with fraction 0, since the
  /// final size is not known; it can cancel.
  /// Throws Error{unwritable_output} with the path and the reason.
  explicit AtomicFile(std::filesystem::path target, Progress progress = {});
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Error{unwritable_output} out of a failed write, Error{reader_gone} out of one to a pipe that nobody reads any
  /// more, and Error{interrupted} out of a cancelled one.
  std::ostream& stream();

  /// Flushes, checks and renames. To be called once. Throws Error{unwritable_output}.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Finds out, before the work that makes the content, whether an AtomicFile could be opened for `target`. Leaves what
/// is there as it is. A device or a pipe is not opened, since a pipe's reader would end.
/// Throws Error{unwritable_output} with the path and the reason.
void check_writable(const std::filesystem::path& target);

/// Writes a complete file or none: the content is what `write` puts into its stream.
/// Throws what `write` throws, and what AtomicFile throws.
void write_file(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write,
                const Progress& progress = {});

/// Writes what `write` puts into its stream to a file that is open, such as stdout, and flushes it. `name` is for
/// messages. Throws what `write` throws, and Error{unwritable_output} or Error{reader_gone} out of a write that fails.
void write_open_file(std::FILE* file, const std::string& name, const std::function<void(std::ostream&)>& write);

}  // namespace gvd
