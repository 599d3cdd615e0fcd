#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/config/nearest.hpp"
#include "core/config/read.hpp"

namespace talus {

namespace {

using nlohmann::json;

std::string in_quotes(std::string_view text) {
  return '"' + std::string(text) + '"';
}

std::string joined(std::vector<std::string_view> const& names) {
  std::string all;
  for (std::string_view const name : names) all += (all.empty() ? "" : ", ") + in_quotes(name);
  return all;
}

/// A value in words, cut short if it is long.
std::string words_for(json const& value) {
  if (value.is_null()) return "null";
  if (value.is_object()) return "an object";
  if (value.is_array()) return "a list of " + std::to_string(value.size());
  std::string const kind = value.is_number() ? "the number " : value.is_string() ? "the text " : "";
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > 60) text = text.substr(0, 57) + "...";
  return kind + text;
}

std::string words_for(Size const& size, int dimension) {
  if (size.per_axis && dimension > 0) return std::to_string(dimension) + " entries, one for each axis";
  if (size.per_axis) return "one entry for each axis";
  if (size.least == size.most) return std::to_string(size.least) + " entries";
  if (size.most < Size{}.most) return std::to_string(size.least) + " to " + std::to_string(size.most) + " entries";
  return size.least > 0 ? "at least " + std::to_string(size.least) + (size.least == 1 ? " entry" : " entries") : "";
}

std::vector<std::string_view> names_of(std::vector<Alternative> const& alternatives) {
  std::vector<std::string_view> names;
  for (Alternative const& alternative : alternatives) names.push_back(alternative.name);
  return names;
}

/// A number of this kind, its range and unit.
std::string words_for(Kind kind, Range const& range, std::string_view unit) {
  std::string text = kind == Kind::integer ? "a whole number" : "a number";
  if (range.bounded_below() || range.bounded_above()) text += ", " + to_text(range);
  return text + (unit.empty() || unit == "1" ? "" : " [" + std::string(unit) + ']');
}

/// What a value has to be, without what it means.
std::string words_for(Outline const& outline, int dimension) {
  switch (outline.kind) {
    case Kind::number:
    case Kind::integer:
      return words_for(outline.kind, outline.row.range, outline.row.unit);
    case Kind::boolean:
      return "true or false";
    case Kind::text:
      return "a text";
    case Kind::any:
      return "a number, a text, true or false";
    case Kind::list: {
      std::string const size = words_for(outline.row.size, dimension);
      return "a list" + (size.empty() ? "" : " of " + size) + ", each " + words_for(outline.parts.front(), dimension);
    }
    case Kind::group:
      return "an object {...}";
    case Kind::choice:
      break;
  }
  return R"(an object {"type": ...}, the type one of )" + joined(names_of(outline.alternatives));
}

std::string did_you_mean(std::optional<std::string_view> name) {
  return name ? "did you mean " + in_quotes(*name) + '?' : "";
}

/// Of any quantity: squares of it, and products with other ones, stay finite.
constexpr double largest_number = 1e100;

/// One walk over a value and its outline.
class Examination {
 public:
  explicit Examination(Reader& reader) : reader_(reader) {}

  void run(json const* value, Outline const& outline, std::string const& pointer) {
    if (value == nullptr) {
      absent(outline, pointer);
      return;
    }
    switch (outline.kind) {
      case Kind::number:
      case Kind::integer:
        return number(*value, outline, pointer);
      case Kind::boolean:
        if (!value->is_boolean()) wrong_kind(*value, outline, pointer);
        return;
      case Kind::text:
        if (!value->is_string()) wrong_kind(*value, outline, pointer);
        return;
      case Kind::any:
        if (!value->is_primitive() || value->is_null()) wrong_kind(*value, outline, pointer);
        return;
      case Kind::list:
        return list(*value, outline, pointer);
      case Kind::group:
        if (!value->is_object()) return wrong_kind(*value, outline, pointer);
        return members(*value, outline.parts, pointer, {});
      case Kind::choice:
        return choice(*value, outline, pointer);
    }
  }

 private:
  void absent(Outline const& outline, std::string const& pointer) {
    if (!must_be_given(outline)) return;
    if (outline.kind == Kind::group && !outline.row.is_required) {
      return members(json::object(), outline.parts, pointer, {});
    }
    std::string const meaning(outline.row.meaning);
    reader_.refuse(pointer, "nothing", words_for(outline, reader_.dimension) + (meaning.empty() ? "" : ": " + meaning),
                   "it has no default, so add it");
  }

  void wrong_kind(json const& value, Outline const& outline, std::string const& pointer) {
    reader_.refuse(pointer, words_for(value), words_for(outline, reader_.dimension), advice(value, outline));
  }

