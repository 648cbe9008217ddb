#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>

#include "gvd/progress.hpp"

namespace gvd {

/// A file that appears under its name only when it is whole: it is written beside its target and renamed.
///
/// Properties: (1) until `commit` returns, the target is what it was; (2) without a commit, whether by an error, an
/// exception or a cancelled run, the temporary file is removed; (3) the first failed write throws, from the very `<<`
/// or `write` that met it. Nothing is forced to the disk, so (1) covers an interrupted run, not a power cut. A symbolic
/// link is followed, and an existing file keeps its permissions. A target that is neither a file nor a folder (a
/// device, a pipe) can't be renamed to and is written directly.
class AtomicFile {
 public:
  /// Opens the temporary file. `progress` may be empty; it is called about once a megabyte with fraction 0, since the
  /// final size is not known, and cancels the writing as it does any other work.
  /// Throws Error{unwritable_output} with the path and the reason.
  explicit AtomicFile(std::filesystem::path target, Progress progress = {});
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Error{unwritable_output} out of a failed write and Error{interrupted} out of a cancelled one.
  std::ostream& stream();

  /// Flushes, checks and renames. To be called once. Throws Error{unwritable_output}.
  void commit();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Writes `target` whole or not at all: whatever `write` puts into the stream that it is given.
/// Throws what `write` throws, and what AtomicFile throws.
void write_file(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write,
                const Progress& progress = {});

}  // namespace gvd
