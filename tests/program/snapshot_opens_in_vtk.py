#!/usr/bin/python3
"""VTK's own reader, not ours, opens the frames of a run in the plane and of one in space, by the same program. Exit 77
where VTK is not installed (Debian: python3-vtk9)."""
import sys
import unittest

from talus_process import SOURCE, InFolder, coarse_dam, study

sys.path.insert(0, str(SOURCE / "tests/io"))
import read_with_vtk as vtk  # noqa: E402


class Frames(InFolder):
    def frames_of(self, case):
        self.run_quietly(self.save(case), "run")
        summary, names = self.read("run", "summary.json"), sorted((self.folder / "run/frames").iterdir())
        vtk.check_list(self.folder / "run/frames.pvd")
        grids = [vtk.read(name) for name in names]
        for grid in grids:
            self.assertEqual(grid.GetNumberOfPoints(), summary["particles"])
        self.assertEqual(vtk.check_structure(grids[0]), 0)
        self.assertEqual(vtk.check_structure(grids[-1]), summary["time"])
        return [vtk.arrays_of(grid) for grid in grids], summary

    def agrees_with_the_summary(self, arrays, summary, axes):
        """What VTK reads and sums itself is what the program measured; sums of n doubles differ by n eps at most."""
        mass = arrays["mass"][:, 0]
        tolerance = len(mass) * 2.3e-16
        for d, axis in enumerate("xyz"[:axes]):
            for measure, field in (("centre_of_mass", "Points"), ("mean_velocity", "velocity")):
                values = arrays[field][:, d]
                wanted = summary["measures"][f"{measure}_{axis}"]
                self.assertAlmostEqual((mass * values).sum() / mass.sum(), wanted, None, f"{measure}_{axis}",
                                       tolerance * abs(values).max())

    def test_a_run_in_the_plane(self):
        frames, summary = self.frames_of(coarse_dam())
        self.assertEqual(len(frames), 6)
        for arrays in frames:
            self.assertTrue((arrays["Points"][:, 2] == 0).all(), "a frame of the plane leaves the plane")
            self.assertEqual(arrays["velocity"].shape[1], 3)
        self.assertEqual(abs(frames[0]["velocity"]).max(), 0)
        self.agrees_with_the_summary(frames[-1], summary, 2)

    def test_particles_keep_their_numbers(self):
        frames, _ = self.frames_of(coarse_dam())
        for arrays in frames:
            self.assertEqual(sorted(arrays["id"][:, 0]), list(range(len(arrays["id"]))))

    def test_a_run_in_space(self):
        case = study("column_3d")
        case["grid"]["spacing"] = 0.008
        case["time"]["end"] = 0.05
        case["output"]["frames_every"] = 0.02
        frames, summary = self.frames_of(case)
        self.assertEqual(len(frames), 4)
        self.assertGreater(abs(frames[-1]["Points"][:, 2]).max(), 0.01)
        self.assertGreater(abs(frames[-1]["velocity"][:, 2]).max(), 0)
        self.agrees_with_the_summary(frames[-1], summary, 3)


if __name__ == "__main__":
    unittest.main()
