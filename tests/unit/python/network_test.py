"""Which faults the events of a network break."""

import numpy as np

import synthetic_network
from asperity import Run, network
from asperity.errors import InputError, NothingToShow
from asperity_plot import event_table, windows
from folders import FolderCase


class Network(FolderCase):
    def setUp(self):
        super().setUp()
        synthetic_network.write_run(self.folder)
        self.run_ = Run(self.folder)

    def test_moments_by_event_and_fault(self):
        names, moments = network.moments(self.run_)
        self.assertEqual(names, ["across", "apart", "branch", "through"])
        np.testing.assert_array_equal(moments, [[8e11, 0, 0, 8e14], [3e14, 0, 0, 1e14],
                                                [0, 2e14, 0, 0]])
        np.testing.assert_allclose(moments.sum(axis=1), self.run_.events["moment_per_length"])

    def test_a_fault_breaks_with_a_share_of_the_moment(self):
        """Event 1 has a thousandth of its moment on the second fault."""
        for share, expected in ((0.01, 1), (1e-4, 2), (0.0, 2), (0.26, 0)):
            self.assertAlmostEqual(network.share_of_several(self.run_, share), expected / 3)

    def test_merged_events_break_the_faults_of_their_parts(self):
        merged = self.run_.select(merging_time=60.0)
        names, is_broken = network.broken(merged)
        self.assertEqual([[name for name, yes in zip(names, row) if yes] for row in is_broken],
                         [["through"], ["across", "apart", "through"]])
        self.assertEqual(network.share_of_several(merged), 0.5)

    def test_events_that_do_not_count_add_to_no_other(self):
        late = self.run_.select(start=2e8)
        np.testing.assert_array_equal(network.moments(late)[1],
                                      [[3e14, 0, 0, 1e14], [0, 2e14, 0, 0]])
        text = (self.folder / "events.csv").read_text().splitlines()
        del text[2]  # left out by Smallest Width of the deck, say
        (self.folder / "events.csv").write_text("\n".join(text) + "\n")
        np.testing.assert_array_equal(network.moments(Run(self.folder))[1],
                                      [[8e11, 0, 0, 8e14], [0, 2e14, 0, 0]])

    def test_the_table_of_events_names_the_faults(self):
        text = event_table.text(self.run_, windows.choose(self.run_, None))
        rows = [line.split("|")[-2].strip() for line in text.splitlines()
                if line.startswith("| ")][:5]
        self.assertEqual(rows[0], "breaks")
        self.assertEqual(rows[-3:], ["through", "across, through", "apart"])
        self.assertIn("1 of 3 events break more than one fault", text)

    def test_cycles_are_those_of_single_faults(self):
        """Events 1 and 2 break one fault 2e8 s apart; events 2 and 3 are 18 s apart."""
        view = windows.choose(self.run_, None)
        self.assertEqual(view.cycles, (0.0, synthetic_network.FINAL))

    def test_what_is_missing_is_said(self):
        for table in self.folder.glob("events_*.csv"):
            table.unlink()
        run = Run(self.folder)
        self.assertEqual(run.events_of_faults, {})
        with self.assertRaisesRegex(InputError, "Each Fault"):
            network.moments(run)
        self.assertNotIn("more than one fault", event_table.text(run, windows.choose(run, None)))

    def test_without_an_event_there_is_no_share(self):
        for table in self.folder.glob("events*.csv"):
            table.write_text(table.read_text().splitlines()[0] + "\n")
        with self.assertRaises(NothingToShow):
            network.share_of_several(Run(self.folder))
