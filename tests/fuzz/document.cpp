/// Hostile documents. Whatever the bytes are: reading and judging them comes to an end, with InputError, with mistakes or
/// with a document whose echo is valid and says the same. What follows a NUL is an assignment of the command line
/// (`--set`).

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "core/cli/program.hpp"
#include "core/cli/study_cases.hpp"

namespace {

using namespace talus;

/// Ends the program, which is how a fuzzer is told.
[[noreturn]] void found(std::string const& what) {
  std::fputs((what + '\n').c_str(), stderr);
  std::abort();
}

void judge_the_echo(nlohmann::json const& resolved) {
  Document const echo = parse(resolved.dump(2), "echo");
  CheckedCase const again = program().check(echo);
  for (Mistake const& mistake : again.mistakes) found("the echo is refused: " + mistake.text("echo"));
  if (again.resolved != resolved) found("the echo of the echo differs: " + again.resolved.dump());
}

/// Few enough combinations of the axes to be made one by one.
bool is_small(StudyPlan const& plan) {
  std::size_t combinations = 1;
  for (StudyAxis const& axis : plan.axes) combinations = std::min<std::size_t>(combinations * axis.values.size(), 100);
  return combinations <= 4;
}

void judge(Document const& document) {
  CheckedCase const checked = program().check(document);
  for (Mistake const& mistake : checked.mistakes) static_cast<void>(mistake.text(document.name));
  for (Mistake const& warning : checked.warnings) static_cast<void>(warning.text(document.name));
  if (!checked.mistakes.empty()) return;
  judge_the_echo(checked.resolved);
  if (!is_study(document.value) && !is_point(document.value)) return;
  StudyPlan const plan = program().study(document);
  if (!is_small(plan)) return;
  for (cli::StudyCase const& one : cli::cases_of(plan))
    if (is_point(one.document.value))
      static_cast<void>(program().compose_point(one.document));
    else
      static_cast<void>(program().check(one.document));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
  std::string_view const bytes(reinterpret_cast<char const*>(data), size);
  std::size_t const end = std::min(bytes.find('\0'), size);
  try {
    Document document = parse(bytes.substr(0, end), "fuzzed");
    if (end < size) set_value(document, bytes.substr(end + 1));
    judge(document);
  } catch (InputError const&) {  // as it should be
  }
  return 0;
}
