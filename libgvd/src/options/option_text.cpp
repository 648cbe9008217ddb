// Reads and writes values of options as texts. Numbers do not depend on the locale, and "010" is 10 and not octal as in
// the C library. Each kind of option has a function that reads it, one that shows it and one that names it.

#include "gvd/option_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <type_traits>

#include "gvd/text.hpp"

namespace gvd {
namespace {

using Texts = std::vector<std::string>;

std::string shown(const std::string& text) { return '\'' + user_text(text) + '\''; }

bool contains(const Texts& texts, const std::string& text) {
  return std::find(texts.begin(), texts.end(), text) != texts.end();
}

std::string trim(const std::string& text) {
  const std::size_t first = text.find_first_not_of(" \t\n\v\f\r");
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(" \t\n\v\f\r") - first + 1);
}

Texts split(const std::string& text, char separator) {
  Texts parts;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(separator, start), text.size());
    parts.push_back(text.substr(start, end - start));
    start = end + 1;
  }
  return parts;
}

// ---- numbers

template <class T>
struct Plain {
  using Type = T;
};
template <class T>
struct Plain<std::optional<T>> {
  using Type = T;
};

/// Whether a number lies in a range. NaN lies in none.
template <class T>
bool lies_in(const Range& range, T value) {
  const auto number = static_cast<double>(value);
  if (!std::isfinite(number) || number < range.least || number > range.most) return false;
  return !(range.above_least && number == range.least) && !(range.below_most && number == range.most);
}

std::string read_number(const Number& number, const std::string& text) {
  return std::visit(
      [&](auto* field) -> std::string {
        using T = typename Plain<std::remove_reference_t<decltype(*field)>>::Type;
        if (const auto word = value_in(number.words, text)) {
          *field = static_cast<T>(*word);
          return "";
        }
        const std::optional<T> value = parse_number<T>(text);
        if (!value || !lies_in(number.range, *value)) {
          return fmt::format("{} is not {}", shown(text), describe_range(number));
        }
        *field = *value;
        return "";
      },
      number.value);
}

/// Reads a number that may be implied. In a file of options, "true" stands for the implied number and "false" for none.
std::string read_implied(const Number& number, const Texts& texts) {
  const bool off = texts == Texts{"false"};
  if (!off && !texts.empty() && texts != Texts{"true"}) return read_number(number, texts.front());
  std::visit(
      [&](auto* field) {
        using T = typename Plain<std::remove_reference_t<decltype(*field)>>::Type;
        if (!off) *field = static_cast<T>(*number.implied);
      },
      number.value);
  return "";
}

std::string describe_whole_range(double least, double most, double largest, const char* largest_name) {
  const auto end = [&](double value) {
    return value >= largest ? std::string(largest_name) : fmt::format("{:.0f}", value);
  };
  return fmt::format("a whole number from {} to {}", end(least), end(most));
}

/// Describes the range of whole numbers. Limits of 32 bits are written out ("2147483647"), wider limits as powers of
/// two.
template <class T>
std::string describe_whole_range(const Range& range) {
  using Limits = std::numeric_limits<T>;
  const auto largest = static_cast<double>(Limits::max());
  const std::string name =
      Limits::digits > 32 ? fmt::format("2^{} - 1", Limits::digits) : fmt::format("{}", Limits::max());
  return describe_whole_range(std::max(range.least, static_cast<double>(Limits::min())), std::min(range.most, largest),
                              largest, name.c_str());
}

std::string describe_real_range(const Range& range) {
  const bool has_least = std::isfinite(range.least), has_most = std::isfinite(range.most);
  if (has_least && has_most && !range.above_least && !range.below_most) {
    return fmt::format("a number from {} to {}", range.least, range.most);
  }
  std::string text = has_most ? "a number" : "a finite number";
  if (has_least && range.above_least) text += fmt::format(" above {}", range.least);
  if (has_least && !range.above_least) text += fmt::format(" from {} on", range.least);
  if (has_most)
    text += fmt::format("{}{} {}", has_least ? " and " : " ", range.below_most ? "below" : "at most", range.most);
  return text;
}

// ---- other kinds

std::string read_switch(const Switch& on_off, const std::string& text) {
  const std::optional<bool> value = parse_flag(text);
  if (!value) return describe_unknown(text, {"on", "off"});
  *on_off.value = value;
  return "";
}

