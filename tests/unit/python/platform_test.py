"""asperity-platform writes the files of platforms from the results of a run."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy as np
import synthetic_fault as synthetic
from asperity_platform.cli import main


class Writing(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name) / "run"

    def write(self, problem, *options):
        """The status and all that is said."""
        told = io.StringIO()
        with contextlib.redirect_stdout(told), contextlib.redirect_stderr(told):
            status = main(["write", str(self.folder), problem, *options])
        return status, told.getvalue()

    def text(self, name):
        return (self.folder / name).read_text(encoding="ascii")

    def lines(self, name, problem, *options):
        """Those that do not begin with '#', of a file that is written."""
        self.assertEqual(self.write(problem, *options)[0], 0)
        return [line for line in self.text(name).splitlines() if not line.startswith("#")]

    def refused(self, problem, *options):
        status, told = self.write(problem, *options)
        self.assertEqual(status, 2, told)
        return told


class Stations(Writing):
    def test_a_file_for_seas(self):
        synthetic.write_run(self.folder, synthetic.LEVEL, "Antiplane", rows=(0, 2, 4))
        lines = self.lines("seas/fltst_dp000", "BP1-QD", "--author", "A. Modeller")
        self.assertEqual(self.text("seas/fltst_dp003"), """\
# This is the file header:
# problem=BP1-QD
# author=A. Modeller
# date=2024/05/31
# code=Asperity
# code_version=1.2
# element_size=50 m
# location=on fault, (0.3, 0) m, 0.3 m from the end of smaller x
# minimum_time_step=4.000000E-01
# maximum_time_step=4.000000E-01
# num_time_steps=4%s
# Column #1 = Time (s)
# Column #2 = Slip (m)
# Column #3 = Slip rate (log10 m/s)
# Column #4 = Shear stress (MPa)
# Column #5 = State (log10 s)
# The line below lists the names of the data fields:
t slip slip_rate shear_stress state
 0.00000000000000E+00   0.000000E+00  -5.228787E-01   3.000000E-01   8.000000E+00
 8.00000000000000E-01   2.400000E-01  -5.228787E-01  -5.000000E-01   8.000000E+00
 1.60000000000000E+00   4.800000E-01  -5.228787E-01  -1.300000E+00   8.000000E+00
