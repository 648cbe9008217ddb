#include "gvd/io/atomic_file.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <streambuf>
#include <string>
#include <system_error>
#include <utility>

#include "gvd/error.hpp"
#include "io/writers/unnamed_file.hpp"

namespace gvd {
namespace {

namespace fs = std::filesystem;

/// Bytes between two calls of the progress callback.
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
/// Largest number of temporary files of killed runs beside the target.
constexpr int kMaxLeftovers = 1000;
/// Bytes of the target's name in the temporary name: file systems allow 255 in all.
constexpr std::size_t kNameBytes = 200;
/// Longest chain of symbolic links that is followed: the limit of Linux.
constexpr int kMaxLinks = 40;

[[noreturn]] void fail(const fs::path& target, const std::string& reason) {
  throw Error(ErrorCode::unwritable_output, fmt::format("cannot write '{}': {}", target.string(), reason));
}

std::string reason_of(int error) { return std::generic_category().message(error); }

}  // namespace

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

namespace {

/// `name` is the file's, for messages. The reader of a pipe that goes away is no failure of ours: it has a code of its
/// own.
[[noreturn]] void fail_write(const std::string& name, int error) {
  if (error == EPIPE) throw Error(ErrorCode::reader_gone, fmt::format("the reader of {} is gone", name));
  if (error == EINTR) throw Error(ErrorCode::interrupted, fmt::format("interrupted while {} was written", name));
  throw Error(ErrorCode::unwritable_output, fmt::format("cannot write {}: {}", name, reason_of(error)));
}

}  // namespace

/// A stream buffer that throws the reason of a failure, which a stream's badbit does not tell.
class FileBuffer : public std::streambuf {
 public:
  /// Owns no file.
  FileBuffer(std::FILE* file, std::string name) : file_(file), name_(std::move(name)) {}

  void attach(std::FILE* file) { file_ = file; }
  void report_to(Progress progress, std::string step) {
    progress_ = std::move(progress);
    step_ = std::move(step);
  }
  const std::string& name() const { return name_; }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    const auto size = static_cast<std::size_t>(count);
    if (std::fwrite(bytes, 1, size, file_) != size) fail_write(name_, errno);
    unreported_ += size;
    if (unreported_ >= kChunkBytes) {
      unreported_ = 0;
      report_progress(progress_, step_, 0);
    }
    return count;
  }

  int_type overflow(int_type c) override {
    if (traits_type::eq_int_type(c, traits_type::eof())) return traits_type::not_eof(c);
    const char byte = traits_type::to_char_type(c);
    xsputn(&byte, 1);
    return c;
  }

  int sync() override {
    if (std::fflush(file_) != 0) fail_write(name_, errno);
    return 0;
  }

 private:
  std::FILE* file_;
  std::string name_;
  Progress progress_;
  std::string step_;
  std::size_t unreported_ = 0;
};

