#include "verification/cli/selection.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "core/config/nearest.hpp"

namespace talus::verification {

namespace {

bool means(std::string const& name, std::string_view id) {
  if (id == name || id.starts_with(name + "/")) return true;
  return fnmatch(name.c_str(), std::string(id).c_str(), 0) == 0;
}

void refuse_unknown(std::span<Case const* const> all, std::string const& name) {
  std::vector<std::string_view> known;
  for (Case const* one : all) {
    if (means(name, one->id)) return;
    known.push_back(one->id);
    for (auto end = one->id.find('/'); end != std::string_view::npos; end = one->id.find('/', end + 1))
      known.push_back(one->id.substr(0, end));
  }
  auto const near = nearest(name, known);
  throw CLI::ValidationError(fmt::format("'{}' is no case;{} 'talus verify --list' lists them", name,
                                         near ? fmt::format(" did you mean '{}'?", *near) : ""));
}

}  // namespace

std::vector<Case const*> chosen(std::span<Case const* const> all, std::vector<std::string> const& names,
                                std::optional<int> tier) {
  for (std::string const& name : names) refuse_unknown(all, name);
  std::vector<Case const*> list;
  for (Case const* one : all) {
    bool const named = std::any_of(names.begin(), names.end(), [&](auto const& name) { return means(name, one->id); });
    bool const early = tier ? one->tier <= *tier : named || one->tier <= everyday_tier;
    if (early && (named || names.empty())) list.push_back(one);
  }
  if (list.empty()) throw CLI::ValidationError("there is no such case in these tiers; 'talus verify --list' lists all");
  return list;
}

}  // namespace talus::verification