""" % (11 * " "))
        self.assertEqual(lines[1], " 0.00000000000000E+00   0.000000E+00  -9.900000E+01   "
                                   "0.000000E+00   8.000000E+00")
        body = self.lines("seas/blkst_inside", "BP1-QD")
        self.assertEqual(body[0], "t disp vel")
        self.assertEqual(body[2], " 8.00000000000000E-01   2.800000E+00   7.500000E-01")

    def test_water_adds_its_pressure_and_flow_for_seas(self):
        synthetic.write_run(self.folder, synthetic.LEVEL, "Antiplane", enabled=["Pore Pressure"])
        synthetic.add_fields(self.folder, pore_pressure=4e6, darcy_velocity=(9.0, -2e-7))
        lines = self.lines("seas/fltst_dp003", "BP6-QD-A")
        self.assertEqual(lines[0], "t slip slip_rate shear_stress pore_pressure darcy_vel state")
        self.assertIn("   3.000000E-01   4.000000E+00   2.000000E-07   8.000000E+00", lines[1])
        self.assertIn("# Column #5 = Pore pressure (MPa)\n# Column #6 = Darcy velocity down (m/s)\n"
                      "# Column #7 = State (log10 s)\n", self.text("seas/fltst_dp003"))

    def test_heat_adds_temperature_and_pressure_for_scec(self):
        synthetic.write_run(self.folder, synthetic.LEVEL, enabled=["Thermal Pressurisation"])
        synthetic.add_fields(self.folder, temperature=503.0, fluid_pressure=8e7,
                             effective_normal_stress=4.5e7)
        lines = self.lines("scec/faultdp003", "TPV105")
        self.assertEqual(lines[0], "t h-slip h-slip-rate h-shear-stress v-slip v-slip-rate "
                                   "v-shear-stress n-stress log-theta temperature pressure")
        self.assertIn("   4.500000E+01   8.000000E+00   5.030000E+02   8.000000E+01", lines[1])
        self.assertIn("# Column #8 = effective normal stress (MPa)\n",
                      self.text("scec/faultdp003"))
        self.assertIn("# Column #10 = temperature (K)\n# Column #11 = pore pressure (MPa)\n",
                      self.text("scec/faultdp003"))

    def test_in_plane_strain_seas_takes_normal_stress_and_two_components(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        lines = self.lines("seas/fltst_dp000", "BP3-QD")
        self.assertEqual(lines[0], "t slip slip_rate shear_stress normal_stress state")
        self.assertIn(" 5.000000E+01   8.000000E+00", lines[1])
        body = self.lines("seas/srfst_inside", "BP3-QD")
        self.assertEqual(body[0], "t disp_1 disp_2 vel_1 vel_2")
        self.assertEqual(body[1], " 0.00000000000000E+00   2.000000E+00   4.000000E+00   "
                                  "7.500000E-01   1.500000E+00")

    def test_in_a_section_seas_counts_thrusts_and_depths_positive(self):
        synthetic.write_run(self.folder, synthetic.THRUST)
        lines = self.lines("seas/fltst_dp003", "BP3-QD")
        self.assertEqual(lines[5], " 1.60000000000000E+00  -4.800000E-01  -5.228787E-01   "
                                   "1.300000E+00   5.030000E+01   8.000000E+00")
        self.assertIn(", 0.3 m from the upper end\n", self.text("seas/fltst_dp003"))
        self.assertEqual(self.lines("seas/srfst_inside", "BP3-QD")[1],
                         " 0.00000000000000E+00   2.000000E+00  -4.000000E+00   7.500000E-01  "
                         "-1.500000E+00")
        synthetic.write_run(self.folder, synthetic.SECTION)
        self.assertIn("   4.800000E-01  -5.228787E-01  -1.300000E+00   5.030000E+01",
                      self.lines("seas/fltst_dp003", "BP3-QD")[5])

    def test_rows_for_scec_have_equal_steps(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        lines = self.lines("scec/faultdp003", "TPV101", "--time-step", "0.25")
        self.assertIn("# time_step=2.500000E-01\n# num_time_steps=7  ",
                      self.text("scec/faultdp003"))
        self.assertEqual(len(lines), 1 + 7)  # 0 to 1.5 s of 1.6 s
        self.assertEqual(lines[0], "t h-slip h-slip-rate h-shear-stress v-slip v-slip-rate "
                                   "v-shear-stress n-stress log-theta")
        self.assertEqual(lines[6], " 1.25000000000000E+00   3.750000E-01   3.000000E-01  "
                                   "-9.500000E-01   0.000000E+00   0.000000E+00   0.000000E+00   "
                                   "5.030000E+01   8.000000E+00")
        body = self.lines("scec/bodyinside", "TPV101", "--time-step", "0.25")
        self.assertEqual(body[0], "t h-disp h-vel v-disp v-vel n-disp n-vel")
        self.assertEqual(body[6], " 1.25000000000000E+00   3.250000E+00   7.500000E-01   "
                                  "0.000000E+00   0.000000E+00   5.250000E+00   1.500000E+00")
        self.assertEqual(len(self.lines("scec/faultdp003", "TPV101", "--time-step", "0.4")), 1 + 5)

    def test_too_many_of_these_rows(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        told = self.refused("TPV101", "--time-step", "1e-7")
        self.assertIn("--time-step 1e-07 s gives each receiver 1.6e+07 rows until 1.6 s", told)

    def test_in_a_section_scec_takes_slip_down_dip(self):
        synthetic.write_run(self.folder, synthetic.SECTION)
        self.assertEqual(self.lines("scec/faultdp000", "TPV10", "--time-step", "0.4")[5],
                         " 1.60000000000000E+00   0.000000E+00   0.000000E+00   0.000000E+00   "
                         "0.000000E+00   0.000000E+00  -1.600000E+00   5.000000E+01   8.000000E+00")
        # v is along y, n along x.
        self.assertEqual(self.lines("scec/bodyinside", "TPV10")[1],
                         " 0.00000000000000E+00   0.000000E+00   0.000000E+00   4.000000E+00   "
                         "1.500000E+00   2.000000E+00   7.500000E-01")

    def test_a_model_in_space(self):
        """Strike is z: slip 3.8, rate 0.6, traction 3.2; down is -y: slip -1.9, rate -0.3, -2.2."""
        synthetic.write_space(self.folder)
        lines = self.lines("seas/fltst_st12dp07", "BP5-QD")
        self.assertEqual(lines[0], "t slip_2 slip_3 slip_rate_2 slip_rate_3 shear_stress_2 "
                                   "shear_stress_3 state")
        self.assertEqual(lines[1], " 0.00000000000000E+00   3.800000E+00  -1.900000E+00  "
                                   "-2.218487E-01  -5.228787E-01   3.200000E+00  -2.200000E+00   "
                                   "8.000000E+00")
        self.assertIn("# location=on fault, (0, -0.7, 1.2) m\n", self.text("seas/fltst_st12dp07"))
        body = self.lines("seas/blkst_inside", "BP5-QD")
        self.assertEqual(body[0], "t disp_1 disp_2 disp_3 vel_1 vel_2 vel_3")
        self.assertEqual(body[1], " 0.00000000000000E+00   3.000000E-01   4.000000E-01   "
                                  "2.100000E+00   1.000000E+00   3.000000E+00  -2.000000E+00")
        self.assertEqual(self.lines("scec/faultst12dp07", "TPV101")[1],
                         " 0.00000000000000E+00   3.800000E+00   6.000000E-01   3.200000E+00  "
                         "-1.900000E+00  -3.000000E-01  -2.200000E+00   2.500000E+01   "
                         "8.000000E+00")
        self.assertEqual(self.lines("scec/bodyinside", "TPV101")[1],
                         " 0.00000000000000E+00   4.000000E-01   3.000000E+00   2.100000E+00  "
                         "-2.000000E+00   3.000000E-01   1.000000E+00")

    def test_water_flows_along_strike_and_down_dip(self):
        synthetic.write_space(self.folder, ["Pore Pressure"])
        synthetic.add_fields(self.folder, pore_pressure=3e6, darcy_velocity=(1e-7, 2e-7, 3e-7))
        lines = self.lines("seas/fltst_st12dp07", "BP8-QD-GS")
        self.assertEqual(lines[0], "t slip_2 slip_3 slip_rate_2 slip_rate_3 shear_stress_2 "
                                   "shear_stress_3 pore_pressure darcy_vel_2 darcy_vel_3 state")
        self.assertIn("  -2.200000E+00   3.000000E+00   3.000000E-07  -2.000000E-07   8.000000",
                      lines[1])


class OtherFiles(Writing):
    def history(self, fault, **options):
        """A fault with nodes at 0, 0.75 and 1 m from its upper end that slips by 2 - y."""
        synthetic.write_run(self.folder, fault, **options)
        places = np.array([0.0, 0.75, 1.0])
        with h5py.File(self.folder / "fault.h5", "w") as file:
            file["time"] = [0.0, 2.0]
            file["peak_slip_rate"] = [0.0, 0.01]
            file["geometry/positions"] = places
            file["geometry/coordinates"] = np.stack((0 * places, -places), axis=1)
            file["fields/slip"] = np.array([[0.0], [2.0]]) + places
        return self.lines("seas/slip.dat", "BP3-QD")

    def test_slip_from_the_upper_end_down(self):
        rows = [" 0.00000000000000E+00   0.000000E+00   0.000000E+00   7.500000E-01   1.000000E+00",
                " 0.00000000000000E+00  -9.900000E+01   0.000000E+00   7.500000E-01   1.000000E+00",
                " 2.00000000000000E+00  -2.000000E+00   2.000000E+00   2.750000E+00   3.000000E+00"]
        self.assertEqual(self.history(synthetic.SECTION),
                         ["z", "t", "max_slip_rate", "slip", *rows])
        self.assertIn("# Row #1 = Distance along the fault from its upper end (m) with two zeros "
                      "first\n# Column #1 = Time (s)\n# Column #2 = Max slip rate (log10 m/s)\n"
                      "# Column #3-5 = Slip (m)\n", self.text("seas/slip.dat"))

    def test_slip_of_thrusts_is_positive(self):
        self.assertEqual(self.history(synthetic.THRUST)[-1],
                         " 2.00000000000000E+00  -2.000000E+00  -2.000000E+00  -2.750000E+00  "
                         "-3.000000E+00")

    def test_without_slip_there_is_no_profile(self):
        self.history(synthetic.SECTION)
        with h5py.File(self.folder / "fault.h5", "a") as file:
            del file["fields/slip"]
        self.assertIn("has no 'fields/slip', of which slip.dat is made. It belongs to 'Output / "
                      "Fault History / Fields'", self.refused("BP3-QD"))

    def test_peak_and_moment_rate(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        (self.folder / "global.csv").write_text(
            "time [s],peak_slip_rate [m/s],moment_rate_per_length [N/s],moment_per_length [N]\n"
            "0,0,0,0\n2,3.75,2718750,7500000\n")
        lines = self.lines("seas/global.dat", "BP1-QD")
        self.assertEqual(lines, ["t max_slip_rate moment_rate",
                                 " 0.00000000000000E+00  -9.900000E+01   0.000000E+00",
                                 " 2.00000000000000E+00   5.740313E-01   2.718750E+06"])
        self.assertIn("= Moment rate per length (N/s)\n", self.text("seas/global.dat"))
        self.write("TPV101")
        self.assertFalse((self.folder / "scec/global.dat").exists())

    def ruptures(self, **geometry):
        with h5py.File(self.folder / "rupture.h5", "w") as file:
            file["threshold"] = [1e-2]
            file["first_rupture_time"] = [0.5, np.nan]
            for name, values in geometry.items():
                file[f"geometry/{name}"] = values

    def test_rupture_times_of_a_curve(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        self.ruptures(positions=[1 / 16, 1])
        for problem, name in (("BP1-QD", "seas/rupture.dat"), ("TPV101", "scec/cplot")):
            lines = self.lines(name, problem)
            self.assertEqual(lines, ["x2 x3 t" if "BP" in problem else "j k t",
                                     "  6.250000E-02   0.000000E+00  5.00000000000000E-01",
                                     "  1.000000E+00   0.000000E+00  1.00000000000000E+09"])
            self.assertIn("# Column #1 = Distance along strike (m) from the fault's end of smaller "
                          "x\n# Column #2 = Distance down dip (m), 0 at the upper end of the "
                          "fault\n# Column #3 = Time (s) at which the slip rate first reached 0.01 "
                          "m/s;  1.00000000000000E+09: never\n", self.text(name))

    def test_rupture_times_of_a_surface_count_from_where_the_problem_does(self):
        synthetic.write_space(self.folder)
        self.ruptures(coordinates=[[0, -2, 3], [0, 0, -1]])
        self.assertEqual(self.lines("scec/cplot", "TPV101", "--depth-of-upper-end", "7500")[1:],
                         ["  3.000000E+00   7.502000E+03  5.00000000000000E-01",
                          " -1.000000E+00   7.500000E+03  1.00000000000000E+09"])


class Refusals(Writing):
    def test_a_field_that_the_run_lacks(self):
        synthetic.write_run(self.folder, synthetic.LEVEL, enabled=["Pore Pressure"],
                            model="Antiplane")
        told = self.refused("BP6-QD-A")
        self.assertIn("receivers.h5 has no field 'pore_pressure' of receivers on fault, which SEAS "
                      "takes. It belongs to 'Output / Receivers / Fault Fields'", told)

    def test_a_fault_without_friction(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file["on_fault/fields/normal_stress"], file["on_fault/fields/theta"]
        for problem in ("BP3-QD", "TPV101"):
            self.assertIn("needs a fault with friction", self.refused(problem))

    def test_a_run_that_does_not_say_how_its_fault_lies(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        (self.folder / "run.jsonl").write_text('{"event": "begin", "clock": 0}\n')
        self.assertIn("does not say how the fault lies", self.refused("BP1-QD"))

    def test_a_problem_of_no_platform(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        self.assertIn("'Mine' is no problem of a known platform", self.refused("Mine"))
        self.assertEqual(self.write("Mine", "--format", "scec")[0], 0)

    def test_a_line_end_in_a_header(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        self.assertIn("Write it in one line", self.refused("BP1-QD", "--author", "A\n1 2 3"))

    def test_an_empty_run(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        (self.folder / "receivers.h5").unlink()
        self.assertIn("has nothing of which files for SEAS are made: fltst_*: the run has no "
                      "receivers.h5; srfst_*", self.refused("BP3-QD"))

    def test_faults_of_two_senses(self):
        synthetic.write_run(self.folder, synthetic.LEVEL, one_sense=0)
        status, told = self.write("BP3-QD")
        self.assertEqual(status, 0)
        self.assertIn("WARNING: positive slip has not the same sense on all faults", told)
        synthetic.write_run(self.folder, synthetic.LEVEL, one_sense=1)
        self.assertNotIn("WARNING", self.write("BP3-QD")[1])

    def test_files_of_an_earlier_run_go(self):
        synthetic.write_run(self.folder, synthetic.LEVEL)
        (self.folder / "seas").mkdir()
        for name in ("fltst_dp999", "slip.dat", "notes.txt"):
            (self.folder / "seas" / name).write_text("of an earlier run")
        self.assertEqual(self.write("BP3-QD")[0], 0)
        self.assertEqual(sorted(path.name for path in (self.folder / "seas").iterdir()),
                         ["fltst_dp000", "fltst_dp003", "notes.txt", "srfst_inside"])


if __name__ == "__main__":
    unittest.main()