std::string read_choice(const Choice& choice, const std::string& text) {
  const auto found = std::find(choice.names.begin(), choice.names.end(), text);
  if (found == choice.names.end()) return describe_unknown(text, choice.names);
  choice.set(std::size_t(found - choice.names.begin()));
  return "";
}

std::string read_choices(const ChoiceList& list, const Texts& texts) {
  list.value->clear();
  for (const std::string& text : texts) {
    for (const std::string& name : split(text, ',')) {
      if (!contains(list.names, name)) return describe_unknown(name, list.names);
      if (contains(*list.value, name)) return fmt::format("{} is given twice; keep one", name);
      list.value->push_back(name);
    }
  }
  return "";
}

/// Refuses a file with an unknown extension. Pipes, "-", /dev and /proc may have any name.
std::string check_extension(const std::string& file, const Texts& extensions) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  const bool is_stream = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
  const std::string lower = to_lower(std::filesystem::path(file).filename().string());
  const auto ends_so = [&](const std::string& extension) {
    return lower.ends_with("." + extension) && lower.size() > extension.size() + 1;
  };
  if (is_stream || file.starts_with("/dev/") || file.starts_with("/proc/") || file == "-" || extensions.empty() ||
      std::any_of(extensions.begin(), extensions.end(), ends_so)) {
    return "";
  }
  return fmt::format("{}: the extension must be {}.{}", shown(file), extensions.size() > 1 ? "one of " : "",
                     fmt::join(extensions, ", ."));
}

std::string read_file(const File& file, const Texts& texts) {
  if (file.unnamed != nullptr && texts == Texts{""}) return read_file(file, {});
  const char* const kind = file.use == File::Use::folder ? "folder" : "file";
  for (const std::string& text : texts) {
    if (text.empty()) return fmt::format("the name is empty; name a {}", kind);
  }
  if (auto* const several = std::get_if<std::vector<std::string>*>(&file.value)) {
    **several = texts;
    return "";
  }
  if (file.unnamed != nullptr) *file.unnamed = texts.empty();
  std::string& name = **std::get_if<std::string*>(&file.value);
  name = texts.empty() ? "" : texts.front();
  return texts.empty() || file.use != File::Use::write ? "" : check_extension(name, file.extensions);
}

std::string append_vertices(const std::string& text, std::vector<std::int64_t>& vertices) {
  for (const std::string& part : split(text, ',')) {
    const std::string field = trim(part);
    const auto index = parse_number<std::int64_t>(field);
    if (!index || *index < 0) {
      return fmt::format("{} is not a vertex index; write indices from 0, as in 3,17,99", shown(field));
    }
    vertices.push_back(*index);
  }
  return "";
}

std::string read_points(const PointList& list, const Texts& texts) {
  const bool takes_vertices = list.named != PointList::Named::file,
             takes_file = list.named != PointList::Named::vertices;
  GivenPoints& found = *list.value = {};
  for (const std::string& text : texts) {
    if (takes_file && text.empty()) {
      return takes_vertices ? "the list is empty; write vertices, as in 3,17,99, or name a file"
                            : "the name is empty; name a file";
    }
    // A number below 0 is more likely a slip than the name of a file.
    const bool is_file = !takes_vertices || (takes_file && !parse_number<double>(text) &&
                                             text.find_first_not_of("0123456789, ") != text.npos);
    if (takes_file && (!found.file.empty() || (is_file && found.vertices))) {
      return fmt::format("{}: give vertices or one file", shown(text));
    }
    if (is_file) {
      found.file = text;
      continue;
    }
    if (!found.vertices) found.vertices.emplace();
    if (std::string wrong = append_vertices(text, *found.vertices); !wrong.empty()) return wrong;
  }
  return "";
}

std::string read_curves(const Curves& curves, const std::string& text) {
  if (text.empty()) return "the name is empty; write boundary, creases or a file";
  if (text.starts_with("creases:") && !parse_creases(text, curves.usual)) {
    return fmt::format("{}: write an angle above 0 and below 180 degrees, as in creases:30", shown(text));
  }
  *curves.value = {text, nullptr};
  return "";
}

