#include <boost/test/unit_test.hpp>
#include <set>
#include <string_view>
#include <tuple>

#include "core/integrator.hpp"
#include "core/kinematics.hpp"
#include "core/transfer.hpp"
#include "core/type_list.hpp"
#include "models/integrators/musl.hpp"
#include "models/integrators/usl.hpp"
#include "models/kinematics/plane_strain.hpp"
#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/transfers/aflip.hpp"
#include "models/transfers/apic.hpp"
#include "models/transfers/flip.hpp"
#include "models/transfers/pic.hpp"

BOOST_AUTO_TEST_SUITE(step_choices)

using namespace talus;
using transfer::Aflip, transfer::Apic, transfer::Flip, transfer::Pic;

namespace {

static_assert(Transfer<Pic> && Transfer<Flip> && Transfer<Apic> && Transfer<Aflip>);
static_assert(Kinematics<kinematics::Solid> && Kinematics<kinematics::PlaneStrain> &&
              Kinematics<kinematics::PlaneStrainReduced>);
static_assert(Integrator<integrator::Usl> && Integrator<integrator::Musl>);

struct WithoutState : Pic {
  using State = int;
};
struct WithoutBlend : transfer::Affine {
  static constexpr std::string_view name = "", title = "", source = "";
  using Parameters = Pic::Parameters;
  explicit WithoutBlend(Parameters const&);
};
struct WithoutTable : Pic {
  using Parameters = double;
  explicit WithoutTable(Parameters const&);
};
static_assert(!Transfer<WithoutState> && !Transfer<WithoutBlend> && !Transfer<WithoutTable> && !Transfer<int>);

struct OfAnotherDimension : kinematics::PlaneStrain {
  static constexpr int dimension = 3;
};
struct WithoutShape : kinematics::Solid {
  using Shape = void;
};
static_assert(!Kinematics<OfAnotherDimension> && !Kinematics<WithoutShape>);

struct WithoutOrder : integrator::Usl {
  using remaps = void;
};
static_assert(!Integrator<WithoutOrder>);

// Not asked for, not stored.
static_assert(!Pic::State::holds<field::AffineVelocity> && !Flip::State::holds<field::AffineVelocity>);
static_assert(Apic::State::holds<field::AffineVelocity> && Aflip::State::holds<field::AffineVelocity>);
static_assert(Apic::State::count == 1 && Flip::State::count == 0);

}  // namespace

BOOST_AUTO_TEST_CASE(the_four_transfers_are_the_corners_of_mode_and_blend) {
  BOOST_TEST((!Pic::affine && !Pic::incremental));
  BOOST_TEST((!Flip::affine && Flip::incremental));
  BOOST_TEST((Apic::affine && !Apic::incremental));
  BOOST_TEST((Aflip::affine && Aflip::incremental));
}

BOOST_AUTO_TEST_CASE(the_increment_has_the_share_that_was_asked_for) {
  BOOST_TEST(Pic({}).alpha == 0);
  BOOST_TEST(Apic({}).alpha == 0);
  BOOST_TEST(Flip({}).alpha == 1);  // pure FLIP
  BOOST_TEST(Aflip({}).alpha ==
             0.95);  // of the production runs of Blatny, Gray & Gaume (2024), doi:10.1017/jfm.2024.643
  BOOST_TEST(Flip({0.25}).alpha == 0.25);
  BOOST_TEST(Aflip({1}).alpha == 1);
}

BOOST_AUTO_TEST_CASE(the_share_lies_between_nothing_and_all) {
  for (Range const range :
       {std::get<0>(Flip::Parameters::table()).range, std::get<0>(Aflip::Parameters::table()).range}) {
    BOOST_TEST(range.contains(0));
    BOOST_TEST(range.contains(1));
    BOOST_TEST(!range.contains(-0.95));  // no second meaning of the sign
    BOOST_TEST(!range.contains(1.0000001));
  }
}

BOOST_AUTO_TEST_CASE(the_affine_field_is_a_gradient) {
  FieldInfo const info = info_of<field::AffineVelocity>();
  BOOST_TEST(info.unit == "1/s");
  BOOST_TEST(info.components(2, 3) == 4);
  BOOST_TEST(info.components(3, 6) == 9);
}

BOOST_AUTO_TEST_CASE(kinematics_say_how_many_numbers_a_strain_has) {
  BOOST_TEST((Symmetric<double, kinematics::PlaneStrainReduced::Shape>::size == 3));
  BOOST_TEST((Symmetric<double, kinematics::PlaneStrain::Shape>::size == 4));
  BOOST_TEST((Symmetric<double, kinematics::Solid::Shape>::size == 6));
  BOOST_TEST(kinematics::PlaneStrainReduced::Shape::normals == 2);  // d_s of the invariants
  BOOST_TEST(kinematics::PlaneStrain::Shape::normals == 3);
}

BOOST_AUTO_TEST_CASE(only_the_modified_integrator_maps_back) {
  BOOST_TEST(!integrator::Usl::remaps);
  BOOST_TEST(integrator::Musl::remaps);
}

BOOST_AUTO_TEST_CASE(no_two_choices_of_a_kind_share_a_name) {
  auto const differ = []<class... P>(TypeList<P...>) {
    return std::set<std::string_view>{P::name...}.size() == sizeof...(P) &&
           std::set<std::string_view>{P::title...}.size() == sizeof...(P);
  };
  BOOST_TEST(differ(TypeList<Pic, Flip, Apic, Aflip>{}));
  BOOST_TEST(differ(TypeList<kinematics::Solid, kinematics::PlaneStrain, kinematics::PlaneStrainReduced>{}));
  BOOST_TEST(differ(TypeList<integrator::Usl, integrator::Musl>{}));
}

BOOST_AUTO_TEST_SUITE_END()
