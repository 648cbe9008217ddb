// Keeps the list of options, and the rules on which options go together.
//
// Rules refer to options by name, so that parts of a list can be described separately. A rule with a misspelt name
// would never apply; the tests call find_unknown_names for every list to detect it.

#include "gvd/option_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "gvd/option_text.hpp"

namespace gvd {
namespace {

template <class T>
std::function<void()> restore(T* field) {
  return [field, initial = *field] { *field = initial; };
}

/// Makes a function that restores the present values of an option's fields.
std::function<void()> make_reset(const Field& field) {
  const auto any_pointer = [](auto* value) { return restore(value); };
  const auto both = [](std::function<void()> first, std::function<void()> second) {
    return [first = std::move(first), second = std::move(second)] {
      first();
      second();
    };
  };
  return std::visit(Overload{[](const Flag& flag) { return restore(flag.value); },
                             [](const Switch& on_off) { return restore(on_off.value); },
                             [&](const Number& number) { return std::visit(any_pointer, number.value); },
                             [](const Choice& choice) {
                               return std::function<void()>([choice, initial = choice.get()] { choice.set(initial); });
                             },
                             [](const ChoiceList& list) { return restore(list.value); },
                             [&](const File& file) {
                               std::function<void()> reset = std::visit(any_pointer, file.value);
                               return file.unnamed == nullptr ? reset : both(std::move(reset), restore(file.unnamed));
                             },
                             [](const PointList& list) { return restore(list.value); },
                             [](const Curves& curves) { return restore(curves.value); },
                             [](const Counts& counts) { return restore(counts.value); },
                             [](const ValueSource& values) { return restore(values.value); },
                             [](const ByteSize& size) { return restore(size.value); },
                             [](const SizeOrPercent& size) { return restore(size.value); },
                             [&](const CreaseAngle& angle) {
                               return std::function<void()>(both(restore(angle.value), restore(angle.automatic)));
                             }},
                    field);
}

/// Lists the placeholders of options, as in "A, B or C".
std::string list_placeholders(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += i == 0 ? "" : i + 1 < names.size() ? ", " : " or ";
    text += placeholder(names[i]);
  }
  return text;
}

/// Finds two given options that exclude each other.
std::optional<Problem> find_exclusion(const OptionList& list, const Given& given) {
  const std::vector<const Option*> all = list.options();
  for (auto a = all.begin(); a != all.end(); ++a) {
    for (auto b = a + 1; given.has((*a)->name) && b != all.end(); ++b) {
      if (!given.has((*b)->name) || !list.exclude_each_other((*a)->name, (*b)->name)) continue;
      // The message blames the later option. Options of a file come after those of the command line.
      const bool is_first_later = given.find((*a)->name)->order > given.find((*b)->name)->order;
      const std::string& blamed = is_first_later ? (*a)->name : (*b)->name;
      const std::string why = list.why_excluded((*a)->name, (*b)->name);
      return Problem{blamed, fmt::format("\1{}\2 and \1{}\2 exclude each other: {}keep one", (*a)->name, (*b)->name,
                                         why.empty() ? "" : why + "; ")};
    }
  }
  return std::nullopt;
}

}  // namespace

void OptionList::group(const std::string& title) {
  if (std::find(groups_.begin(), groups_.end(), title) == groups_.end()) groups_.push_back(title);
  group_ = title;
}

void OptionList::option(const std::string& name, Field field, Spec spec) {
  const auto* const flag = std::get_if<Flag>(&field);
  const bool is_on = flag != nullptr && *flag->value == flag->given_as;
  if (spec.usual.empty()) spec.usual = default_text(field);
  std::function<void()> reset = make_reset(field);
  options_.push_back({name, group_, std::move(field), std::move(spec), std::move(reset), is_on});
}

void OptionList::excludes(const std::string& name, const std::vector<std::string>& others, const std::string& why) {
  for (const std::string& other : others) excluded_[{name, other}] = excluded_[{other, name}] = why;
}

void OptionList::needs(const std::string& name, const std::string& other) { needed_.emplace_back(name, other); }

void OptionList::one_of(OneOf set) { sets_.push_back(std::move(set)); }

void OptionList::rule(ValueRule rule) { rules_.push_back(std::move(rule)); }

