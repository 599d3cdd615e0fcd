#include "core/config/nearest.hpp"

#include <algorithm>
#include <numeric>

namespace talus {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before = last;
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      std::size_t const changed = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      bool const swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row.back();
}

std::optional<std::string_view> nearest(std::string_view word, std::vector<std::string_view> const& names) {
  std::optional<std::string_view> best;
  std::size_t least = 0;
  for (std::string_view const name : names) {
    auto const [shorter, longer] = std::minmax({word.size(), name.size()});
    if (3 * (longer - shorter) > longer) continue;  // so much at least they differ: a word of megabytes costs nothing
    std::size_t const distance = edit_distance(word, name);
    if (3 * distance > longer) continue;
    if (!best || distance < least) {
      best = name;
      least = distance;
    }
  }
  return best;
}

}  // namespace talus