std::string read_counts(const Counts& counts, const Texts& texts) {
  counts.value->clear();
  for (const std::string& text : texts) {
    for (const std::string& field : split(text, ',')) {
      const auto count = parse_number<std::int32_t>(trim(field));
      if (!count || *count < 1) {
        return fmt::format("{} is not {}", shown(field), describe_whole_range<std::int32_t>({.least = 1}));
      }
      if (!counts.value->empty() && *count <= counts.value->back()) {
        return fmt::format("{} follows {}; write ascending numbers, as in 10,100,1000", *count, counts.value->back());
      }
      counts.value->push_back(*count);
    }
  }
  return "";
}

std::string read_values(const ValueSource& values, const std::string& text) {
  if (text.empty()) return "the name is empty; name a file";
  *values.value = {text, nullptr};
  return "";
}

/// No machine has more memory than this, and larger numbers would be rounded.
constexpr double kMostBytes = 0x1p60;

/// The factor of a unit in lower case; nothing for an unknown unit.
std::optional<double> unit_factor(std::string_view unit) {
  constexpr std::string_view kUnits = "kmgt";
  if (unit.ends_with('b')) unit.remove_suffix(1);
  const bool binary = unit.ends_with('i');
  if (binary) unit.remove_suffix(1);
  if (unit.empty()) return binary ? std::nullopt : std::optional(1.0);
  const std::size_t index = unit.size() == 1 ? kUnits.find(unit) : kUnits.npos;
  if (index == kUnits.npos) return std::nullopt;
  return std::ldexp(1.0, 10 * (static_cast<int>(index) + 1));
}

/// Reads a size in bytes: a number, which may have a fraction, and optionally K, M, G or T for a power of 1024. "B" or
/// "iB" may follow.
std::string read_size(const ByteSize& size, const std::string& text) {
  const std::string lower = to_lower(text);
  const char* const last = lower.data() + lower.size();
  double number = 0;
  const auto [end, error] = std::from_chars(lower.data(), last, number);
  const std::optional<double> factor = unit_factor({end, static_cast<std::size_t>(last - end)});
  if (!factor || error == std::errc::invalid_argument || !std::isfinite(number)) {
    return fmt::format("{} is not a size; write a number with K, M, G or T, such as 500M or 2G", shown(text));
  }
  const bool overflows = error != std::errc{} && lower.find("e-") == lower.npos;
  const double bytes = number * *factor;
  if (overflows || bytes > kMostBytes) return fmt::format("{} is too large; write at most 1048576T", shown(text));
  if (bytes < 1) return fmt::format("{} is less than a byte; write a size such as 500M or 2G", shown(text));
  *size.value = static_cast<std::int64_t>(bytes);
  return "";
}

std::string read_bound(const SizeOrPercent& size, const std::string& text) {
  const bool percent = text.ends_with('%');
  const std::optional<double> value = parse_number<double>(percent ? text.substr(0, text.size() - 1) : text);
  if (!value || !lies_in(above(0), *value)) {
    return fmt::format("{} is neither a finite number above 0 nor one with a %", shown(text));
  }
  *size.value = ErrorBound{percent ? *value / 100 : *value, percent};
  return "";
}

std::string read_angle(const CreaseAngle& angle, const std::string& text) {
  Number degrees{angle.value, {.least = 0, .most = 180, .above_least = true}, {{"auto", angle.usual}}};
  if (text == "none") {
    angle.value->reset();
  } else if (const std::string wrong = read_number(degrees, text); !wrong.empty()) {
    return wrong + " or 'none'";
  }
  *angle.automatic = text == "auto";
  return "";
}

// ---- from values back to texts

using Written = std::optional<Texts>;

Written write_text(const std::string& text) { return text.empty() ? Written() : Written(Texts{text}); }

template <class T>
Written write_any(const std::optional<T>& value) {
  return value ? Written(Texts{fmt::format("{}", *value)}) : Written();
}

// These are function objects, so that they can be passed to std::visit together with lambdas.

const auto kWriteNumber = [](const Number& number) {
  return std::visit(
      [&](const auto* field) {
        using T = std::remove_cv_t<std::remove_reference_t<decltype(*field)>>;
        std::optional<typename Plain<T>::Type> value = *field;
        const auto word = value ? name_in(number.words, static_cast<double>(*value)) : std::string_view();
        return word.empty() ? write_any(value) : write_text(std::string(word));
      },
      number.value);
};

