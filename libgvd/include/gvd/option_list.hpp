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

// Options, each described once: its name, the field that has its value, its range, and its words for users. Whatever
// takes, shows or writes options reads this list: command lines, files of options, help, completion, reports.
namespace gvd {

/// Accepted numbers: finite, between two ends, which belong to them unless they are open.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool above_least = false;
  bool below_most = false;
};

/// All numbers greater than `least`.
constexpr Range above(double least) { return {.least = least, .above_least = true}; }

/// A largest distance: mesh units, or a fraction of the bounding box's diagonal.
struct ErrorBound {
  double value = 0;  ///< > 0
  bool in_diagonals = false;
};

// The kinds of options. Each refers to the field that it stores into, which must stay where it is.

/// True or false; given, it stores `given_as`. One that is on by default is written --no-NAME on a command line.
struct Flag {
  bool* value;
  bool given_as = true;
};

/// "on" or "off"; without a value, other options decide.
struct Switch {
  std::optional<bool>* value;
};

/// A number in a range, or a word that stands for one. Where `implied` is set, nothing has to follow the name.
struct Number {
  std::variant<std::int32_t*, std::int64_t*, std::uint64_t*, double*, std::optional<std::int32_t>*,
               std::optional<std::int64_t>*, std::optional<double>*>
      value;
  Range range = {};
  Choices<double> words = {};
  std::optional<double> implied = {};
};

/// One of some names; made by `choice`. Its value is a place among the names, or nothing where the field has none.
struct Choice {
  std::vector<std::string> names;
  std::function<std::optional<std::size_t>()> get;
  std::function<void(std::optional<std::size_t>)> set;
};

/// Some of some names, each at most once.
struct ChoiceList {
  std::vector<std::string>* value;
  std::vector<std::string> names;
};

/// Files to read or to write, or a folder. `extensions`: without dots; none: any. A single file to write must have one
/// of them. Where `unnamed` is set, the name may be left out, which is stored there.
struct File {
  enum class Use { read, write, folder };
  std::variant<std::string*, std::vector<std::string>*> value;
  Use use = Use::read;
  std::vector<std::string> extensions = {};
  bool* unnamed = nullptr;
};

/// Points of the surface: vertices of the input, counted from 0, or a file that lists points, or only one of these.
struct PointList {
  enum class Named { any, vertices, file };
  GivenPoints* value;
  Named named = Named::any;
};

/// Curves on the surface: "boundary", "creases", "creases:ANGLE" with an angle in degrees, or a file of polylines.
/// "creases" alone are those of `usual` degrees.
struct Curves {
  GivenCurves* value;
  double usual;
};

/// Whole numbers above 0 that ascend.
struct Counts {
  std::vector<std::int32_t>* value;
};

/// Numbers: one of some words that stand for them, a file, or a property of the input where they are of its elements.
struct ValueSource {
  enum class Of {
    elements,   ///< vertices or faces; of a property that both have, the vertices
    faces,      ///< the same, but the faces; of a table with several labels, the last
    generators  ///< in a file only
  };
  GivenNumbers* value;
  std::vector<std::string> words = {};
  Of of = Of::elements;
};

/// Bytes, as in 500M or 2G.
struct ByteSize {
  std::optional<std::int64_t>* value;
};

/// A length, or percents of the bounding box's diagonal.
struct SizeOrPercent {
  std::optional<ErrorBound>* value;
};

/// The angle of creases in degrees, "none", or "auto": those of `usual` degrees where they suit.
struct CreaseAngle {
  std::optional<double>* value;
  bool* automatic;
  double usual;
};

/// A visitor handles every kind: with one that it forgets it does not compile.
using Field = std::variant<Flag, Switch, Number, Choice, ChoiceList, File, PointList, Curves, Counts, ValueSource,
                           ByteSize, SizeOrPercent, CreaseAngle>;

/// A visitor of several functions, one for each kind.
template <class... Functions>
struct Overload : Functions... {
  using Functions::operator()...;
};
template <class... Functions>
Overload(Functions...) -> Overload<Functions...>;

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

/// How much of an option a short help shows, and where it can be given.
enum class Shown {
  usual,
  main,      ///< in the short help, too
  answered,  ///< not a setting but a question, as --help: given on a command line only, and answered there
  hidden,    ///< as `answered`, and in no help
};

