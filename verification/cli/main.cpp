#include "verification/suite/case.hpp"

int main() {
  return talus::verification::cases().empty() ? 1 : 0;
}
