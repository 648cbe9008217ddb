#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

#include "gvd/progress.hpp"

namespace gvd {

/// Writes a complete file or none: the content is what `write` puts into its stream.
///
/// Properties: (1) the target is unchanged until the content is complete: it is written beside the target and renamed;
/// (2) after an error, an exception or a cancelled run no temporary file is left; (3) the first failed write throws,
/// out of its own `<<` or `write`; (4) on Linux, where the file system has files without a name, a process that is
/// killed while it writes leaves no temporary file either.
/// Data is not forced to the disk: (1) covers an interrupted run, not a power cut. A symbolic link is followed. An
/// existing file keeps its permissions. A device or a pipe can't be replaced and is written directly.
/// `progress` may be empty. It is called about once per megabyte, with fraction 0 because the final size is not known,
/// and can cancel.
/// Throws what `write` throws; Error{unwritable_output} with the path and the reason; Error{reader_gone} from a write
/// to a pipe that nobody reads any more; Error{interrupted} if `progress` cancels.
void write_file(const std::filesystem::path& target, const std::function<void(std::ostream&)>& write,
                const Progress& progress = {});

/// Checks whether `write_file` could open a target; call it before the work that makes the content. An existing file
/// stays as it is. A device or a pipe is not opened, because the reader of a pipe would end.
/// Throws Error{unwritable_output} with the path and the reason.
void check_writable(const std::filesystem::path& target);

/// Writes what `write` puts into its stream to a file that is already open, such as stdout, and flushes it. `name` is
/// for messages. Throws what `write` throws, and Error{unwritable_output} or Error{reader_gone} if a write fails.
void write_open_file(std::FILE* file, const std::string& name, const std::function<void(std::ostream&)>& write);

}  // namespace gvd
