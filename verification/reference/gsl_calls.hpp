#pragma once
/// What calls of GSL have in common: errors are thrown, where GSL would end the program.

#include <gsl/gsl_errno.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace talus::reference::gsl {

/// GSL's handler of errors, which aborts, is off while this lives.
class Quiet {
 public:
  Quiet() : before_(gsl_set_error_handler_off()) {}
  ~Quiet() { gsl_set_error_handler(before_); }
  Quiet(Quiet const&) = delete;
  Quiet& operator=(Quiet const&) = delete;

 private:
  gsl_error_handler_t* before_;
};

/// Throws std::runtime_error where a call did not succeed.
inline void check(int status, std::string const& call) {
  if (status != GSL_SUCCESS) throw std::runtime_error(call + ": " + gsl_strerror(status));
}

/// Gives back what GSL made.
template <auto Free>
struct Release {
  void operator()(auto* object) const { Free(object); }
};
template <class T, auto Free>
using Owned = std::unique_ptr<T, Release<Free>>;

/// Owns what GSL made. Throws std::runtime_error where it could not.
template <auto Free, class T>
[[nodiscard]] Owned<T, Free> owned(T* object) {
  if (object == nullptr) throw std::runtime_error("GSL could not make what was asked of it");
  return Owned<T, Free>(object);
}

}  // namespace talus::reference::gsl