std::vector<const Option*> OptionList::options() const {
  std::vector<const Option*> ordered;
  for (const std::string& title : groups_) {
    for (const Option& option : options_) {
      if (option.group == title) ordered.push_back(&option);
    }
  }
  return ordered;
}

const Option* OptionList::find(std::string_view name) const {
  const auto found = std::find_if(options_.begin(), options_.end(), [&](const Option& o) { return o.name == name; });
  return found == options_.end() ? nullptr : &*found;
}

bool OptionList::exclude_each_other(const std::string& a, const std::string& b) const {
  if (a == b) return false;
  const auto has = [](const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  return excluded_.contains({a, b}) || std::any_of(sets_.begin(), sets_.end(), [&](const OneOf& set) {
           return has(set.options, a) && has(set.options, b);
         });
}

std::string OptionList::why_excluded(const std::string& a, const std::string& b) const {
  const auto found = excluded_.find({a, b});
  return found == excluded_.end() ? "" : found->second;
}

std::vector<std::string> OptionList::needed_by(const std::string& name) const {
  std::vector<std::string> needed;
  for (const auto& [option, other] : needed_) {
    if (option == name) needed.push_back(other);
  }
  return needed;
}

bool OptionList::can_add(std::string_view name, const Given& given) const {
  const Option* const option = find(name);
  return option != nullptr && std::none_of(options_.begin(), options_.end(), [&](const Option& other) {
           return given.has(other.name) && exclude_each_other(option->name, other.name);
         });
}

std::optional<std::string> OptionList::suggest(const std::string& wrong) const {
  std::vector<std::string> names;
  for (const Option& option : options_) {
    const bool is_its_other = wrong == option.spec.short_name || wrong == option.spec.also;
    if (is_its_other && !wrong.empty()) return option.name;
    names.push_back(option.name);
  }
  return suggest_name(wrong, names);
}

std::string OptionList::why_idle(const Option& option, const Given& given) const {
  for (const ValueRule& rule : rules_) {
    if (rule.option != option.name) continue;
    if (std::string reason = rule.why_idle(given); !reason.empty()) return reason;
  }
  return "";
}

std::optional<Problem> OptionList::find_problem(const Given& given) const {
  if (auto exclusion = find_exclusion(*this, given)) return exclusion;
  for (const auto& [name, other] : needed_) {
    if (!given.has(name) || given.has(other)) continue;
    return Problem{name, fmt::format("\1{0}\2 needs \1{1}\2: add it, or leave \1{0}\2 out", name, other)};
  }
  for (const ValueRule& rule : rules_) {
    if (!given.has(rule.option)) continue;
    if (std::string reason = rule.why_idle(given); !reason.empty()) return Problem{rule.option, std::move(reason)};
  }
  return std::nullopt;
}

std::optional<Problem> OptionList::find_missing(const Given& given) const {
  for (const OneOf& set : sets_) {
    if (std::any_of(set.options.begin(), set.options.end(), [&](const auto& name) { return given.has(name); })) {
      continue;
    }
    return Problem{"", fmt::format("{}: give {}{}", set.missing, set.options.size() > 2 ? "one of " : "",
                                   list_placeholders(set.options))};
  }
  return std::nullopt;
}

std::vector<std::string> OptionList::find_unknown_names() const {
  std::set<std::string> named;
  const auto read = [&](const std::string& text) {
    spell_options(text, {.spell = [&](std::string_view name, std::string_view) {
                    return *named.insert(std::string(name)).first;
                  }});
  };
  for (const auto& [pair, why] : excluded_) {
    named.insert({pair.first, pair.second});
    read(why);
  }
  for (const auto& [a, b] : needed_) named.insert({a, b});
  for (const OneOf& set : sets_) named.insert(set.options.begin(), set.options.end());
  for (const ValueRule& rule : rules_) {
    named.insert(rule.option);
    named.insert(rule.depends_on.begin(), rule.depends_on.end());
  }
  for (const std::string& title : groups_) read(title);
  for (const Option& option : options_) {
    for (const std::string* text : {&option.spec.help, &option.spec.more, &option.spec.arrays, &option.spec.usual})
      read(*text);
  }
  std::vector<std::string> unknown;
  for (const std::string& name : named) {
    if (find(name) == nullptr) unknown.push_back(name);
  }
  return unknown;
}

}  // namespace gvd