/// What users read of an option. Texts name other options by placeholders (see OptionList).
struct Spec {
  /// A line that says what it does, without a full stop; for a flag that is on by default, what happens without it.
  std::string help;
  std::string more = {};        ///< goes on behind `help`, from its comma or semicolon on
  std::string arrays = {};      ///< in place of both for who gives arrays and no files
  std::string unit = {};        ///< of its numbers: "mesh units"
  std::string usual = {};       ///< its default in words; empty: the number or name that the field has, if any
  std::string short_name = {};  ///< one letter
  std::string also = {};        ///< a former name, which has a hint
  Shown shown = Shown::usual;
  bool positional = false;  ///< given without a name
  bool required = false;
};

struct Option {
  std::string name;  ///< in small letters, with underscores
  std::string group;
  Field field;
  Spec spec;
  std::function<void()> reset;  ///< stores the default: the value that the field had when it was described
  bool is_on = false;           ///< a flag whose field is true by default
};

/// The options that a user set, and from where.
class Given {
 public:
  struct Source {
    std::string spelling;    ///< as the user wrote the name: "-n", "--count", or a key of a file
    std::string place;       ///< file, line and column; empty for those that come from no file
    std::size_t order = 0;   ///< how many were added before
    std::string value = {};  ///< the JSON of points, curves and numbers that are no names, as it was given
  };
  bool has(std::string_view name) const { return sources_.find(name) != sources_.end(); }
  /// Null where the option is not given.
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

/// An option that does nothing beside some values of others.
struct ValueRule {
  std::string option;
  std::vector<std::string> depends_on;  ///< the options whose values decide
  /// Why the option does nothing, and what to do; empty where it does something.
  std::function<std::string(const Given&)> why_idle;
};

/// A set of options of which exactly one is to be given. Each excludes the others.
struct OneOf {
  std::vector<std::string> options;
  std::string missing;  ///< what a user lacks without any of them: "no generators"
};

/// An option that was given wrongly, and a text with placeholders that says why.
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

  /// The heading of the options that follow. A heading that is there already goes on.
  void group(const std::string& title);
  /// The field must outlive the list, and its value now is the default.
  void option(const std::string& name, Field field, Spec spec);

  /// `why`: what keeps them apart, where it is not plain; it ends in no full stop.
  void excludes(const std::string& name, const std::vector<std::string>& others, const std::string& why = "");
  void needs(const std::string& name, const std::string& other);
  void one_of(OneOf set);
  void rule(ValueRule rule);

  /// In the order of their groups, and of their description.
  std::vector<const Option*> options() const;
  const std::vector<std::string>& groups() const { return groups_; }
  const std::vector<ValueRule>& rules() const { return rules_; }
  /// Null where there is no such option.
  const Option* find(std::string_view name) const;

  bool exclude_each_other(const std::string& a, const std::string& b) const;
  /// Why they do; empty where it is plain.
  std::string why_excluded(const std::string& a, const std::string& b) const;
  /// The options that one may stand beside only if they are given, too.
  std::vector<std::string> needed_by(const std::string& name) const;

  /// The first rule that is broken: of two options that exclude each other, of one that another needs, and of one that
  /// does nothing.
  std::optional<Problem> find_problem(const Given& given) const;
  /// The first set of which no option is given.
  std::optional<Problem> find_missing(const Given& given) const;
  /// Whether an option could be given, too: it is here, and none that is given excludes it.
  bool can_add(std::string_view name, const Given& given) const;
  /// The name that a wrong one most likely stands for; nothing for none.
  std::optional<std::string> suggest(const std::string& wrong) const;
  /// Why an option does nothing beside the values of others; empty where it does something.
  std::string why_idle(const Option& option, const Given& given) const;

  /// Names in rules and placeholders that are no option's. Empty in every list that is right.
  std::vector<std::string> find_unknown_names() const;

 private:
  std::vector<std::string> groups_;
  std::string group_;
  std::deque<Option> options_;                                           // references stay
  std::map<std::pair<std::string, std::string>, std::string> excluded_;  // and why; both orders of each pair
  std::vector<std::pair<std::string, std::string>> needed_;
  std::vector<OneOf> sets_;
  std::vector<ValueRule> rules_;
};

}  // namespace gvd
