#include "verification/reference/path.hpp"

#include <cmath>

namespace talus::reference {

Matrix Segment::gradient(double t) const {
  if (turn == 0) return l;
  double const c = std::cos(turn * t), s = std::sin(turn * t);
  Matrix R;
  R << c, -s, 0, s, c, 0, 0, 0, 1;
  return R * l * R.transpose();
}

Matrix velocity_gradient(double xx, double yy, double zz, double xy) {
  Matrix l;
  l << xx, xy, 0, 0, yy, 0, 0, 0, zz;
  return l;
}

}  // namespace talus::reference
