#include "verification/suite/findings.hpp"

#include <limits>
#include <utility>

namespace talus::verification {

Row& Findings::check(std::string subject, std::string measure, double found, Interval allowed, std::string because,
                     Cost cost) {
  Verdict const verdict = allowed.contains(found) ? Verdict::pass : Verdict::fail;
  rows.push_back({std::move(subject), std::move(measure), "1", found, allowed, {}, verdict, std::move(because), cost});
  return rows.back();
}

Row& Findings::note(std::string subject, std::string measure, double found, std::string because, Cost cost) {
  rows.push_back(
      {std::move(subject), std::move(measure), "1", found, {}, {}, Verdict::noted, std::move(because), cost});
  return rows.back();
}

void Findings::omit(std::string subject, std::string measure, std::string because) {
  double const none = std::numeric_limits<double>::quiet_NaN();
  rows.push_back({std::move(subject), std::move(measure), "1", none, {}, {}, Verdict::omitted, std::move(because), {}});
}

}  // namespace talus::verification
