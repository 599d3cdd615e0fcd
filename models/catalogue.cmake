# Every policy there is: its kind, its type within namespace talus, its file. A new one is a line here.
talus_catalogue(Laws law::Hencky models/laws/hencky.hpp)
talus_catalogue(Laws law::NeoHookean models/laws/neo_hookean.hpp)
talus_catalogue(Laws law::DruckerPrager models/laws/drucker_prager.hpp)
talus_catalogue(Laws law::VonMises models/laws/von_mises.hpp)
talus_catalogue(Laws law::CamClayPerfect models/laws/modified_cam_clay.hpp)
talus_catalogue(Laws law::CamClay models/laws/modified_cam_clay.hpp)
talus_catalogue(Laws law::CamClaySinh models/laws/modified_cam_clay.hpp)
talus_catalogue(Laws law::CamClayExplicit models/laws/modified_cam_clay.hpp)
talus_catalogue(Laws law::CamClaySinhExplicit models/laws/modified_cam_clay.hpp)
talus_catalogue(Laws law::CamClayPerzyna models/laws/cam_clay_viscous.hpp)
talus_catalogue(Laws law::CamClayDuvautLions models/laws/cam_clay_viscous.hpp)
talus_catalogue(Laws law::CamClayMuI models/laws/cam_clay_mu_i.hpp)
talus_catalogue(Laws law::CamClayMuISinh models/laws/cam_clay_mu_i.hpp)
talus_catalogue(Laws law::CamClayMuIExplicit models/laws/cam_clay_mu_i.hpp)
talus_catalogue(Laws law::CamClayMuIHardeningFlow models/laws/cam_clay_hardening_flow.hpp)
talus_catalogue(Laws law::CamClayMuIConsistent models/laws/cam_clay_mu_i_consistent.hpp)
talus_catalogue(Laws law::CamClayMuIConsistentSinh models/laws/cam_clay_mu_i_consistent.hpp)

talus_catalogue(Kernels kernel::Linear models/kernels/linear.hpp)
talus_catalogue(Kernels kernel::Quadratic models/kernels/quadratic.hpp)
talus_catalogue(Kernels kernel::Cubic models/kernels/cubic.hpp)

talus_catalogue(Transfers transfer::Pic models/transfers/pic.hpp)
talus_catalogue(Transfers transfer::Flip models/transfers/flip.hpp)
talus_catalogue(Transfers transfer::Apic models/transfers/apic.hpp)
talus_catalogue(Transfers transfer::Aflip models/transfers/aflip.hpp)

talus_catalogue(Integrators integrator::Usl models/integrators/usl.hpp)
talus_catalogue(Integrators integrator::Musl models/integrators/musl.hpp)

talus_catalogue(Kinematics kinematics::Solid models/kinematics/solid.hpp)
talus_catalogue(Kinematics kinematics::PlaneStrain models/kinematics/plane_strain.hpp)
talus_catalogue(Kinematics kinematics::PlaneStrainReduced models/kinematics/plane_strain_reduced.hpp)

talus_catalogue(Shapes wall::HalfSpace models/boundaries/shapes/half_space.hpp)
talus_catalogue(Shapes wall::Box models/boundaries/shapes/box.hpp)
talus_catalogue(Shapes wall::Container models/boundaries/shapes/container.hpp)
talus_catalogue(Shapes wall::Polyline models/boundaries/shapes/polyline.hpp)

talus_catalogue(Contacts wall::Stick models/boundaries/contacts/stick.hpp)
talus_catalogue(Contacts wall::Slip models/boundaries/contacts/slip.hpp)
talus_catalogue(Contacts wall::Separating models/boundaries/contacts/separating.hpp)
talus_catalogue(Contacts wall::Coulomb models/boundaries/contacts/coulomb.hpp)
talus_catalogue(Contacts wall::MaterialFriction models/boundaries/contacts/material_friction.hpp)

talus_catalogue(Motions wall::Fixed models/boundaries/motions/fixed.hpp)
talus_catalogue(Motions wall::Translation models/boundaries/motions/translation.hpp)

talus_catalogue(Bodies body::Box models/bodies/shapes/box.hpp)
talus_catalogue(Bodies body::Polygon models/bodies/shapes/polygon.hpp)

talus_catalogue(Seedings body::Lattice models/bodies/seedings/lattice.hpp)
talus_catalogue(Seedings body::PoissonDisk models/bodies/seedings/poisson_disk.hpp)

talus_catalogue(VelocityFields body::AtRest models/bodies/velocities/at_rest.hpp)
talus_catalogue(VelocityFields body::Uniform models/bodies/velocities/uniform.hpp)
talus_catalogue(VelocityFields body::Linear models/bodies/velocities/linear.hpp)
talus_catalogue(VelocityFields body::Rotation models/bodies/velocities/rotation.hpp)