  static std::string advice(json const& value, Outline const& outline) {
    if (value.is_null()) return outline.initial ? "leave it out to take the default" : "";
    if (value.is_string() && (outline.kind == Kind::number || outline.kind == Kind::integer)) {
      auto const& text = value.get_ref<std::string const&>();
      double number = 0;
      auto const end = std::from_chars(text.data(), text.data() + text.size(), number);
      bool const is_number = end.ec == std::errc{} && end.ptr == text.data() + text.size() && std::isfinite(number);
      return is_number ? "remove the quotes" : "";
    }
    if (outline.kind == Kind::text && !value.is_structured()) return "put it in double quotes";
    if (outline.kind == Kind::list && !value.is_structured()) return "write a list: [" + value.dump() + ']';
    return {};
  }

  void number(json const& value, Outline const& outline, std::string const& pointer) {
    if (!value.is_number()) return wrong_kind(value, outline, pointer);
    Description const& row = outline.row;
    double const x = value.get<double>();
    bool const is_whole = !value.is_number_float() || x == std::nearbyint(x);
    if ((outline.kind == Kind::integer && !is_whole) || !row.range.contains(x)) {
      return wrong_kind(value, outline, pointer);
    }
    if (std::abs(x) > largest_number) {
      reader_.refuse(pointer, words_for(value), "at most 1e+100 in size", "beyond it, products of numbers overflow");
    } else if (!outline.possible.contains(x)) {
      reader_.refuse(pointer, words_for(value), words_for(outline.kind, outline.possible, row.unit));
    } else if (!row.tried.contains(x)) {
      std::string const of = row.source.empty() ? ", as of real materials" : ", the range validated by ";
      reader_.warn(pointer, words_for(value),
                   words_for(outline.kind, row.tried, row.unit) + of + std::string(row.source), "is the unit right?");
    }
  }

  void list(json const& value, Outline const& outline, std::string const& pointer) {
    if (!value.is_array()) return wrong_kind(value, outline, pointer);
    Size size = outline.row.size;
    if (size.per_axis && reader_.dimension > 0) size.least = size.most = static_cast<std::size_t>(reader_.dimension);
    if (value.size() < size.least || value.size() > size.most) wrong_kind(value, outline, pointer);
    for (std::size_t k = 0; k < value.size(); ++k) {
      run(&value[k], outline.parts.front(), pointer + '/' + std::to_string(k));
    }
  }

  void members(json const& value, std::vector<Outline> const& parts, std::string const& pointer,
               std::vector<std::string_view> known) {
    for (Outline const& part : parts) known.push_back(part.row.name);
    for (auto const& [name, unused] : value.items()) {
      if (std::find(known.begin(), known.end(), name) == known.end()) unknown(name, parts, pointer, known);
    }
    for (Outline const& part : parts) {
      run(detail::member(&value, part.row.name), part, pointer + '/' + pointer_part(part.row.name));
    }
  }

  /// A name that is not known: meant was the one that is spelt like it, or whose symbol it is.
  void unknown(std::string const& name, std::vector<Outline> const& parts, std::string const& pointer,
               std::vector<std::string_view> const& known) {
    std::optional<std::string_view> meant = nearest(name, known);
    for (Outline const& part : parts) {
      if (part.row.symbol == name) meant = part.row.name;
    }
    reader_.refuse(pointer + '/' + pointer_part(name), "the unknown name " + in_quotes(name),
                   known.empty() ? "no parameters here" : joined(known), did_you_mean(meant));
  }

  void choice(json const& value, Outline const& outline, std::string const& pointer) {
    std::vector<std::string_view> const names = names_of(outline.alternatives);
    std::string const allowed = "one of " + joined(names);
    if (!value.is_object()) {
      bool const is_name = value.is_string() && std::find(names.begin(), names.end(), value) != names.end();
      return reader_.refuse(pointer, words_for(value), words_for(outline, reader_.dimension),
                            is_name ? R"(write {"type": )" + value.dump() + '}' : "");
    }
    json const* const type = detail::member(&value, "type");
    if (type == nullptr) return reader_.refuse(pointer + "/type", "nothing", allowed, "add it: it says which is meant");
    if (!type->is_string()) return reader_.refuse(pointer + "/type", words_for(*type), allowed);
    auto const& name = type->get_ref<std::string const&>();
    for (Alternative const& alternative : outline.alternatives) {
      if (alternative.name == name) return members(value, alternative.parameters, pointer, {"type"});
    }
    reader_.refuse(pointer + "/type", words_for(*type), allowed, did_you_mean(nearest(name, names)));
  }

  Reader& reader_;
};

}  // namespace

void examine(json const* value, Outline const& outline, Reader& reader, std::string const& pointer) {
  Examination(reader).run(value, outline, pointer);
}

}  // namespace talus
