"""The manual is a site that needs no network: it is searched and read by a browser."""

import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest
import urllib.parse

BUILD = pathlib.Path(os.environ["ASPERITY_BUILD_DIR"])
SITE = BUILD / "manual"
BROWSER = shutil.which("chromium")
LOCAL = re.compile(r'(?:href|src)="([^"]+)"')


def built():
    """Made once; the target treats warnings as errors."""
    made = subprocess.run([os.environ["ASPERITY_CMAKE"], "--build", BUILD, "--target", "manual"],
                          text=True, capture_output=True)
    return made.returncode, made.stdout + made.stderr


def shown(address):
    """What a browser without a network makes of a page, after its scripts have run."""
    with tempfile.TemporaryDirectory() as profile:
        result = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
             "--host-resolver-rules=MAP * ~NOTFOUND", "--virtual-time-budget=10000",
             "--allow-file-access-from-files", "--dump-dom", address],
            text=True, capture_output=True, timeout=100)
    return result.stdout


def text_of(page):
    return re.sub(r"<[^>]*>", " ", page)


class Manual(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        status, cls.output = built()
        if status != 0:
            raise AssertionError(cls.output)

    def test_links_lead_somewhere(self):
        number = 0
        for page in SITE.rglob("*.html"):
            for link in LOCAL.findall(page.read_text(encoding="utf-8")):
                parts = urllib.parse.urlsplit(link)
                if parts.scheme or parts.netloc or not parts.path:
                    continue
                number += 1
                target = page.parent / urllib.parse.unquote(parts.path)
                self.assertTrue(target.exists(), f"{page}: {link}")
        self.assertGreater(number, 1000)

    def test_nothing_is_fetched(self):
        loaded = re.compile(r'<(?:script|img|iframe)[^>]*\ssrc="(?:https?:)?//'
                            r'|<link[^>]*rel="stylesheet"[^>]*href="(?:https?:)?//')
        for page in SITE.rglob("*.html"):
            self.assertIsNone(loaded.search(page.read_text(encoding="utf-8")), page)

    @unittest.skipUnless(BROWSER, "there is no chromium")
    def test_search_finds_a_word(self):
        for word in ("topography", "GNSS"):
            page = shown((SITE / "search.html").as_uri() + f"?q={word}")
            results = re.search(r'<div id="search-results">.*', page, re.DOTALL)[0]
            self.assertRegex(results, r'<li[^>]*>\s*<a href="', word)
        page = shown((SITE / "search.html").as_uri() + "?q=nucleation")
        results = re.search(r'<div id="search-results">.*', page, re.DOTALL)[0]
        self.assertRegex(text_of(results), r"finished.*page.* matching")
        links = re.findall(r'<li[^>]*>\s*<a href="([^"]+)"', results)
        self.assertGreater(len(links), 1)
        found = shown((SITE / links[0].split("?")[0].split("#")[0]).as_uri())
        self.assertIn("nucleation", text_of(found).lower())

    @unittest.skipUnless(BROWSER, "there is no chromium")
    def test_menu_leads_through_the_chapters(self):
        page = shown((SITE / "index.html").as_uri())
        menu = re.search(r'<div class="sidebar-tree">.*?</div>', page, re.DOTALL)[0]
        entries = re.findall(r'<a[^>]*href="([^"#]+)"[^>]*>([^<]+)</a>', menu)
        self.assertGreater(len(entries), 15)
        for link, title in entries[:3] + entries[-3:]:
            self.assertIn(f"<h1>{title}", shown((SITE / link).as_uri()).replace("\n", " "))

    @unittest.skipUnless(BROWSER, "there is no chromium")
    def test_equations_are_drawn(self):
        page = shown((SITE / "model.html").as_uri())
        self.assertGreater(page.count("<math"), 10)
        self.assertNotIn('mathvariant="bold"', page)  # browsers draw no bold letter for it
        self.assertIn("<mi>\U0001d42e</mi>", page)  # the bold u

    def test_the_first_page_has_a_figure_a_table_and_a_command(self):
        page = (SITE / "index.html").read_text(encoding="utf-8")
        self.assertIn("wedge_2d_slip_rate.png", page)
        self.assertIn("bash cmake/quickstart.sh run", page)
        self.assertGreater(page.count("<tr"), 6)
        for name in ("reference/studies.html", "reference/figures.html", "limits.html"):
            self.assertTrue((SITE / name).exists(), name)


if __name__ == "__main__":
    unittest.main()
