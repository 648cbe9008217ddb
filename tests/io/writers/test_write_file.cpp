// Files that appear whole or not at all.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>
#include <vector>

#include "gvd/error.hpp"
#include "gvd/io/write_file.hpp"
#include "io/fixture.hpp"
#include "support/catch.hpp"

namespace gvd::test_write_file {

using namespace test;
namespace fs = std::filesystem;

/// The message of the Error{code} that `action` must throw.
template <class Action>
std::string message_of(ErrorCode code, Action action) {
  try {
    action();
  } catch (const Error& error) {
    CHECK(error.code() == code);
    return error.what();
  }
  FAIL("nothing was thrown");
  return {};
}

void write_text(std::ostream& out) { out << "new"; }
/// More than any buffer holds.
void write_much(std::ostream& out) {
  for (int i = 0; i < 64; ++i) out << std::string(1 << 16, 'x');
}
/// Whether the file system of a folder has files without a name, which the system removes with their process.
bool has_unnamed_files([[maybe_unused]] const fs::path& folder) {
#ifdef O_TMPFILE
  const int descriptor = ::open(folder.c_str(), O_TMPFILE | O_WRONLY, 0600);
  if (descriptor >= 0) ::close(descriptor);
  return descriptor >= 0;
#else
  return false;
#endif
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST_CASE("a file appears whole and alone") {
  const TemporaryFolder folder;
  write_file(folder / "a.txt", write_text);
  CHECK(read_bytes(folder / "a.txt") == "new");
  write_file(folder / "a.txt", write_much);
  CHECK(read_bytes(folder / "a.txt").size() == 64u << 16);
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("(1) until the content is complete the target is what it was") {
  const TemporaryFolder folder;
  write_bytes(folder / "a.txt", "old");
  write_file(folder / "a.txt", [&](std::ostream& out) {
    out << "new" << std::flush;
    CHECK(read_bytes(folder / "a.txt") == "old");
  });
  CHECK(read_bytes(folder / "a.txt") == "new");
}

TEST_CASE("(2) an exception leaves the old file and nothing else") {
  const TemporaryFolder folder;
  write_bytes(folder / "a.txt", "old");
  const auto broken = [](std::ostream& out) {
    write_much(out);
    throw std::bad_alloc();
  };
  CHECK_THROWS_AS(write_file(folder / "a.txt", broken), std::bad_alloc);
  CHECK(read_bytes(folder / "a.txt") == "old");
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("(2) a cancelled write leaves the old file and nothing else") {
  const TemporaryFolder folder;
  write_bytes(folder / "a.txt", "old");
  const Progress cancel = [](std::string_view, double) { return false; };
  message_of(ErrorCode::interrupted, [&] { write_file(folder / "a.txt", write_much, cancel); });
  CHECK(read_bytes(folder / "a.txt") == "old");
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("(3) a full disk is an error, at once or at the commit") {
  if (!fs::exists("/dev/full")) {
    WARN("skipped: no /dev/full");
    return;
  }
  for (const auto write : {write_text, write_much}) {
    const std::string message = message_of(ErrorCode::unwritable_output, [&] { write_file("/dev/full", write); });
    CHECK(contains(message, "/dev/full"));
    CHECK(contains(message, "No space left"));
  }
  CHECK(fs::is_character_file("/dev/full"));
}

TEST_CASE("what can't be a target is named with its reason") {
  const TemporaryFolder folder;
  const auto refuse = [](const fs::path& path) {
    return message_of(ErrorCode::unwritable_output, [&] { write_file(path, write_text); });
  };
  CHECK(contains(refuse(folder / ""), "it is a directory"));
  CHECK(contains(refuse(folder / "none/a.txt"), "there is no directory"));
  CHECK(contains(refuse(""), "empty"));
  write_bytes(folder / "file", "old");
  CHECK(contains(refuse(folder / "file/a.txt"), "Not a directory"));
  CHECK(contains(refuse(folder / std::string(300, 'a')), "too long"));
  CHECK(folder.names() == std::vector<std::string>{"file"});
}

TEST_CASE("a write-protected file stays") {
  if (::geteuid() == 0) {
    WARN("skipped: root may write everything");
    return;
  }
  const TemporaryFolder folder;
  write_bytes(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms::owner_read);
  const std::string message =
      message_of(ErrorCode::unwritable_output, [&] { write_file(folder / "a.txt", write_text); });
  CHECK(contains(message, "Permission denied"));
  CHECK(read_bytes(folder / "a.txt") == "old");
}

TEST_CASE("a long name, a link, a leftover and the permissions are respected") {
  const TemporaryFolder folder;
  write_file(folder / std::string(250, 'a'), write_text);
  CHECK(folder.names() == std::vector<std::string>{std::string(250, 'a')});
  fs::remove(folder / std::string(250, 'a'));

  write_bytes(folder / "real", "old");
  fs::permissions(folder / "real", fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("real", folder / "link");
  write_bytes(folder / "real.partial0", "from a killed run");
  write_file(folder / "link", write_text);
  CHECK(fs::is_symlink(folder / "link"));
  CHECK(read_bytes(folder / "real") == "new");
  CHECK(fs::status(folder / "real").permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  CHECK(read_bytes(folder / "real.partial0") == "from a killed run");
  CHECK(folder.names() == std::vector<std::string>{"link", "real", "real.partial0"});
}

TEST_CASE("(4) a killed process leaves the old file and nothing else") {
  const TemporaryFolder folder;
  if (!has_unnamed_files(folder / "")) {
    WARN("skipped: no files without a name here");
    return;
  }
  write_bytes(folder / "a.txt", "old");
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    write_file(folder / "a.txt", [](std::ostream& out) {
      out << "new" << std::flush;
      ::raise(SIGKILL);
    });
  }
  ::waitpid(child, nullptr, 0);
  CHECK(read_bytes(folder / "a.txt") == "old");
  CHECK(folder.names() == std::vector<std::string>{"a.txt"});
}

TEST_CASE("a file without a name gets one that is free") {
  const TemporaryFolder folder;
  if (!has_unnamed_files(folder / "")) {
    WARN("skipped: no files without a name here");
    return;
  }
  write_file(folder / "a.txt", [&](std::ostream& out) {
    out << "new" << std::flush;
    CHECK(folder.names().empty());
    write_bytes(folder / "a.txt.partial0", "taken");
  });
  CHECK(read_bytes(folder / "a.txt") == "new");
  CHECK(read_bytes(folder / "a.txt.partial0") == "taken");
}

TEST_CASE("a folder that goes away while a file is written is an error") {
  const TemporaryFolder folder;
  fs::create_directory(folder / "inner");
  const auto write = [&](std::ostream& out) {
    out << "new" << std::flush;
    fs::remove_all(folder / "inner");
  };
  const std::string message =
      message_of(ErrorCode::unwritable_output, [&] { write_file(folder / "inner/a.txt", write); });
  CHECK(contains(message, "inner/a.txt"));
}

TEST_CASE("a file without a folder lands in the current one") {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::current_path(folder / "");
  write_file("plain.txt", write_text);
  fs::current_path(before);
  CHECK(read_bytes(folder / "plain.txt") == "new");
}

TEST_CASE("whether a target can be written is found out without a trace") {
  const TemporaryFolder folder;
  write_bytes(folder / "old", "old");
  check_writable(folder / "old");
  check_writable(folder / "new");
  check_writable("/dev/null");
  CHECK(folder.names() == std::vector<std::string>{"old"});
  CHECK(read_bytes(folder / "old") == "old");
  for (const fs::path& path :
       {folder / "none" / "a", folder / "", fs::path("/proc/x"), folder / std::string(300, 'a'), fs::path()}) {
    CHECK(contains(message_of(ErrorCode::unwritable_output, [&] { check_writable(path); }), path.string()));
  }
}

TEST_CASE("a pipe is not opened to find out whether it can be written") {
  const TemporaryFolder folder;
  REQUIRE(mkfifo((folder / "pipe").c_str(), 0600) == 0);
  check_writable(folder / "pipe");  // opening it would wait for a reader
}

}  // namespace gvd::test_write_file
