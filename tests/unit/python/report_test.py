"""asperity-report: one page that has everything and fetches nothing."""

import json
import re
import shutil
import subprocess
import unittest
from unittest import mock

import h5py
from matplotlib.image import imread

import synthetic_cycle
import synthetic_run
from asperity.run import Run
from asperity_plot import cli as plot_cli
from asperity_plot import event_table, maps, windows
from asperity_report import cli, provenance, report, sections
from asperity_report.page import page as whole_page, table
from folders import SharedFolderCase, told
from page_checks import Page

LOG = """Asperity 0.1.0 on Serial, 2 ranks.
Kokkos 3.4.1, Trilinos 13.2, Open MPI v4.1.4.
Built from commit 0123456789ab, GNU 12.2.0, Release, HDF5 1.10.8.
Mesh: 1200 triangles, 700 vertices, 1400 unknowns; cells have diameters of 0.003 to 0.05 m.
Resolution where friction weakens: cells of 0.004 m; cohesive zone G' L / (b sigma_n) >= 0.03 m, \
at least 7.5 cells.
Nucleation length >= 0.09 m (ageing law on an endless fault, Rubin & Ampuero 2005).
Machine: node17, 16 cores of Some CPU, Linux 6.1.0 x86_64.
t = 80 s of 100 s (80 %), step 900, dt 0.25 s, V 1.0e-09 m/s, 2 iterations, 3 events, wall 40 s
Finished at t = 100 s after 1000 steps.
Effort: 4000 coupled steps (3 failed), 5000 rate problems.

Work                                min [s]    max [s]    share      count
linear corrections                    9.31      10.31   62.5 %     161958
whole run                            16.44      16.44  100.0 %          1
"""
DECK = """<ParameterList name="Asperity">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="Wedge" isDefault="true"/>
    <ParameterList name="Wedge">
      <Parameter name="Length" type="double" value="1" isDefault="true"/>
      <Parameter name="Height" type="double" value="0.31"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Friction">
    <Parameter name="b" type="string" value="x &lt; 0.2 ? 0.005 : 0.014"/>
  </ParameterList>
</ParameterList>
"""

MEASURE = """<script>
const broken = [], root = document.documentElement, range = document.createRange();
for (const cell of document.querySelectorAll("table:not(.words) :is(td, th), td:not(:last-child)"))
  for (const text of cell.childNodes)
    for (const word of text.data ? text.data.matchAll(/\\S+/g) : []) {
      range.setStart(text, word.index);
      range.setEnd(text, word.index + word[0].length);
      if (new Set([...range.getClientRects()].map(each => each.top)).size > 1)
        broken.push(word[0]);
    }
const tables = [...document.querySelectorAll("table")];
document.title = `broken: ${broken.join(" ") || "none"}; page: `
  + `${root.scrollWidth > root.clientWidth ? "moves" : "fits"}; tables that scroll: `
  + tables.filter(each => each.scrollWidth > each.clientWidth).length;
</script>"""