namespace {

/// Lets the exceptions of the buffer through.
void throw_of_buffer(std::ostream& stream) { stream.exceptions(std::ios::badbit); }

fs::path follow_links(fs::path path) {
  std::error_code ignored;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, ignored); ++i) {
    const fs::path next = fs::read_symlink(path, ignored);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

FilePointer open_or_fail(const fs::path& target, const fs::path& path, const char* mode) {
  FilePointer file(std::fopen(path.c_str(), mode));
  if (!file && errno == EINTR) {  // a pipe is opened once it has a reader
    throw Error(ErrorCode::interrupted, fmt::format("interrupted while '{}' waited for a reader", target.string()));
  }
  if (!file) fail(target, reason_of(errno));
  return file;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// Refuses, before the content is written, a target that can't be renamed to or must not be replaced.
void check_target(const fs::path& target, const fs::path& file, const fs::file_status& status) {
  std::error_code ignored;
  if (fs::is_directory(status)) fail(target, "it is a directory; name a file");
  const fs::path folder = folder_of(file);
  if (!fs::exists(folder, ignored))
    fail(target, fmt::format("there is no directory '{}'; create it first", folder.string()));
  // A rename would replace a write-protected file.
  if (fs::is_regular_file(status)) open_or_fail(target, file, "r+b");
}

}  // namespace

struct AtomicFile::State {
  State(const fs::path& given, Progress progress)
      : target(given),
        file(follow_links(given)),
        buffer(nullptr, fmt::format("'{}'", given.string())),
        stream(&buffer) {
    buffer.report_to(std::move(progress), fmt::format("writing {}", given.filename().string()));
    throw_of_buffer(stream);
  }

  void open() {
    std::error_code failed;
    const fs::file_status status = fs::status(file, failed);
    if (target.empty()) fail(target, "the name is empty; name a file");
    if (failed == std::errc::filename_too_long) fail(target, failed.message());
    check_target(target, file, status);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      attach(open_or_fail(target, file, "wb"));
      return;
    }
    attach(create_temporary());
    if (fs::exists(status)) ::fchmod(::fileno(opened.get()), static_cast<mode_t>(status.permissions()));
  }

  void attach(FilePointer file_to_write) {
    opened = std::move(file_to_write);
    buffer.attach(opened.get());
  }

  FilePointer create_temporary() {
    FilePointer created(detail::open_unnamed(folder_of(file)));
    is_unnamed = created != nullptr;
    if (is_unnamed) return created;
    // Created exclusively, so that two runs with the same target do not write into each other's file.
    take_name([&](const fs::path& name) {
      created.reset(std::fopen(name.c_str(), "wbx"));
      return created != nullptr;
    });
    return created;
  }

  /// Names the temporary file; `try_name` says whether it could have the name, and why not in errno.
  void take_name(const std::function<bool(const fs::path&)>& try_name) {
    const std::string name = file.filename().string().substr(0, kNameBytes);
    for (int i = 0; i < kMaxLeftovers; ++i) {
      const fs::path candidate = file.parent_path() / fmt::format("{}.partial{}", name, i);
      if (try_name(candidate)) {
        temporary = candidate;
        return;
      }
      if (errno != EEXIST) fail(target, reason_of(errno));
    }
    fail(target, fmt::format("too many files named '{}.partial*' beside it; remove them", name));
  }

  /// The file has no more to come: it gets a name, and is closed.
  void finish() {
    if (is_unnamed) take_name([&](const fs::path& name) { return detail::give_name(opened.get(), name); });
    std::FILE* closing = opened.release();
    if (closing != nullptr && std::fclose(closing) != 0) fail_write(buffer.name(), errno);
  }

  fs::path target;     ///< as given, for messages
  fs::path file;       ///< what it leads to
  fs::path temporary;  ///< empty where the file is written directly or has no name, and once there is nothing to remove
  bool is_unnamed = false;
  FilePointer opened;
  FileBuffer buffer;
  std::ostream stream;
};

AtomicFile::AtomicFile(fs::path target, Progress progress)
    : state_(std::make_unique<State>(target, std::move(progress))) {
  state_->open();
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!state_->temporary.empty()) fs::remove(state_->temporary, ignored);
}

std::ostream& AtomicFile::stream() { return state_->stream; }

void AtomicFile::commit() {
  state_->stream.flush();
  state_->finish();
  if (state_->temporary.empty()) return;
  std::error_code error;
  fs::rename(state_->temporary, state_->file, error);
  if (error) fail(state_->target, error.message());
  state_->temporary.clear();
}

void check_writable(const fs::path& target) {
  std::error_code ignored;
  const fs::path file = follow_links(target);
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) {
    const AtomicFile opened(target);  // removes what it created
  } else if (::access(file.c_str(), W_OK) != 0) {
    fail(target, reason_of(errno));
  }
}

void write_file(const fs::path& target, const std::function<void(std::ostream&)>& write, const Progress& progress) {
  AtomicFile file(target, progress);
  write(file.stream());
  file.commit();
}

void write_open_file(std::FILE* file, const std::string& name, const std::function<void(std::ostream&)>& write) {
  FileBuffer buffer(file, name);
  std::ostream stream(&buffer);
  throw_of_buffer(stream);
  write(stream);
  stream.flush();
}

}  // namespace gvd
