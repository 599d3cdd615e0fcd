#include "verification/reference/sundials.hpp"

#include <stdexcept>

namespace talus::reference {

namespace {

template <class Pointer>
Pointer made(Pointer object, char const* call) {
  if (object == nullptr) throw std::runtime_error(std::string(call) + " failed");
  return object;
}

SUNContext new_context() {
  SUNContext context = nullptr;
  check_flag(SUNContext_Create(nullptr, &context), "SUNContext_Create", "");
  return made(context, "SUNContext_Create");
}

}  // namespace

void check_flag(int flag, char const* call, std::string const& said) {
  if (flag >= 0) return;
  throw std::runtime_error(std::string(call) + " returned " + std::to_string(flag) + (said.empty() ? "" : ": " + said));
}

DenseKit::DenseKit(int n)
    : n_(n),
      context_(new_context()),
      pattern_(made(N_VNew_Serial(n, context()), "N_VNew_Serial")),
      matrix_(made(SUNDenseMatrix(n, n, context()), "SUNDenseMatrix")),
      solver_(made(SUNLinSol_Dense(pattern_.get(), matrix(), context()), "SUNLinSol_Dense")) {}

OwnedVector DenseKit::vector() const {
  OwnedVector v(made(N_VNew_Serial(n_, context()), "N_VNew_Serial"));
  N_VConst(0, v.get());
  return v;
}

void keep_message(int code, char const* module, char const* function, char* message, void* text) {
  *static_cast<std::string*>(text) =
      std::string(module) + " " + function + " (" + std::to_string(code) + "): " + message;
}

}  // namespace talus::reference