const auto kWritePoints = [](const PointList& list) {
  const auto& [vertices, file, values] = *list.value;
  return vertices ? write_text(fmt::format("{}", fmt::join(*vertices, ","))) : write_text(file);
};

const auto kWriteBound = [](const SizeOrPercent& size) {
  if (!*size.value) return Written();
  const auto& [value, in_diagonals] = **size.value;
  return in_diagonals ? write_text(fmt::format("{:.15g}%", value * 100))  // 15 digits hide the rounding of the division
                      : write_text(fmt::format("{}", value));
};

const auto kWriteAngle = [](const CreaseAngle& angle) {
  return *angle.automatic ? write_text("auto") : *angle.value ? write_any(*angle.value) : write_text("none");
};

}  // namespace

std::string user_text(std::string text, std::size_t longest) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c >= 0 && c < ' ') || c == 127; }, ' ');
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return text.substr(0, end) + "...";
}

std::string read_option(const Option& option, const Texts& texts) {
  if (texts.empty() && !stands_alone(option.field)) {
    return fmt::format("its value is missing; write \1{}={}\2", option.name, value_name(option.field));
  }
  if (texts.size() > 1 && !is_repeatable(option.field)) return "given twice; keep one";
  const auto marked = std::find_if(texts.begin(), texts.end(), has_placeholder_mark);
  if (marked != texts.end()) return shown(*marked) + " has a control character; write it without";
  return std::visit(Overload{[&](const Flag& flag) -> std::string {
                               const auto on = parse_flag(texts.empty() ? "true" : texts.back());
                               if (!on) return fmt::format("{} is neither true nor false", shown(texts.back()));
                               *flag.value = *on == flag.given_as;
                               return "";
                             },
                             [&](const Switch& on_off) { return read_switch(on_off, texts.front()); },
                             [&](const Number& number) {
                               return number.implied ? read_implied(number, texts) : read_number(number, texts.front());
                             },
                             [&](const Choice& choice) { return read_choice(choice, texts.front()); },
                             [&](const ChoiceList& list) { return read_choices(list, texts); },
                             [&](const File& file) { return read_file(file, texts); },
                             [&](const PointList& list) { return read_points(list, texts); },
                             [&](const Curves& curves) { return read_curves(curves, texts.front()); },
                             [&](const Counts& counts) { return read_counts(counts, texts); },
                             [&](const ValueSource& values) { return read_values(values, texts.front()); },
                             [&](const ByteSize& size) { return read_size(size, texts.front()); },
                             [&](const SizeOrPercent& size) { return read_bound(size, texts.front()); },
                             [&](const CreaseAngle& angle) { return read_angle(angle, texts.front()); }},
                    option.field);
}

std::string value_name(const Field& field) {
  const auto with_words = [](const std::string& value, const auto& words) {
    std::string text = value;
    for (const auto& word : words) text += fmt::format("|{}", word);
    return text;
  };
  return std::visit(
      Overload{
          [](const Flag&) { return std::string(); }, [](const Switch&) { return std::string("on|off"); },
          [&](const Number& number) {
            const std::string name = with_words(is_real(number) ? "NUMBER" : "N", names_in(number.words));
            return number.implied ? "[" + name + "]" : name;
          },
          [](const Choice& choice) { return fmt::format("{}", fmt::join(choice.names, "|")); },
          [](const ChoiceList& list) { return fmt::format("{}", fmt::join(list.names, "|")); },
          [](const File& file) {
            if (file.use == File::Use::folder) return std::string("DIR");
            const bool is_free = is_repeatable(file) || (file.use == File::Use::read && file.extensions.size() > 1);
            return is_free || file.extensions.empty() ? std::string("FILE")
                                                      : fmt::format("FILE.{}", fmt::join(file.extensions, "|"));
          },
          [](const PointList& list) { return std::string(list.named == PointList::Named::file ? "FILE" : "LIST"); },
          [](const Curves&) { return std::string("FILE|boundary|creases[:ANGLE]"); },
          [](const Counts&) { return std::string("LIST"); },
          [](const ValueSource& values) {
            if (values.of == ValueSource::Of::generators) return std::string("FILE");
            return values.words.empty() ? std::string("PROPERTY|FILE")
                                        : fmt::format("{}|FILE|PROPERTY", fmt::join(values.words, "|"));
          },
          [](const ByteSize&) { return std::string("SIZE"); },
          [](const SizeOrPercent&) { return std::string("NUMBER[%]"); },
          [](const CreaseAngle&) { return std::string("auto|none|ANGLE"); }},
      field);
}

