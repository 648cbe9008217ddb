// Writes a complete file or none: the content goes into a temporary file beside the target, which is renamed at the
// end.
//
// On Linux the temporary file has no name while it is written (O_TMPFILE, open(2)), so the system removes it if the
// process is killed. It gets a name by linkat(2) through /proc just before it is renamed. Elsewhere it is created under
// the name "TARGET.partialN".
// Invariant: the target does not change before the rename, and each failure throws one gvd::Error with the reason that
// the system gave. So no failure is reported by a stream's badbit, which tells no reason.
#include "gvd/io/write_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <memory>
#include <streambuf>
#include <system_error>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/text.hpp"

namespace gvd {
namespace {

namespace fs = std::filesystem;

/// Bytes between two calls of the progress callback.
constexpr std::size_t kChunkBytes = std::size_t{1} << 20;
/// Largest number of temporary files that killed runs may leave beside the target.
constexpr int kMaxLeftovers = 1000;
/// The temporary name begins with at most this many bytes of the target's name; file systems allow 255 bytes in all.
constexpr std::size_t kNameBytes = 200;
/// Longest chain of symbolic links that is followed: the limit of Linux.
constexpr int kMaxLinks = 40;

/// `name` is how messages call the file: a path in quotes, or "standard output".
[[noreturn]] void fail(const std::string& name, const std::string& reason) {
  throw Error(ErrorCode::unwritable_output, fmt::format("cannot write {}: {}", name, reason));
}

std::string reason_of(int error) { return std::generic_category().message(error); }

std::string quoted_path(const fs::path& path) { return fmt::format("'{}'", path.string()); }

/// If the reader of a pipe has gone away, that is not our failure, and has an error code of its own.
[[noreturn]] void fail_write(const std::string& name, int error) {
  if (error == EPIPE) throw Error(ErrorCode::reader_gone, fmt::format("the reader of {} is gone", name));
  if (error == EINTR) throw Error(ErrorCode::interrupted, fmt::format("interrupted while {} was written", name));
  fail(name, reason_of(error));
}

/// A stream buffer that throws the reason of a failure, which a stream's badbit would not tell.
class FileBuffer : public std::streambuf {
 public:
  /// Does not own the file.
  FileBuffer(std::FILE* file, std::string name, Progress progress, std::string step)
      : file_(file), name_(std::move(name)), progress_(std::move(progress)), step_(std::move(step)) {}

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

/// Passes a stream with this buffer to `write`, and flushes it.
void write_through(FileBuffer buffer, const std::function<void(std::ostream&)>& write) {
  std::ostream stream(&buffer);
  stream.exceptions(std::ios::badbit);  // lets the exceptions of the buffer through
  write(stream);
  stream.flush();
}

fs::path follow_links(fs::path path) {
  std::error_code ignored;
  for (int i = 0; i < kMaxLinks && fs::is_symlink(path, ignored); ++i) {
    const fs::path link = fs::read_symlink(path, ignored), next = link.is_absolute() ? link : path.parent_path() / link;
    // The link of a pipe in /proc can only be opened.
    if (fs::exists(path, ignored) && !fs::exists(next, ignored)) break;
    path = next;
  }
  return path;
}

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

/// The path of a file without a name, by its descriptor.
std::string descriptor_path(int descriptor) { return fmt::format("/proc/self/fd/{}", descriptor); }

/// Opens a file without a name on the file system of `folder`. Returns null if the file system does not support such
/// files, or if the file could not get a name later.
std::FILE* open_unnamed([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  constexpr mode_t kAll = 0666;  // the umask removes some of these, as for every new file
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kAll);
  if (descriptor < 0) return nullptr;
  const bool reachable = ::access(descriptor_path(descriptor).c_str(), F_OK) == 0;  // false without /proc
  std::FILE* const file = reachable ? ::fdopen(descriptor, "wb") : nullptr;
  if (file == nullptr) ::close(descriptor);
  return file;
#else
  return nullptr;
#endif
}

/// Gives a flushed file without a name the name `name`, on the same file system. If that fails, errno has the reason:
/// EEXIST if the name is taken.
bool give_name(std::FILE* unnamed, const fs::path& name) {
  const std::string path = descriptor_path(::fileno(unnamed));
  if (::linkat(AT_FDCWD, path.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) return true;
  if (errno == EEXIST) return false;
  // Some file systems in user space can't link a file that never had a name.
  std::error_code failed;
  if (fs::copy_file(path, name, failed)) return true;
  if (failed != std::errc::file_exists) ::unlink(name.c_str());
  errno = failed.value();
  return false;
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// A file that appears under its name only with `commit`. Without a commit the temporary file is removed.
class AtomicFile {
 public:
  explicit AtomicFile(const fs::path& target) : name_(quoted_path(target)), file_(follow_links(target)) {
    std::error_code failed;
    const fs::file_status status = fs::status(file_, failed);
    if (target.empty()) fail(name_, "the name is empty; name a file");
    if (has_placeholder_mark(name_))
      fail(printable(name_, name_.size()), "the name has a control character; choose another one");
    if (failed == std::errc::filename_too_long) fail(name_, failed.message());
    check(status);
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      open("wb");
      return;
    }
    opened_.reset(open_unnamed(folder_of(file_)));
    is_unnamed_ = opened_ != nullptr;
    if (!is_unnamed_) take_name();
    if (fs::exists(status)) ::fchmod(::fileno(opened_.get()), static_cast<mode_t>(status.permissions()));
  }
  ~AtomicFile() {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  const std::string& name() const { return name_; }
  std::FILE* get() const { return opened_.get(); }

  /// Closes and renames the file, whose content must have been flushed. Call it once.
  void commit() {
    if (is_unnamed_) take_name();
    if (std::fclose(opened_.release()) != 0) fail_write(name_, errno);
    if (temporary_.empty()) return;
    std::error_code error;
    fs::rename(temporary_, file_, error);
    if (error) fail(name_, error.message());
    temporary_.clear();
  }

 private:
  /// Refuses, before any content is written, a target that a rename can't replace or must not replace.
  void check(const fs::file_status& status) {
    std::error_code ignored;
    if (fs::is_directory(status)) fail(name_, "it is a directory; name a file");
    const fs::path folder = folder_of(file_);
    if (!fs::exists(folder, ignored))
      fail(name_, fmt::format("there is no directory '{}'; create it first", folder.string()));
    if (fs::is_regular_file(status)) open("r+b");  // a rename would replace a write-protected file
  }

  void open(const char* mode) {
    opened_.reset(std::fopen(file_.c_str(), mode));
    if (!opened_ && errno == EINTR) {  // opening a pipe waits for a reader
      throw Error(ErrorCode::interrupted, fmt::format("interrupted while {} waited for a reader", name_));
    }
    if (!opened_) fail(name_, reason_of(errno));
  }

  /// Gives the temporary file the first free name.
  void take_name() {
    const std::string start = file_.filename().string().substr(0, kNameBytes);
    for (int i = 0; i < kMaxLeftovers; ++i) {
      const fs::path candidate = file_.parent_path() / fmt::format("{}.partial{}", start, i);
      if (try_name(candidate)) {
        temporary_ = candidate;
        return;
      }
      if (errno == ENOENT) fail(name_, "no file can be made in its folder; choose another folder");  // such as /proc
      if (errno != EEXIST) fail(name_, reason_of(errno));
    }
    fail(name_, fmt::format("too many files named '{}.partial*' beside it; remove them", start));
  }

  /// Creates the file exclusively, so that two runs with the same target do not write into the same file.
  bool try_name(const fs::path& candidate) {
    if (is_unnamed_) return give_name(opened_.get(), candidate);
    opened_.reset(std::fopen(candidate.c_str(), "wbx"));
    return opened_ != nullptr;
  }

  std::string name_;  ///< of the target as given, for messages
  fs::path file_;     ///< the target, after its symbolic links
  /// The file to remove without a commit. Empty if there is none, as for a file that is written directly or has no
  /// name.
  fs::path temporary_;
  bool is_unnamed_ = false;
  std::unique_ptr<std::FILE, CloseFile> opened_;
};

}  // namespace

void write_file(const fs::path& target, const std::function<void(std::ostream&)>& write, const Progress& progress) {
  AtomicFile file(target);
  const std::string step = fmt::format("writing {}", target.filename().string());
  write_through(FileBuffer(file.get(), file.name(), progress, step), write);
  file.commit();
}

void check_writable(const fs::path& target) {
  std::error_code ignored;
  const fs::path file = follow_links(target);
  const fs::file_status status = fs::status(file, ignored);
  if (!fs::exists(status) || fs::is_regular_file(status) || fs::is_directory(status)) {
    const AtomicFile opened(target);  // its destructor removes the temporary file
  } else if (::access(file.c_str(), W_OK) != 0) {
    fail(quoted_path(target), reason_of(errno));
  }
}

void write_open_file(std::FILE* file, const std::string& name, const std::function<void(std::ostream&)>& write) {
  write_through(FileBuffer(file, name, {}, {}), write);
}

}  // namespace gvd
