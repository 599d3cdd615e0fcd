#pragma once
/// SUNDIALS with owners, and with exceptions instead of flags.

#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <memory>
#include <string>
#include <type_traits>

namespace talus::reference {

struct FreeContext {
  void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct FreeVector {
  void operator()(N_Vector v) const { N_VDestroy(v); }
};
struct FreeMatrix {
  void operator()(SUNMatrix m) const { SUNMatDestroy(m); }
};
struct FreeSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
template <class Pointer, class Free>
using Owner = std::unique_ptr<std::remove_pointer_t<Pointer>, Free>;
using OwnedVector = Owner<N_Vector, FreeVector>;

/// Throws std::runtime_error where a call of that name failed. `said`: what the solver wrote to its error handler.
void check_flag(int flag, char const* call, std::string const& said);

/// A context, and what a dense implicit integrator of n unknowns needs of it.
class DenseKit {
 public:
  explicit DenseKit(int n);

  [[nodiscard]] SUNContext context() const { return context_.get(); }
  [[nodiscard]] SUNMatrix matrix() const { return matrix_.get(); }
  [[nodiscard]] SUNLinearSolver solver() const { return solver_.get(); }
  [[nodiscard]] OwnedVector vector() const;

 private:
  int n_;
  Owner<SUNContext, FreeContext> context_;  // freed last
  OwnedVector pattern_;
  Owner<SUNMatrix, FreeMatrix> matrix_;
  Owner<SUNLinearSolver, FreeSolver> solver_;
};

/// For CVodeSetErrHandlerFn and IDASetErrHandlerFn: keeps the message in the std::string that `text` points to.
void keep_message(int code, char const* module, char const* function, char* message, void* text);

}  // namespace talus::reference
