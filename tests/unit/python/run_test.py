"""A run directory read in three lines, with every number as it stands in the files."""

import h5py
import numpy as np

import asperity
import synthetic_cycle
import synthetic_run
from folders import SharedFolderCase


class Reading(SharedFolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.wedge = cls.folder / "wedge"
        cls.cycle = cls.folder / "cycle"
        synthetic_run.write_run(cls.wedge, 4, nodes=40)
        synthetic_cycle.write_run(cls.cycle)

    def test_three_lines(self):
        run = asperity.Run(str(self.wedge))
        time, rate = run.fault.time, run.fault["slip_rate"]
        onset = run.events["onset"]
        with h5py.File(self.wedge / "fault.h5") as file:
            np.testing.assert_array_equal(time, file["time"][:])
            np.testing.assert_array_equal(rate, file["fields/slip_rate"][:])
        self.assertEqual(onset.size, 4)
        self.assertAlmostEqual(onset[0], synthetic_run.FIRST, delta=0.1)

    def test_fields_have_names_and_places(self):
        run = asperity.Run(self.wedge)
        self.assertEqual(sorted(run.fault.fields), ["slip", "slip_rate"])
        self.assertEqual(run.surface.fields, ["displacement"])
        vectors = run.surface["displacement"]
        self.assertEqual(vectors.shape, (run.surface.time.size, 20, 2))
        self.assertEqual(run.fault.coordinates.shape, (40, 2))
        with self.assertRaisesRegex(asperity.InputError, "slap.*slip"):
            run.fault["slap"]

    def test_units_of_fields(self):
        path = self.folder / "units"
        synthetic_run.write_run(path, 1, nodes=20)
        with h5py.File(path / "fault.h5", "a") as file:
            file["fields/slip"].attrs["unit"] = "m"
        self.assertEqual(asperity.Run(path).fault.unit("slip"), "m")
        self.assertEqual(asperity.Run(path).fault.unit("slip_rate"), "")

    def test_parameters(self):
        parameters = asperity.Run(self.wedge).parameters
        self.assertEqual(parameters.number("Mesh/Wedge/Length"), 1.0)
        self.assertEqual(parameters.text("Mesh/Type"), "Wedge")
        self.assertEqual(parameters["Bulk/Gravity Direction"], "{0.27, -1.0}")
        with self.assertRaisesRegex(asperity.InputError, "Mesh/Tipe.*Mesh/Type"):
            parameters["Mesh/Tipe"]

    def test_tables_by_column(self):
        run = asperity.Run(self.wedge)
        self.assertEqual(len(run.steps), run.steps["time"].size)
        self.assertEqual(run.steps.units["step_size"], "s")
        self.assertIn("peak_slip", run.events)
        self.assertEqual(list(run.events), list(run.events.columns))
        self.assertEqual(run.totals.path.name if run.has("global.csv") else None, None)

    def test_receivers_as_they_were_written(self):
        receivers = asperity.Run(self.cycle).receivers
        with h5py.File(self.cycle / "receivers.h5") as file:
            name = file["on_fault/names"].asstr()[1]
            slip = file["on_fault/fields/slip"][:, 1]
        self.assertIn(name, receivers.names)
        np.testing.assert_array_equal(receivers[name]["slip"].reshape(slip.shape), slip)
        self.assertEqual(receivers.time.size, slip.shape[0])
        with self.assertRaisesRegex(asperity.InputError, "nowhere"):
            receivers["nowhere"]

    def test_what_the_deck_did_not_ask_for(self):
        with self.assertRaisesRegex(asperity.InputError, "volume.h5 does not exist"):
            asperity.Run(self.wedge).volume

    def test_no_run(self):
        with self.assertRaisesRegex(asperity.InputError, "holds no result"):
            asperity.Run(self.folder)
