/// A material tells which particles a step has lost, whatever chunk and lane they are in.

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "models/kinematics/plane_strain_reduced.hpp"
#include "models/kinematics/solid.hpp"
#include "models/laws/hencky.hpp"
#include "models/laws/modified_cam_clay.hpp"
#include "models/make.hpp"

BOOST_AUTO_TEST_SUITE(lost_particles)

using namespace talus;

namespace {

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Three chunks at rest, the last with five particles whose ids are 100, 101, ...
template <class Kinematics, class Law>
struct AtRest {
  static constexpr int D = Kinematics::dimension, chunks = 3, particles = 21;
  std::unique_ptr<Material<D>> material = make_material<Kinematics, Law>("one", 1500, typename Law::Parameters{});
  Layout layout{D, Symmetric<double, typename Kinematics::Shape>::size};
  std::vector<Lanes> data;
  std::vector<Matrix<Lanes, D>> dt_gradient{static_cast<std::size_t>(chunks)};
  Batch<D> batch;

  AtRest() {
    layout.unite(Fields<field::Mass, field::ElasticStrain>{});
    material->declare(layout);
    layout.unite(Fields<field::Identity>{});
    material->bind(layout);
    data.assign(static_cast<std::size_t>(chunks * layout.packs()), Lanes(0.0));
    batch.chunks = data.data();
    batch.ahead = data.data();
    batch.count = chunks, batch.particles = particles, batch.stride = layout.packs(), batch.spacing = 1;
    batch.at.mass = layout.find(field::mass);
    batch.at.strain = layout.find("elastic_strain");
    batch.at.identity = layout.find(field::identity);
    std::vector<std::pair<int, double>> values;
    material->start(values);
    for (int c = 0; c < chunks; ++c) {
      for (auto const& [pack, value] : values) batch.chunk(c)[pack] = Lanes(value);
      for (int lane = 0; lane < batch.filled(c); ++lane) {
        batch.chunk(c)[batch.at.mass].set(lane, 1);
        batch.chunk(c)[batch.at.identity].set(lane, 100 + c * lanes + lane);
      }
      for (Lanes& entry : dt_gradient[static_cast<std::size_t>(c)].entries) entry = Lanes(0.0);
    }
  }
  void set(int particle, int i, int j, double value) {
    dt_gradient[static_cast<std::size_t>(particle / lanes)](i, j).set(particle % lanes, value);
  }
  /// What a step of dt tells, with the norm of L as the gather gives it: by comparisons, which pass over what is no number.
  Motion after(double dt = 1e-3) {
    Motion motion;
    for (auto const& H : dt_gradient)
      for (int lane = 0; lane < lanes; ++lane) {
        double square = 0;
        for (Lanes const& entry : H.entries) square += entry[lane] * entry[lane];
        if (std::sqrt(square) / dt > motion.gradient) motion.gradient = std::sqrt(square) / dt;
      }
    material->update(batch, dt_gradient.data(), dt, motion, nullptr, false, nullptr);
    return motion;
  }
};

template <class Kinematics, class Law>
void lost_particles_are_told() {
  using Scene = AtRest<Kinematics, Law>;
  BOOST_TEST(Scene().after().failed == -1);
  for (int const particle : {0, 5, 12, 20}) {
    BOOST_TEST_CONTEXT(Kinematics::name << ", " << Law::name << ", particle " << particle) {
      Scene hurt;
      hurt.set(particle, 1, 0, no_number);
      Motion const lost = hurt.after();
      BOOST_TEST(lost.failed == 100 + particle);
      BOOST_TEST((lost.cause == Motion::Cause::not_finite));
      Scene turned;
      turned.set(particle, 0, 0, -1.5);
      Motion const inverted = turned.after();
      BOOST_TEST(inverted.failed == 100 + particle);
      BOOST_TEST((inverted.cause != Motion::Cause::none));
      Scene spoilt;
      spoilt.batch.chunk(particle / lanes)[spoilt.batch.at.strain].set(particle % lanes, no_number);
      BOOST_TEST(spoilt.after().failed == 100 + particle);
    }
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(they_are_told_by_every_kind_of_material) {
  lost_particles_are_told<kinematics::PlaneStrainReduced, law::Hencky>();
  lost_particles_are_told<kinematics::PlaneStrainReduced, law::CamClay>();
  lost_particles_are_told<kinematics::Solid, law::Hencky>();
  lost_particles_are_told<kinematics::Solid, law::CamClay>();
}

BOOST_AUTO_TEST_CASE(a_particle_that_is_flattened_is_told_whatever_rounding_makes_of_its_norm) {
  for (int k = 0; k < 200; ++k) {
    AtRest<kinematics::Solid, law::Hencky> scene;
    scene.set(7, 0, 0, -1);
    BOOST_TEST(scene.after(1e-3 * (1 + 0.0371 * k)).failed == 107);
  }
}

BOOST_AUTO_TEST_CASE(the_first_of_several_is_told_and_empty_lanes_are_not) {
  AtRest<kinematics::PlaneStrainReduced, law::Hencky> scene;
  scene.set(19, 0, 1, no_number);
  scene.set(9, 1, 1, -2);
  BOOST_TEST(scene.after().failed == 109);
  AtRest<kinematics::PlaneStrainReduced, law::Hencky> empty;
  empty.set(22, 1, 1, -2);
  BOOST_TEST(empty.after().failed == -1);
}

BOOST_AUTO_TEST_CASE(a_large_turn_loses_nothing) {
  AtRest<kinematics::PlaneStrainReduced, law::Hencky> scene;
  scene.set(4, 0, 1, 1.5);
  scene.set(4, 1, 0, -1.5);
  BOOST_TEST(scene.after().failed == -1);
}

BOOST_AUTO_TEST_SUITE_END()
