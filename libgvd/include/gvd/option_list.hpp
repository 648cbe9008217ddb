#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "gvd/given_values.hpp"
#include "gvd/names.hpp"
#include "gvd/placeholders.hpp"

// Options, each of which is described once: its name, the field that has its value, its range, and its texts for users.
// All code that takes, shows or writes options reads this list: command lines, option files, help, completion, reports.
namespace gvd {

/// The numbers that an option accepts: finite, and between two ends, which are included unless `above_least` or
/// `below_most` excludes them.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;
  bool below_most = false;
};

/// All numbers greater than `least`.
constexpr Range above(double least) { return {.least = least, .above_least = true}; }

/// A largest distance, in mesh units or as a fraction of the bounding box's diagonal.
struct ErrorBound {
  double value = 0;  ///< > 0
  bool in_diagonals = false;
};

// The kinds of options. Each refers to the field that it stores into, which must stay where it is.

/// True or false: when it is given, it stores `given_as`. A flag that is on by default is written --no-NAME on a
/// command line.
struct Flag {
  bool* value;
  bool given_as = true;
};

/// "on" or "off"; without a value, other options decide.
struct Switch {
  std::optional<bool>* value;
};

/// A number in a range, or a word that stands for a number. If `implied` is set, the name may stand alone, and this
/// number is stored.
struct Number {
  std::variant<std::int32_t*, std::int64_t*, std::uint64_t*, double*, std::optional<std::int32_t>*,
               std::optional<std::int64_t>*, std::optional<double>*>
      value;
  Range range = {};
  Choices<double> words = {};
  std::optional<double> implied = {};
};

/// One of several names; made by `choice`. Its value is an index into the names, or nothing if the field has no value.
struct Choice {
  std::vector<std::string> names;
  std::function<std::optional<std::size_t>()> get;
  std::function<void(std::optional<std::size_t>)> set;
};

/// Any number of the given names, each at most once.
struct ChoiceList {
  std::vector<std::string>* value;
  std::vector<std::string> names;
};

/// One file or several to read or to write, or a folder. `extensions` have no dots; if empty, any extension is
/// accepted. A single file to write must have one of them. If `unnamed` is not null, the name may be left out, and
/// `*unnamed` tells whether it was.
struct File {
  enum class Use { read, write, folder };
  std::variant<std::string*, std::vector<std::string>*> value;
  Use use = Use::read;
  std::vector<std::string> extensions = {};
  bool* unnamed = nullptr;
};

/// Points of the surface: vertices of the input, counted from 0, or a file that lists points. `named` tells whether
/// both are accepted or only one.
struct PointList {
  enum class Named { any, vertices, file };
  GivenPoints* value;
  Named named = Named::any;
};

/// Curves on the surface: "boundary", "creases", "creases:ANGLE" with an angle in degrees, or a file of polylines.
/// "creases" alone stands for creases of `usual` degrees.
struct Curves {
  GivenCurves* value;
  double usual;
};

/// Whole numbers above 0, in ascending order.
struct Counts {
  std::vector<std::int32_t>* value;
};

/// Numbers of elements or generators: one of `words`, which stand for them, a file, or, for elements, a property of the
/// input.
struct ValueSource {
  enum class Of {
    elements,   ///< vertices or faces; if both have the property, those of the vertices
    faces,      ///< the same, but those of the faces; in a table with several labels, the last
    generators  ///< only a file
  };
  GivenNumbers* value;
  std::vector<std::string> words = {};
  Of of = Of::elements;
};

/// A number of bytes, as in 500M or 2G.
struct ByteSize {
  std::optional<std::int64_t>* value;
};

/// A length in mesh units, or a percentage of the bounding box's diagonal.
struct SizeOrPercent {
  std::optional<ErrorBound>* value;
};

/// The angle of creases in degrees, "none", or "auto", which takes creases of `usual` degrees if they suit.
struct CreaseAngle {
  std::optional<double>* value;
  bool* automatic;
  double usual;
};

/// The kind of an option, with the field that it stores into. A visitor must handle every kind; otherwise it does not
/// compile.
using Field = std::variant<Flag, Switch, Number, Choice, ChoiceList, File, PointList, Curves, Counts, ValueSource,
                           ByteSize, SizeOrPercent, CreaseAngle>;

/// Combines several functions, one for each kind, into a visitor.
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

/// A choice that stores one of the named values into a field, which must stay where it is.
template <class T>
Choice choice(T& field, const Choices<T>& choices) {
  Choice made;
  for (const auto& [name, value] : choices) made.names.emplace_back(name);
  made.get = [&field, choices]() -> std::optional<std::size_t> {
    for (std::size_t i = 0; i < choices.size(); ++i) {
      if (choices[i].second == field) return i;
    }
    return std::nullopt;
  };
  made.set = [&field, choices](std::optional<std::size_t> place) {
    if (place) field = choices[*place].second;
  };
  return made;
}

/// The same for a field that may have no value.
template <class T>
Choice choice(std::optional<T>& field, const Choices<T>& choices) {
  Choice made;
  for (const auto& [name, value] : choices) made.names.emplace_back(name);
  made.get = [&field, choices]() -> std::optional<std::size_t> {
    for (std::size_t i = 0; field && i < choices.size(); ++i) {
      if (choices[i].second == *field) return i;
    }
    return std::nullopt;
  };
  made.set = [&field, choices](std::optional<std::size_t> place) {
    field = place ? std::optional(choices[*place].second) : std::nullopt;
  };
  return made;
}

