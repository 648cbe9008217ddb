// The files that options name. Each kind of option is read in one place, whatever the option is called.

#include "common/given_files.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "common/process.hpp"
#include "common/run_parts.hpp"
#include "gvd/curve_list.hpp"
#include "gvd/error.hpp"
#include "gvd/generator_list.hpp"
#include "gvd/option_text.hpp"
#include "gvd/read_values.hpp"

namespace gvd::app {
namespace {

[[noreturn]] void refuse_unreadable(const std::string& message) { throw Error(ErrorCode::unreadable_input, message); }

bool is_there(const std::string& file) {
  std::error_code ignored;
  return file == "-" || std::filesystem::exists(file, ignored);
}

/// `format`: where it is not told from extension and content.
GeneratorList read_list(const std::string& file, const std::optional<GeneratorFormat>& format) {
  if (file != "-") {
    const WaitForInput wait(file);
    return read_generators(file, format);
  }
  const std::string content = read_standard_input();
  return parse_generators(content, format.value_or(detect_generator_format(content)), kStandardInput);
}

/// A name that is no file may have been meant for vertices.
void read(const std::string& option, const PointList& points, const std::optional<GeneratorFormat>& format) {
  GivenPoints& given = *points.value;
  if (given.file.empty()) return;
  if (points.named == PointList::Named::any && !is_there(given.file)) {
    refuse_unreadable(fmt::format("{}: there is no such file; name one that lists points, or write vertices, as in {}",
                                  placeholder(option, user_text(given.file)), placeholder(option, "3,17,99")));
  }
  given.list = std::make_shared<GeneratorList>(read_list(given.file, format));
}

void read(const std::string& option, const Curves& curves) {
  const std::string& name = curves.value->name;
  if (name.empty() || name == "boundary" || parse_creases(name, curves.usual)) return;
  if (!is_there(name)) {
    refuse_unreadable(placeholder(option, name) +
                      ": there is no such file; write boundary, creases or the name of a file");
  }
  const WaitForInput wait(name);
  curves.value->list = std::make_shared<CurveList>(name == "-" ? parse_curves(read_standard_input(), kStandardInput)
                                                               : gvd::read_curves(name));
}

void read(Run& run, const CheckedMesh& input, const std::string& option, const ValueSource& source) {
  const std::string& name = source.value->name;
  if (name.empty() || contains(source.words, name)) return;
  const WaitForInput wait(name);  // which may be a pipe
  if (source.of == ValueSource::Of::generators) {
    const bool is_piped = name == "-";
    source.value->values = std::make_shared<ElementValues>(
        ElementValues{is_piped ? kStandardInput : name, {true, read_values(is_piped ? "/dev/stdin" : name)}});
    return;
  }
  const bool is_of_faces = source.of == ValueSource::Of::faces;
  auto found =
      read_element_values(input, name, property_file(run), is_of_faces ? SoupElement::polygon : SoupElement::vertex,
                          is_of_faces ? ValueColumns::last : ValueColumns::one);
  if (!found) refuse_name(run, option, name);
  if (is_of_faces) found->title = placeholder(option, name);
  source.value->values = std::make_shared<ElementValues>(*std::move(found));
}

}  // namespace

void read_given_files(Run& run, const CheckedMesh& input) {
  const Options& options = run.options();
  for (const Option* const option : options.list->options()) {
    const std::string& name = option->name;
    const auto format = option->name == "generators" ? options.input.list_format : std::nullopt;
    std::visit(Overload{[&](const PointList& points) { read(name, points, format); },
                        [&](const Curves& curves) { read(name, curves); },
                        [&](const ValueSource& source) { read(run, input, name, source); }, [](const auto&) {}},
               option->field);
  }
}

}  // namespace gvd::app
