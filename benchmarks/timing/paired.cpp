#include "benchmarks/timing/paired.hpp"

#include <algorithm>
#include <cmath>

namespace talus::bench {

namespace {

/// Seconds a step over a slice of steps; those with rare work do not count, unless all are such.
double slice(Competitor const& competitor, int steps, Clock clock) {
  double usual = 0, rare = 0;
  int count = 0;
  if (competitor.prepare) competitor.prepare();
  for (int k = 0; k < steps; ++k) {
    double const begin = seconds(clock);
    bool const was_rare = competitor.step();
    double const time = seconds(clock) - begin;
    (was_rare ? rare : usual) += time;
    if (!was_rare) ++count;
  }
  return count > 0 ? usual / count + competitor.extra : rare / steps;
}

}  // namespace

std::vector<Course> take_turns(std::vector<Competitor> const& competitors, Rounds const& rounds) {
  std::size_t const n = competitors.size();
  std::vector<Course> courses(n);
  std::vector<int> steps;
  for (Competitor const& competitor : competitors) {
    double const first = slice(competitor, 2, rounds.clock);
    int const guess = std::max(1, static_cast<int>(std::ceil(rounds.slice / std::max(first, 1e-9))));
    double const again = slice(competitor, guess, rounds.clock);
    steps.push_back(std::max(1, static_cast<int>(std::ceil(rounds.slice / std::max(again, 1e-9)))));
  }
  for (int round = 0; round < rounds.count; ++round)
    for (std::size_t k = 0; k < n; ++k) {
      std::size_t const c = round % 2 == 0 ? k : n - 1 - k;
      courses[c].push_back(slice(competitors[c], steps[c], rounds.clock));
    }
  return courses;
}

Estimate ratio(Course const& a, Course const& b) {
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k) ratios.push_back(a[k] / b[k]);
  return estimate(ratios);
}

}  // namespace talus::bench