/// Whether the short help shows an option, and where it can be given.
enum class Shown {
  usual,
  main,      ///< in the short help, too
  answered,  ///< a question such as --help, which only command lines take and answer, not a setting
  hidden,    ///< like `answered`, but not shown in any help
};

/// The texts about an option that users read. They name other options by placeholders (gvd/placeholders.hpp).
struct Spec {
  /// One line without a full stop that says what the option does; for a flag that is on by default, what happens when
  /// it is turned off.
  std::string help;
  std::string more = {};        ///< continues `help`, and begins with a comma or semicolon
  std::string arrays = {};      ///< replaces both texts for callers that give arrays instead of files
  std::string unit = {};        ///< unit of its numbers, such as "mesh units"
  std::string usual = {};       ///< its default in words; if empty, the number or name that the field has
  std::string short_name = {};  ///< one letter
  std::string also = {};        ///< a former name, for which users get a hint
  Shown shown = Shown::usual;
  bool positional = false;  ///< given without a name
  bool required = false;
};

struct Option {
  std::string name;  ///< in lower case, with underscores
  std::string group;
  Field field;
  Spec spec;
  std::function<void()> reset;  ///< stores the default: the value that the field had when it was described
  bool is_on = false;           ///< a flag whose field is true by default
};

/// The options that a user gave, and where each of them came from.
class Given {
 public:
  struct Source {
    std::string spelling;    ///< as the user wrote the name: "-n", "--count", or a key of a file
    std::string place;       ///< file, line and column; empty if it did not come from a file
    std::size_t order = 0;   ///< how many options were added before it
    std::string value = {};  ///< JSON of points, curves and numbers, unless given by name
  };
  bool has(std::string_view name) const { return sources_.find(name) != sources_.end(); }
  /// Null if the option is not given.
  const Source* find(std::string_view name) const {
    const auto found = sources_.find(name);
    return found == sources_.end() ? nullptr : &found->second;
  }
  void add(const std::string& name, Source source) {
    source.order = added_++;
    sources_[name] = std::move(source);
  }
  void remove(const std::string& name) { sources_.erase(name); }

 private:
  std::map<std::string, Source, std::less<>> sources_;
  std::size_t added_ = 0;
};

/// A rule for an option that has no effect together with some values of other options.
struct ValueRule {
  std::string option;
  std::vector<std::string> depends_on;  ///< the options whose values decide
  /// Says why the option has no effect, and what to do; empty if it has one.
  std::function<std::string(const Given&)> why_idle;
};

/// A set of options, exactly one of which must be given.
struct OneOf {
  std::vector<std::string> options;
  std::string missing;  ///< what is missing if none is given: "no generators"
};

/// An option that can't be given like this, and a text with placeholders that says why.
struct Problem {
  std::string option;
  std::string text;
};

/// The options of an operation or a command, and which of them go together.
///
/// Texts name options by placeholders (gvd/placeholders.hpp).
class OptionList {
 public:
  OptionList() = default;
  OptionList(const OptionList&) = delete;
  OptionList& operator=(const OptionList&) = delete;

  /// Starts a group with this heading for the options that follow, or continues the group if there is one.
  void group(const std::string& title);
  /// Adds an option. The field must outlive the list; its present value is the default.
  void option(const std::string& name, Field field, Spec spec);

  /// Declares that an option can't be given together with any of the others. `why` gives the reason, without a full
  /// stop, if it is not obvious.
  void excludes(const std::string& name, const std::vector<std::string>& others, const std::string& why = "");
  /// Declares that an option can only be given together with another.
  void needs(const std::string& name, const std::string& other);
  /// Declares that exactly one option of a set must be given.
  void one_of(OneOf set);
  void rule(ValueRule rule);

  /// All options, by group; within a group, in the order in which they were added.
  std::vector<const Option*> options() const;
  const std::vector<std::string>& groups() const { return groups_; }
  const std::vector<ValueRule>& rules() const { return rules_; }
  /// Null if there is no such option.
  const Option* find(std::string_view name) const;

  bool exclude_each_other(const std::string& a, const std::string& b) const;
  /// Why two options exclude each other; empty if that is obvious.
  std::string why_excluded(const std::string& a, const std::string& b) const;
  /// The options that must be given together with this one.
  std::vector<std::string> needed_by(const std::string& name) const;

  /// The first rule that is broken. The rules are, in this order: options that exclude each other, an option that
  /// another needs, and an option that has no effect.
  std::optional<Problem> find_problem(const Given& given) const;
  /// The first set none of whose options is given.
  std::optional<Problem> find_missing(const Given& given) const;
  /// Whether an option could be given, too: it is in the list, and no given option excludes it.
  bool can_add(std::string_view name, const Given& given) const;
  /// The option that a wrong name most likely stands for; nothing if no name is similar.
  std::optional<std::string> suggest(const std::string& wrong) const;
  /// Why an option has no effect together with the values of others; empty if it has one.
  std::string why_idle(const Option& option, const Given& given) const;

  /// Names in rules and placeholders that belong to no option. Empty if the list is consistent.
  std::vector<std::string> find_unknown_names() const;

 private:
  std::vector<std::string> groups_;
  std::string group_;
  std::deque<Option> options_;                                           // a deque, so that references stay valid
  std::map<std::pair<std::string, std::string>, std::string> excluded_;  // pairs of options, in both orders, and why
  std::vector<std::pair<std::string, std::string>> needed_;
  std::vector<OneOf> sets_;
  std::vector<ValueRule> rules_;
};

}  // namespace gvd
