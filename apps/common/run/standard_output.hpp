#pragma once

#include <functional>
#include <iosfwd>

namespace gvd::app {

/// Writes to standard output what `write` puts into its stream, and flushes it.
/// Throws out of the first write that fails: Error{reader_gone}, or Error{unwritable_output} with the reason.
void write_standard_output(const std::function<void(std::ostream&)>& write);

/// Ends the process by SIGPIPE, as it would have ended had the signal not been ignored. Returns the exit code that
/// stands for it, 141, where the signal is blocked.
int end_by_broken_pipe();

/// Gives the numbers of standard input, output and error to /dev/null where they are closed: the next file that is
/// opened would get them, and with them the messages. Writing to a closed one stays an error.
void reserve_standard_streams();

}  // namespace gvd::app
