#pragma once
/// How a particle takes the velocity of the nodes over: in place of its own, or as an increment.

namespace talus::transfer {

/// v_p <- v_pic = sum_i w_ip v_i.
struct Replace {
  static constexpr bool incremental = false;
  static constexpr double alpha = 0;
};

/// v_p <- alpha (v_p + sum_i w_ip (v_i - v_i^old)) + (1 - alpha) v_pic.
struct Increment {
  static constexpr bool incremental = true;
  double alpha;  ///< share of the increment [1], in [0, 1]: 0 is Replace
};

}  // namespace talus::transfer
