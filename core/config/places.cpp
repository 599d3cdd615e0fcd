#include "core/config/places.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace talus {

namespace {

/// Names given twice are told up to this number: to compare each with all others takes time.
constexpr std::size_t most_duplicates = 100;

bool begins_a_character(char byte) {
  return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}

bool is_within(std::string_view pointer, std::string_view outer) {
  return pointer.size() > outer.size() && pointer.substr(0, outer.size()) == outer && pointer[outer.size()] == '/';
}
}  // namespace

Place place_in(std::string_view text, std::size_t byte) {
  std::string_view const before = text.substr(0, byte);
  auto const lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  std::string_view const line = before.substr(before.rfind('\n') + 1);  // npos + 1 = 0: the first line
  return {lines + 1, 1 + static_cast<std::size_t>(std::count_if(line.begin(), line.end(), begins_a_character))};
}

std::string pointer_part(std::string_view name) {
  std::string part;
  for (char const c : name) {
    if (c == '~') {
      part += "~0";
    } else if (c == '/') {
      part += "~1";
    } else {
      part += c;
    }
  }
  return part;
}

/// One walk over a valid text.
class Scan {
 public:
  Scan(std::string_view text, Places& into) : text_(text), into_(into) {}

  void run() {
    while (at_ < text_.size()) {
      char const c = text_[at_];
      if (c == '"') {
        string();
      } else if (c == '{' || c == '[') {
        begin_value();
        open_.push_back({pointer_, c == '{', c == '{', 0});
        step();
      } else if (c == '}' || c == ']') {
        open_.pop_back();
        step();
      } else if (c == ',') {
        open_.back().expects_name = open_.back().is_object;
        ++open_.back().index;
        step();
      } else if (c == ':' || is_blank(c)) {
        step();
      } else {
        begin_value();
        while (at_ < text_.size() && !is_blank(text_[at_]) && !is_mark(text_[at_])) step();
      }
    }
  }

 private:
  /// An object or list that is not closed yet.
  struct Open {
    std::string pointer;
    bool is_object;
    bool expects_name;
    std::size_t index;
  };

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
  static bool is_mark(char c) { return c == ',' || c == '}' || c == ']'; }

  void step() {
    if (text_[at_] == '\n') {
      here_ = {here_.line + 1, 1};
    } else if (at_ + 1 == text_.size() || begins_a_character(text_[at_ + 1])) {
      ++here_.column;
    }
    ++at_;
  }

  /// A name, or a value that is a string.
  void string() {
    Place const place = here_;
    std::size_t const first = at_;
    if (open_.empty() || !open_.back().expects_name) begin_value();
    step();
    while (text_[at_] != '"') {
      if (text_[at_] == '\\') step();
      step();
    }
    step();
    if (!open_.empty() && open_.back().expects_name) name(text_.substr(first, at_ - first), place);
  }

  void name(std::string_view quoted, Place place) {
    open_.back().expects_name = false;
    std::string const name = quoted.find('\\') == quoted.npos ? std::string(quoted.substr(1, quoted.size() - 2))
                                                              : nlohmann::json::parse(quoted).get<std::string>();
    pointer_ = open_.back().pointer + '/' + pointer_part(name);
    auto const [known, is_new] = into_.places_.emplace(pointer_, place);
    if (!is_new && into_.duplicates_.size() < most_duplicates && !is_within_a_duplicate())
      into_.duplicates_.push_back({pointer_, known->second, place});
  }

  [[nodiscard]] bool is_within_a_duplicate() const {
    return std::any_of(into_.duplicates_.begin(), into_.duplicates_.end(),
                       [&](Places::Duplicate const& outer) { return is_within(pointer_, outer.pointer); });
  }

  void begin_value() {
    if (open_.empty()) {
      pointer_.clear();
    } else if (open_.back().is_object) {
      return;  // name() has set the pointer and the place
    } else {
      pointer_ = open_.back().pointer + '/' + std::to_string(open_.back().index);
    }
    into_.places_.emplace(pointer_, here_);
  }

  std::string_view text_;
  Places& into_;
  std::size_t at_ = 0;
  Place here_{1, 1};
  std::string pointer_;
  std::vector<Open> open_;
};

Places::Places(std::string_view text) {
  Scan(text, *this).run();
}

Place Places::at(std::string const& pointer) const {
  auto const found = places_.find(pointer);
  return found == places_.end() ? Place{} : found->second;
}

Place Places::near(std::string pointer) const {
  while (!places_.contains(pointer) && !pointer.empty()) pointer.erase(pointer.rfind('/'));
  return at(pointer);
}

void Places::forget(std::string const& pointer) {
  std::erase_if(places_, [&](auto const& entry) { return is_within(entry.first, pointer); });
  places_[pointer] = Place{};
}

}  // namespace talus
