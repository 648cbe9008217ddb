// Shows a page in the browser for --open. The browser gets a session and streams of its own, so that it outlives the
// command, its terminal and its pipes. Otherwise a reader of our standard error would wait until the browser ends.

#include "common/open_page.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <thread>
#include <vector>

namespace gvd::app {
namespace {

#ifdef __APPLE__
constexpr const char* kOpener = "open";
#else
constexpr const char* kOpener = "xdg-open";
#endif

/// How long to wait for a program to fail. A program that can't show a page, for example because there is no display,
/// fails within milliseconds.
constexpr std::chrono::milliseconds kLongestWait{500}, kStep{10};

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// The path of a program, as a shell would find it; empty if there is none.
std::string find_program(const std::string& name) {
  if (name.find('/') != name.npos) return ::access(name.c_str(), X_OK) == 0 ? name : "";
  std::istringstream folders(variable("PATH"));
  for (std::string folder; std::getline(folders, folder, ':');) {
    std::error_code ignored;
    const std::string path = (std::filesystem::path(folder) / name).string();
    if (std::filesystem::is_regular_file(path, ignored) && ::access(path.c_str(), X_OK) == 0) return path;
  }
  return "";
}

using Words = std::vector<std::string>;

/// Makes a call of an entry of $BROWSER, in which %s stands for the file.
Words make_call(const std::string& command, const std::string& file) {
  Words call;
  bool has_file = false;
  std::istringstream words(command);
  for (std::string word; words >> word; call.push_back(word)) {
    for (std::size_t at = word.find("%s"); at != word.npos; at = word.find("%s", at + file.size())) {
      word.replace(at, 2, file);
      has_file = true;
    }
  }
  if (!has_file) call.push_back(file);
  return call;
}

/// The call that shows a file; empty if no program is found.
Words find_call(const std::string& file) {
  std::istringstream browsers(variable("BROWSER"));
  for (std::string browser; std::getline(browsers, browser, ':');) {
    Words call = make_call(browser, file);
    if (call.size() < 2) continue;  // a blank name
    call[0] = find_program(call[0]);
    if (!call[0].empty()) return call;
  }
  const std::string opener = find_program(kOpener);
  return opener.empty() ? Words() : Words{opener, file};
}

[[noreturn]] void execute(Words& call) {
  ::setsid();
  const int nothing = ::open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nothing, stream);
  std::vector<char*> arguments;
  for (std::string& word : call) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  ::execv(arguments[0], arguments.data());
  ::_exit(127);
}

}  // namespace

std::string open_page(const std::string& file) {
  std::error_code failed;
  const std::string path = std::filesystem::absolute(file, failed).string();
  Words call = find_call(failed ? file : path);
  if (call.empty()) return fmt::format("$BROWSER names no installed program, and {} is not installed", kOpener);
  const pid_t child = ::fork();
  if (child == 0) execute(call);
  if (child < 0) return "no process could be started";
  int status = 0;
  for (auto waited = kStep; waited <= kLongestWait; waited += kStep) {
    if (::waitpid(child, &status, WNOHANG) == child) {
      if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
      const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
      return fmt::format("{} failed with exit code {}", call[0], code);
    }
    std::this_thread::sleep_for(kStep);
  }
  return "";
}

}  // namespace gvd::app
