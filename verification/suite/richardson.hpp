#pragma once
/// Solution verification: how far a value is from that on an infinitely fine grid where no exact solution is known,
///
///   phi(h) = phi0 + alpha h^p.                                                                                      (1)
///
/// Spacings are positive and fall: the last is the finest, and the uncertainty is that of its value.

#include <vector>

namespace talus::verification {

/// How values go with the spacing. oscillating: differences change their sign; unclear: they do not shrink, or vanish.
enum class Approach { monotone, oscillating, unclear };

/// What a few grids tell.
struct GridConvergence {
  Approach approach;
  double order = 0;         ///< p; 0 where the approach is not monotone
  double extrapolated = 0;  ///< phi0; the finest value where the approach is not monotone
  double uncertainty = 0;   ///< same unit as the values: safety factor times |phi - phi0|
};

/// Roache's grid convergence index of the three finest grids, with safety factor 1.25; p solves
///   e32 / e21 = r21^p (r32^p - 1) / (r21^p - 1),   r21 = h2 / h1,  e21 = phi2 - phi1,  1 the finest.
/// Where the approach is not monotone, the uncertainty is 3 times the range of the three values.
/// Pre: three or more grids.
/// Source: Roache (1994), doi:10.1115/1.2910291; Celik et al. (2008), doi:10.1115/1.2960953, step 3.
[[nodiscard]] GridConvergence convergence_of_three(std::vector<double> const& spacings,
                                                   std::vector<double> const& values);

/// The same of the two finest grids, whose order must be assumed, with safety factor 3. Pre: two or more grids.
[[nodiscard]] GridConvergence convergence_of_two(std::vector<double> const& spacings, std::vector<double> const& values,
                                                 double order);

/// Least squares of (1) over all grids, for values that scatter. Where p is outside of 0.5 ... 2, the expansions
/// phi0 + alpha h, phi0 + alpha h^2 and (for small p) phi0 + alpha h + beta h^2 compete; of each, the weighted form
/// (finer grids count for more) competes with the unweighted, and the smaller standard deviation sigma wins. With the
/// mean difference of neighbours D = (max - min) / (n - 1):
///   U = F |phi - phi0| + sigma + |phi - fit|                        where sigma < D
///   U = 3 sigma / D (|phi - phi0| + sigma + |phi - fit|)            elsewhere
/// F = 1.25 where 0.5 <= p < 2.1, else 3. The approach is told oscillating where
/// sigma >= D.
/// Pre: four or more grids.
/// Source: Eca & Hoekstra (2014), doi:10.1016/j.jcp.2014.01.006.
[[nodiscard]] GridConvergence convergence_by_least_squares(std::vector<double> const& spacings,
                                                           std::vector<double> const& values);

}  // namespace talus::verification
