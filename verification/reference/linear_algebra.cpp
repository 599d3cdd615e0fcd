#include "verification/reference/linear_algebra.hpp"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_linalg.h>

#include "verification/reference/gsl_calls.hpp"

namespace talus::reference {

namespace {

using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// GSL does not come to an end with what is not finite.
void expect_finite(Eigen::MatrixXd const& A) {
  if (A.size() == 0 || !A.allFinite()) throw std::runtime_error("a matrix is empty or not finite");
}

gsl_matrix_view view_of(RowMajor& A) {
  return gsl_matrix_view_array(A.data(), static_cast<std::size_t>(A.rows()), static_cast<std::size_t>(A.cols()));
}
gsl_vector_view view_of(Eigen::VectorXd& v) {
  return gsl_vector_view_array(v.data(), static_cast<std::size_t>(v.size()));
}

}  // namespace

Eigen::VectorXcd eigenvalues_of(Eigen::MatrixXd const& A) {
  expect_finite(A);
  gsl::Quiet const quiet;
  auto const n = static_cast<std::size_t>(A.rows());
  RowMajor work = A;
  auto at = view_of(work);
  auto const values = gsl::owned<gsl_vector_complex_free>(gsl_vector_complex_alloc(n));
  auto const workspace = gsl::owned<gsl_eigen_nonsymm_free>(gsl_eigen_nonsymm_alloc(n));
  gsl_eigen_nonsymm_params(0, 1, workspace.get());  // no Schur form; balanced
  gsl::check(gsl_eigen_nonsymm(&at.matrix, values.get(), workspace.get()), "gsl_eigen_nonsymm");
  Eigen::VectorXcd found(A.rows());
  for (std::size_t k = 0; k < n; ++k) {
    gsl_complex const value = gsl_vector_complex_get(values.get(), k);
    found[static_cast<Eigen::Index>(k)] = {GSL_REAL(value), GSL_IMAG(value)};
  }
  return found;
}

Eigen::VectorXd least_squares(Eigen::MatrixXd const& A, Eigen::VectorXd const& b) {
  expect_finite(A);
  gsl::Quiet const quiet;
  auto const terms = static_cast<std::size_t>(A.cols());
  RowMajor work = A;
  Eigen::VectorXd right = b, factors(A.cols()), norms(A.cols()), x(A.cols()), residual(A.rows());
  auto at = view_of(work);
  auto b_at = view_of(right), factors_at = view_of(factors), norms_at = view_of(norms), x_at = view_of(x),
       residual_at = view_of(residual);
  auto const order = gsl::owned<gsl_permutation_free>(gsl_permutation_alloc(terms));
  int sign = 0;
  gsl::check(gsl_linalg_QRPT_decomp(&at.matrix, &factors_at.vector, order.get(), &sign, &norms_at.vector),
             "gsl_linalg_QRPT_decomp");
  auto const rank = gsl_linalg_QRPT_rank(&at.matrix, -1);  // to round-off
  gsl::check(gsl_linalg_QRPT_lssolve2(&at.matrix, &factors_at.vector, order.get(), &b_at.vector, rank, &x_at.vector,
                                      &residual_at.vector),
             "gsl_linalg_QRPT_lssolve2");
  return x;
}

Eigen::MatrixXd logarithm(Eigen::MatrixXd const& A) {
  expect_finite(A);
  gsl::Quiet const quiet;
  RowMajor work = A, axes(A.rows(), A.cols());
  Eigen::VectorXd values(A.rows());
  auto at = view_of(work), axes_at = view_of(axes);
  auto values_at = view_of(values);
  auto const workspace = gsl::owned<gsl_eigen_symmv_free>(gsl_eigen_symmv_alloc(static_cast<std::size_t>(A.rows())));
  gsl::check(gsl_eigen_symmv(&at.matrix, &values_at.vector, &axes_at.matrix, workspace.get()), "gsl_eigen_symmv");
  return axes * values.array().log().matrix().asDiagonal() * axes.transpose();
}

}  // namespace talus::reference
