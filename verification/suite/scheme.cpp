#include "verification/suite/scheme.hpp"

#include <fmt/format.h>

#include "core/errors.hpp"
#include "core/type_list.hpp"
#include "models/catalogue_integrators.hpp"
#include "models/catalogue_kernels.hpp"
#include "models/catalogue_transfers.hpp"
#include "models/make.hpp"

namespace talus::verification {

namespace {

/// Calls f with the type of that name.
template <class... P, class F>
void with_named(TypeList<P...> list, std::string const& name, F const& f) {
  bool found = false;
  for_each_type(list, [&]<class Q>(std::type_identity<Q> type) {
    if (Q::name != name) return;
    found = true;
    f(type);
  });
  if (!found) throw InputError("there is no policy '" + name + "'");
}

}  // namespace

std::string Scheme::transfer_name() const {
  return alpha == 1 ? transfer : fmt::format("{} {}", transfer, alpha);
}

std::string Scheme::name() const {
  std::string const text = kernel + ", " + transfer_name();
  return integrator == "usl" ? text : text + ", " + integrator;
}

int Scheme::degree() const {
  int degree = 0;
  with_named(catalogue::Kernels{}, kernel, [&]<class K>(std::type_identity<K>) { degree = K::degree; });
  return degree;
}

bool Scheme::affine() const {
  bool affine = false;
  with_named(catalogue::Transfers{}, transfer, [&]<class T>(std::type_identity<T>) { affine = T::affine; });
  return affine;
}

std::vector<Scheme> all_schemes(std::string const& integrator, double alpha) {
  std::vector<Scheme> schemes;
  for_each_type(catalogue::Kernels{}, [&]<class K>(std::type_identity<K>) {
    for_each_type(catalogue::Transfers{}, [&]<class T>(std::type_identity<T>) {
      if constexpr (fit_together<K, T>)
        schemes.push_back({std::string(K::name), std::string(T::name), integrator, T::incremental ? alpha : 1});
    });
  });
  return schemes;
}

template <int D>
std::unique_ptr<Stages<D>> stages_of(Scheme const& scheme, bool rubs) {
  std::unique_ptr<Stages<D>> stages;
  with_named(catalogue::Kernels{}, scheme.kernel, [&]<class K>(std::type_identity<K>) {
    with_named(catalogue::Transfers{}, scheme.transfer, [&]<class T>(std::type_identity<T>) {
      with_named(catalogue::Integrators{}, scheme.integrator, [&]<class I>(std::type_identity<I>) {
        typename T::Parameters parameters;
        if constexpr (T::incremental) parameters.alpha = scheme.alpha;
        if constexpr (fit_together<K, T>) stages = make_stages<D, K, T, I>(parameters, rubs);
      });
    });
  });
  if (!stages) throw InputError("the " + scheme.kernel + " kernel does not go with " + scheme.transfer);
  return stages;
}

template std::unique_ptr<Stages<2>> stages_of<2>(Scheme const&, bool);
template std::unique_ptr<Stages<3>> stages_of<3>(Scheme const&, bool);

}  // namespace talus::verification
