#include "apps/run_command.hpp"

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace gvd::test {
namespace {

std::filesystem::path binary(const std::string& name) { return std::filesystem::path(GVD_BIN_DIR) / name; }

int exit_code_of(int status) { return WIFEXITED(status) ? WEXITSTATUS(status) : -1; }

/// A program and its arguments, as execv wants them.
class Arguments {
 public:
  Arguments(const std::filesystem::path& program, const std::vector<std::string>& arguments) : texts_(arguments) {
    texts_.insert(texts_.begin(), program.string());
    for (std::string& text : texts_) pointers_.push_back(text.data());
    pointers_.push_back(nullptr);
  }
  [[noreturn]] void execute() const {
    execv(pointers_[0], pointers_.data());
    _exit(127);
  }

 private:
  std::vector<std::string> texts_;
  std::vector<char*> pointers_;
};

/// Whether a process runs `program` with a handler for SIGINT, by /proc; true where there is none.
bool handles_interrupt(pid_t process, const std::filesystem::path& program) {
  const std::string folder = "/proc/" + std::to_string(process);
  std::ifstream status(folder + "/status");
  if (!status) return true;
  std::error_code ignored;
  if (!std::filesystem::equivalent(folder + "/exe", program, ignored)) return false;
  for (std::string word; status >> word;) {
    unsigned long long caught = 0;
    if (word == "SigCgt:" && status >> std::hex >> caught) return ((caught >> (SIGINT - 1)) & 1) != 0;
  }
  return true;
}

/// Reads the output of the child until it ends. `on_output` is called with all of it whenever there is more.
CommandResult collect(pid_t child, int stream, const std::function<void(const std::string&)>& on_output = {}) {
  CommandResult result;
  char buffer[4096];
  for (ssize_t count = 0; (count = read(stream, buffer, sizeof buffer)) > 0;) {
    result.err.append(buffer, static_cast<std::size_t>(count));
    if (on_output) on_output(result.err);
  }
  close(stream);
  int status = 0;
  waitpid(child, &status, 0);
  result.exit_code = exit_code_of(status);
  return result;
}

struct TerminalRun {
  pid_t child;
  int terminal;
};

TerminalRun start_on_terminal(const std::string& name, const std::vector<std::string>& arguments) {
  const Arguments argv(binary(name), arguments);
  winsize size{};
  size.ws_row = 24;
  size.ws_col = 80;
  int terminal = -1;
  const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
  if (child < 0) throw std::runtime_error("no terminal for the test");
  if (child == 0) argv.execute();
  return {child, terminal};
}

}  // namespace

CommandResult run_command(const std::string& name, const std::string& arguments) {
  const ScratchFolder scratch;
  // In braces, so that redirections of the line itself go first.
  const std::string line = "{ '" + binary(name).string() + "' " + arguments + "\n} >'" + scratch / "out" + "' 2>'" +
                           scratch / "err" + "' </dev/null";
  const int status = std::system(line.c_str());
  return {exit_code_of(status), read_text(scratch / "out"), read_text(scratch / "err")};
}

CommandResult run_on_terminal(const std::string& name, const std::vector<std::string>& arguments) {
  const TerminalRun run = start_on_terminal(name, arguments);
  return collect(run.child, run.terminal);
}

StoppedRun interrupt_at(const std::string& step, const std::string& name, const std::vector<std::string>& arguments) {
  using Clock = std::chrono::steady_clock;
  const TerminalRun run = start_on_terminal(name, arguments);
  const std::string bar = "\r\x1b[K" + step + " ";
  std::optional<Clock::time_point> sent;
  StoppedRun stopped;
  stopped.result = collect(run.child, run.terminal, [&](const std::string& output) {
    if (sent || output.find(bar) == std::string::npos) return;
    sent = Clock::now();
    kill(run.child, SIGINT);
  });
  if (sent) stopped.seconds = std::chrono::duration<double>(Clock::now() - *sent).count();
  return stopped;
}

CommandResult run_interrupted(const std::string& name, const std::vector<std::string>& arguments, int signal) {
  const Arguments argv(binary(name), arguments);
  int input[2], errors[2];
  if (pipe(input) != 0 || pipe(errors) != 0) throw std::runtime_error("no pipe for the test");
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no process for the test");
  if (child == 0) {
    dup2(input[0], STDIN_FILENO);
    dup2(errors[1], STDERR_FILENO);
    argv.execute();
  }
  close(input[0]);
  close(errors[1]);
  // Time to start, which a busy machine makes long, and to wait for input. It can't end before the signal: its input
  // stays open.
  for (int i = 0; i < 100 && !handles_interrupt(child, binary(name)); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(500));
  kill(child, signal);
  const CommandResult result = collect(child, errors[0]);
  close(input[1]);
  return result;
}

std::vector<std::string> built_commands() {
  std::vector<std::string> names;
  for (const char* name : {"gvd-segment", "gvd-lloyd", "gvd-remesh"}) {
    if (std::filesystem::exists(binary(name))) names.emplace_back(name);
  }
  return names;
}

ScratchFolder::ScratchFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "gvd_test_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder for the test");
  path_ = name;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return std::move(text).str();
}

void write_text(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::string data_file(const std::string& name) {
  return (std::filesystem::path(GVD_SOURCE_DIR) / "data" / name).string();
}

}  // namespace gvd::test