std::string describe_range(const Number& number) {
  std::string text = std::visit(
      [&](const auto* field) {
        using T = typename Plain<std::remove_cv_t<std::remove_reference_t<decltype(*field)>>>::Type;
        if constexpr (std::is_integral_v<T>) {
          return describe_whole_range<T>(number.range);
        } else {
          return describe_real_range(number.range);
        }
      },
      number.value);
  for (const auto& [word, value] : number.words)
    text += fmt::format("{}'{}'", number.words.size() > 1 ? ", " : " or ", word);
  return text;
}

std::optional<Texts> write_option(const Field& field) {
  return std::visit(
      Overload{[](const Flag& flag) { return Written(Texts{*flag.value == flag.given_as ? "true" : "false"}); },
               [](const Switch& on_off) {
                 return *on_off.value ? Written(Texts{**on_off.value ? "on" : "off"}) : Written();
               },
               kWriteNumber,
               [](const Choice& choice) {
                 const auto place = choice.get();
                 return place ? Written(Texts{choice.names[*place]}) : Written();
               },
               [](const ChoiceList& list) { return list.value->empty() ? Written() : Written(*list.value); },
               [](const File& file) {
                 return std::visit(
                     Overload{[](const std::string* name) { return write_text(*name); },
                              [](const Texts* names) { return names->empty() ? Written() : Written(*names); }},
                     file.value);
               },
               kWritePoints, [](const Curves& curves) { return write_text(curves.value->name); },
               [](const Counts& counts) { return write_text(fmt::format("{}", fmt::join(*counts.value, ","))); },
               [](const ValueSource& values) { return write_text(values.value->name); },
               [](const ByteSize& size) { return write_any(*size.value); }, kWriteBound, kWriteAngle},
      field);
}

std::string default_text(const Field& field) {
  const auto texts = write_option(field);
  return takes_value(field) && texts ? fmt::format("{}", fmt::join(*texts, ",")) : "";
}

bool is_real(const Number& number) {
  return std::holds_alternative<double*>(number.value) || std::holds_alternative<std::optional<double>*>(number.value);
}

bool takes_value(const Field& field) { return !std::holds_alternative<Flag>(field); }

bool stands_alone(const Field& field) {
  if (const auto* const number = std::get_if<Number>(&field)) return number->implied.has_value();
  if (const auto* const file = std::get_if<File>(&field)) return file->unnamed != nullptr;
  return !takes_value(field);
}

bool is_repeatable(const Field& field) {
  if (const auto* const file = std::get_if<File>(&field)) return std::holds_alternative<Texts*>(file->value);
  if (const auto* const list = std::get_if<PointList>(&field)) return list->named != PointList::Named::file;
  return std::holds_alternative<Flag>(field) || std::holds_alternative<ChoiceList>(field) ||
         std::holds_alternative<Counts>(field);
}

std::optional<bool> parse_flag(const std::string& text) {
  const std::string lower = to_lower(text);
  if (contains({"true", "on", "yes", "1"}, lower)) return true;
  if (contains({"false", "off", "no", "0"}, lower)) return false;
  return std::nullopt;
}

std::optional<double> parse_creases(const std::string& text, double usual) {
  constexpr std::string_view kCreases = "creases", kWithAngle = "creases:";
  if (text == kCreases) return usual;
  if (!text.starts_with(kWithAngle)) return std::nullopt;
  const std::optional<double> angle = parse_number<double>(text.substr(kWithAngle.size()));
  return angle && *angle > 0 && *angle < 180 ? angle : std::nullopt;
}

std::string describe_unknown(const std::string& text, const Texts& names) {
  const auto meant = suggest_name(text, names);
  return fmt::format("{} is not one of {}{}", shown(text), fmt::join(names, "|"),
                     meant ? fmt::format("; did you mean {}?", *meant) : "");
}

}  // namespace gvd
