// Writes the figures of an object as JSON. Dots in names separate levels; a level without any value is null.

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <variant>

#include "gvd/operation_json.hpp"

namespace gvd {
namespace {

using Json = nlohmann::ordered_json;

class FigureReader : public ObjectVisitor {
 public:
  explicit FigureReader(Door door) : door_(door) {}

  void figure(const Meaning& meaning, const Figure& value) override {
    Json& place = this->place(meaning);
    std::visit(Overload{[&place](std::monostate) { place = nullptr; },
                        [&](const std::string& text) { place = spell_for(door_, text); },
                        [&](const std::vector<std::string>& texts) {
                          place = Json::array();
                          for (const std::string& text : texts) place.push_back(spell_for(door_, text));
                        },
                        [&place](const auto& known) { place = known; }},
               value);
  }
  void table(const Meaning& meaning, const Table& table) override {
    Json rows = Json::array();
    for (const Column& column : table) {
      const auto add = [&](const auto& values) {
        for (std::size_t i = 0; i < values.size(); ++i) {
          if (rows.size() <= i) rows.push_back(Json::object());
          const Json value = Json(values[i]);
          if (!value.is_array() || !value.empty()) rows[i][column.name] = value;
        }
      };
      std::visit(Overload{[&]<class T>(const std::vector<T>& values) { add(values); }, [](const auto&) {}},
                 column.values);
    }
    place(meaning) = std::move(rows);
  }
  Json take() {
    for (auto& [name, value] : figures_.items()) clear_if_empty(value);
    return std::move(figures_);
  }

 private:
  static void clear_if_empty(Json& level) {
    if (!level.is_object()) return;
    for (auto& [name, value] : level.items()) clear_if_empty(value);
    const bool is_empty = std::all_of(level.begin(), level.end(),
                                      [](const Json& one) { return one.is_null() || (one.is_array() && one.empty()); });
    if (is_empty) level = nullptr;
  }

  Json& place(const Meaning& meaning) {
    Json* at = &figures_;
    std::string_view name = meaning.name;
    for (std::size_t dot = 0; (dot = name.find('.')) != name.npos; name.remove_prefix(dot + 1)) {
      at = &(*at)[std::string(name.substr(0, dot))];
    }
    return (*at)[std::string(name)];
  }

  Door door_;
  Json figures_ = Json::object();
};

}  // namespace

std::string figures_json(const std::function<void(ObjectVisitor&)>& visit, Door door) {
  FigureReader figures(door);
  visit(figures);
  return figures.take().dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string figures_json(const Object& object, Door door) {
  return figures_json([&](ObjectVisitor& visitor) { object.visit(visitor); }, door);
}

}  // namespace gvd
