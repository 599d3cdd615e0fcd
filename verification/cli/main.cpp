#include <cstdio>
#include <string>
#include "verification/suite/case.hpp"
using namespace talus::verification;
int main(int n, char** a) {
  for (auto* c : cases()) {
    if (n > 1 && std::string(c->id).find(a[1]) == std::string::npos) continue;
    Findings f;
    c->run(f);
    for (auto& r : f.rows)
      std::printf("%-28s %-28s %-44s %12.5g [%g %g] %s %s (%.2fs)\n", std::string(c->id).c_str(), r.subject.c_str(),
                  r.measure.c_str(), r.found, r.allowed.low.value_or(-1e300), r.allowed.high.value_or(1e300),
                  r.verdict == Verdict::pass      ? "PASS"
                  : r.verdict == Verdict::fail    ? "FAIL"
                  : r.verdict == Verdict::noted   ? "noted"
                  : r.verdict == Verdict::floored ? "FLOORED"
                                                  : "omitted",
                  r.because.c_str(), r.cost.seconds);
  }
}