class Report(SharedFolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for module, name, size in ((maps, "COLUMNS", 300), (maps, "POSITIONS", 100),
                                   (report, "DPI", 60)):
            coarse = mock.patch.object(module, name, size)
            coarse.start()
            cls.addClassCleanup(coarse.stop)
        cls.run_folder = cls.folder / "a <run> & more"
        synthetic_run.write_run(cls.run_folder, 4, nodes=30)
        (cls.run_folder / "run.log").write_text(LOG)
        (cls.run_folder / "parameters.xml").write_text(DECK)
        with h5py.File(cls.run_folder / "checkpoint.h5", "w") as file:
            text = h5py.string_dtype()
            file.attrs["fingerprint"] = "0123456789abcdef"
            group = file.create_group("fingerprint")
            group.create_dataset("parameters", data=["Asperity / Mesh", "Asperity / Friction / b"],
                                 dtype=text)
            group.create_dataset("values", data=["00c0ffee", "0.1"], dtype=text)
            group.create_dataset("contents", data=["the numbered mesh", ""], dtype=text)
        cls.status, cls.out, cls.err = cls.report(cls.run_folder)
        cls.path = cls.run_folder / "report.html"
        cls.html = cls.path.read_text(encoding="utf-8")
        cls.page = Page(cls.html)

    @staticmethod
    def report(*arguments):
        return told(cli.main, *arguments)

    def test_says_where_the_page_is(self):
        self.assertEqual((self.status, self.err), (0, ""))
        self.assertEqual(self.out.strip(), str(self.path))

    def test_fetches_nothing_and_runs_nothing(self):
        self.assertEqual(self.page.external(), [])
        self.assertEqual(self.page.scripts, 0)
        self.assertIn("a <run> & more", "".join(self.page.headings))

    def test_links_lead_somewhere(self):
        links = [each[1:] for each in self.page.references if str(each).startswith("#")]
        self.assertGreater(len(links), 3)
        self.assertEqual([each for each in links if each not in self.page.ids], [])

    def test_size_and_resolution(self):
        for words in ("700 vertices, 1400 unknowns", "cells of 0.004 m", "at least 7.5 cells",
                      "Nucleation length &gt;= 0.09 m"):
            self.assertIn(words, self.html)

    def test_figures_come_before_tables(self):
        places = [self.html.index(f'<h2 id="{name}">') for name in
                  ("state", "model", "figures", "events", "parameters", "solver", "provenance")]
        self.assertEqual(places, sorted(places))
        self.assertLess(self.html.index("<img"), self.html.index("<table"))

    def test_formulas_of_replaced_names(self):
        for text, shown in (("(1e-09) / 2", "1e-09 / 2 = 5e-10"), ("2 * (500)", "2 * 500 = 1000"),
                            ("x < (0.35) * sqrt(1 + (0.27)^2)", "x < 0.35 * sqrt(1 + (0.27)^2)"),
                            ("max(0.5)", "max(0.5)"), ("3 - (-2)", "3 - (-2)"),
                            ("(7)", "7"), ("{1, 2}", "{1, 2}"), ("Newmark", "Newmark")):
            self.assertEqual(sections.plain(text), shown)

    def test_only_parameters_that_differ(self):
        rows = {row[0]: row[1:] for row in self.page.rows if row}
        self.assertEqual(rows["Mesh/Wedge/Height"], ["0.31"])
        self.assertEqual(rows["Friction/b"], ["x < 0.2 ? 0.005 : 0.014"])
        self.assertNotIn("Mesh/Wedge/Length", rows)
        self.assertNotIn("Mesh/Type", rows)

    def test_all_events(self):
        header = next(row for row in self.page.rows if row[:1] == ["event"])
        self.assertIn("onset", header[1])
        events = [row for row in self.page.rows if row[0] in "1234" and len(row) == len(header)]
        self.assertEqual([row[0] for row in events], ["1", "2", "3", "4"])

    def test_all_figures_that_asperity_plot_draws(self):
        told(plot_cli.main, self.run_folder, "--dpi", "40", "--output", self.folder / "figures")
        drawn = {path.stem for path in (self.folder / "figures").glob("*.png")}
        self.assertEqual({image["id"] for image in self.page.images}, drawn)
        for image in self.page.images:
            self.assertTrue(image["src"].startswith("data:image/png;base64,"))
            self.assertTrue(image["alt"])

    def test_words_do_not_break_and_wide_tables_scroll_in_their_own_box(self):
        style = re.search("<style>(.*)</style>", self.html, re.DOTALL)[1]
        rules = {selector: body.split(";")
                 for selectors, body in re.findall(r"([^{}]+)\{([^{}]*)\}", style)
                 for selector in selectors.strip().split(",")}
        self.assertLessEqual({"display:block", "overflow-x:auto"}, set(rules["table"]))
        breaking = [each for each, body in rules.items() if "overflow-wrap:anywhere" in body]
        self.assertTrue(breaking and all(each.startswith(".words ") for each in breaking), breaking)
        self.assertLessEqual({"overflow-wrap:normal", "min-width:14em"},
                             set(rules[".words td:first-child"]))
        self.assertNotIn("word-break", style)
        self.assertIn('<table class="words">\n<tr><th>parameter</th>', self.html)
        self.assertIn("Mesh/<wbr>Wedge/<wbr>Height", self.html)
        self.assertIn("<table>\n<tr><th>event</th>", self.html)

    def test_tables_of_many_columns_are_several(self):
        folder = self.folder / "cycle"
        synthetic_cycle.write_run(folder)
        run, wrong = Run(folder), []
        view = windows.choose(run, None)
        rows = Page(sections.events(run, view, wrong)).rows
        columns = event_table.events(run, view)
        self.assertGreater(len(columns), sections.MOST_COLUMNS)
        self.assertLessEqual(max(len(row) for row in rows), sections.MOST_COLUMNS)
        headers = [row for row in rows if row[0] == "event"][:2]
        self.assertEqual(headers[0] + headers[1][1:], [column.header for column in columns])
        self.assertEqual(wrong, [])

    def test_where_time_went(self):
        rows = {row[0]: row[1:] for row in self.page.rows if row}
        self.assertEqual(rows["linear corrections"], ["9.31", "10.31", "62.5 %", "161958"])
        self.assertIn("4000 coupled steps (3 failed)", "".join(self.page.text))

    def test_provenance(self):
        text = "".join(self.page.text)
        for words in ("commit 0123456789ab", "Trilinos 13.2", "node17", "2 ranks", "00c0ffee",
                      "the numbered mesh"):
            self.assertIn(words, text)
        rows = {row[0]: row[1:] for row in self.page.rows if row}
        digest = subprocess.run(["sha256sum", str(self.run_folder / "parameters.xml")], text=True,
                                capture_output=True, check=True).stdout.split()[0].lstrip("\\")
        self.assertIn(digest, rows["parameters.xml"])
        self.assertEqual(rows[provenance.WHOLE], ["0123456789abcdef"])
        for words in ("no random numbers", "no seed"):
            self.assertIn(words, text)

    def test_a_run_that_has_just_begun(self):
        folder = self.folder / "new"
        folder.mkdir()
        (folder / "run.log").write_text("Asperity 0.1.0 on Serial, 1 rank.\n")
        status, _, err = self.report(folder)
        self.assertEqual((status, err), (0, ""))
        self.assertEqual(Page((folder / "report.html").read_text()).images, [])

    def test_what_is_damaged_is_named_and_the_rest_is_there(self):
        folder = self.folder / "damaged"
        shutil.copytree(self.run_folder, folder)
        (folder / "steps.csv").unlink()
        (folder / "surface.h5").write_bytes(b"no HDF5")
        status, _, err = self.report(folder)
        self.assertEqual((status, err.count("surface.h5")), (2, 1), err)
        page = Page((folder / "report.html").read_text())
        self.assertIn("slip_rate", {image["id"] for image in page.images})

    def test_of_a_full_disk(self):
        """The journal decides, and what is left of tables and histories adds to it."""
        folder = self.folder / "full"
        shutil.copytree(self.run_folder, folder)
        message = "full/steps.csv cannot be written. Is the disk full?"
        (folder / "run.jsonl").write_text(json.dumps(
            {"event": "end", "step": 9, "time": 1.0, "how": "failed", "exit_status": 5,
             "message": message, "wall_time": 9.0, "kind": "output"}) + "\n")
        for name in ("events.csv", "surface.h5"):
            (folder / name).write_bytes(b"")
        steps = (folder / "steps.csv").read_text()
        (folder / "steps.csv").write_text(steps + "17,not a number\n")
        status, _, err = self.report(folder)
        self.assertEqual((status, err.count("\n")), (2, 1), err)
        self.assertIn("steps.csv is damaged", err)
        html = (folder / "report.html").read_text(encoding="utf-8")
        self.assertIn("failed: " + message, html)
        self.assertIn("events: events.csv is empty", html)
        self.assertIn("surface.h5 is empty", html)
        self.assertIn("slip_rate", {image["id"] for image in Page(html).images})

    def test_no_run(self):
        status, out, err = self.report(self.folder / "nothing")
        self.assertEqual((status, out, err.count("\n")), (2, "", 1))

    def test_another_place(self):
        target = self.folder / "elsewhere.html"
        folder = self.folder / "small"
        folder.mkdir()
        (folder / "run.log").write_text(LOG)
        self.assertEqual(self.report(folder, "--output", target)[0], 0)
        self.assertTrue(target.exists())
        status, _, err = self.report(folder, "--output", "/nowhere/at/all.html")
        self.assertEqual((status, err.count("\n")), (2, 1))

    def browse(self, *words: str) -> str:
        """What a browser without a network prints."""
        command = ["chromium", "--headless", "--no-sandbox", "--disable-gpu",
                   "--host-resolver-rules=MAP * ~NOTFOUND", "--hide-scrollbars",
                   f"--user-data-dir={self.folder}/profile"]
        return subprocess.run([*command, *words], check=True, capture_output=True,
                              timeout=90).stdout.decode()

    @unittest.skipUnless(shutil.which("chromium"), "there is no chromium")
    def test_a_narrow_window_breaks_no_word_and_moves_only_tables_sideways(self):
        parts = [("numbers", "Numbers", table(["slip at"] * 30, [["123,456.7"] * 30])),
                 ("words", "Words", table(["file", "bytes", "SHA-256"],
                                          [["List/" + 40 * "x", 9 * "1", 300 * "y"]], True)),
                 ("measured", "Measured", MEASURE)]
        path = self.folder / "narrow.html"
        path.write_text(whole_page("narrow", parts), encoding="utf-8")
        dom = self.browse("--window-size=600,800", "--dump-dom", path.as_uri())
        self.assertEqual(re.search("<title>(.*)</title>", dom)[1],
                         "broken: none; page: fits; tables that scroll: 1")

    @unittest.skipUnless(shutil.which("chromium"), "there is no chromium")
    def test_in_a_browser_without_a_network(self):
        picture = self.folder / "page.png"
        page = self.path.resolve().as_uri()
        self.browse("--window-size=1000,6000", f"--screenshot={picture}", page)
        shown = imread(picture)[..., :3]
        self.assertEqual(shown.shape[:2], (6000, 1000))
        # figures have colour; a page whose pictures are missing has text and grey lines alone
        coloured = (shown.max(axis=2) - shown.min(axis=2) > 0.3).sum(axis=1) > 20
        self.assertGreater(coloured.sum(), 20 * len(self.page.images))
        without = self.folder / "without.html"
        without.write_text(re.sub('src="data:[^"]*"', "", self.html), encoding="utf-8")
        self.browse("--window-size=1000,6000", f"--screenshot={picture}", without.as_uri())
        bare = imread(picture)[..., :3]
        left = (bare.max(axis=2) - bare.min(axis=2) > 0.3).sum(axis=1) > 20
        self.assertLess(left.sum(), 0.1 * coloured.sum())  # the links
        self.assertEqual(len(Page(self.browse("--dump-dom", page)).images), len(self.page.images))
