/// Somebody else's program: composes kernels and a law of the installed Talus, and checks what it gets.

#include <array>
#include <cmath>
#include <cstdio>

#include "core/tensor.hpp"
#include "models/catalogue.hpp"

int main() {
  using namespace talus;
  // The weights of every kernel of the catalogue sum to one.
  double worst = 0;
  for_each_type(catalogue::Kernels{}, [&]<class Kernel>(std::type_identity<Kernel>) {
    std::array<double, Kernel::width> weights{};
    Kernel::weights(Kernel::base_shift + 0.3, weights);
    double sum = 0;
    for (double const w : weights) sum += w;
    worst = std::fmax(worst, std::abs(sum - 1));
  });
  std::printf("sum of weights - 1 = %g\n", worst);
  return worst < 1e-15 ? 0 : 1;
}
