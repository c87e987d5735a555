"""What the documents name is there: files, decks, programs, tests; versions agree."""

import os
import pathlib
import re
import subprocess
import unittest

SOURCE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["ASPERITY_BUILD_DIR"])
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
PICTURE = re.compile(r"!\[[^]]+\]\(([^)\s]+\.png)\)")
OTHER_PROGRAMS = {"--build", "--install", "--prefix", "--list-presets",  # cmake
                  "--test-dir", "--oversubscribe", "--bind-to", "--mca"}  # ctest, mpirun
PROGRAM = re.compile(r"^ {4}(?:\S+ )*?(?:\S*/)?(asperity(?:-[a-z]+)?) ", re.MULTILINE)


def pages():
    """All Markdown of the tree that git would keep."""
    folders = ["docs", "python", "packages", "drivers", "examples", "xml", "tests"]
    return sorted(SOURCE.glob("*.md")) + [path for folder in folders
                                          for path in sorted((SOURCE / folder).rglob("*.md"))]


def text(name):
    return (SOURCE / name).read_text(encoding="utf-8")


def claims():
    """The first column of the page's first table."""
    table = text("docs/claims.md").split("\n## ")[0]
    return [row.strip() for row in re.findall(r"^\|([^|]*)\|", table, re.MULTILINE)]


class Documents(unittest.TestCase):
    def test_links_lead_somewhere(self):
        found = [(path.relative_to(SOURCE), link) for path in pages()
                 for link in LINK.findall(path.read_text(encoding="utf-8"))
                 if "://" not in link and not (path.parent / link).exists()]
        self.assertEqual(found, [])
        self.assertGreater(sum(len(LINK.findall(path.read_text())) for path in pages()), 30)

    def test_every_deck_has_a_tutorial(self):
        tutorial = text("docs/tutorials.md")
        for deck in sorted((SOURCE / "xml").glob("*.xml")):
            section = re.search(rf"^## [^\n]*`{deck.stem}`\n.*?(?=^## |\Z)", tutorial,
                                re.MULTILINE | re.DOTALL)
            self.assertIsNotNone(section, f"{deck.name} has no section")
            for words in (f"xml/{deck.name}", "**Look at:**", "**Change:**"):
                self.assertIn(words, section[0], deck.name)
            pictures = PICTURE.findall(section[0])
            self.assertTrue(pictures, f"{deck.name} has no picture")
            for picture in pictures:
                self.assertTrue((SOURCE / "docs" / picture).is_file(), f"{deck.name}: {picture}")

    def test_options_of_the_readme_have_a_claim(self):
        options = set(re.findall(r"--[a-z][a-z-]+", text("README.md"))) - OTHER_PROGRAMS
        self.assertGreater(len(options), 10)
        claimed = set(re.findall(r"--[a-z][a-z-]+", " ".join(claims())))
        self.assertEqual(sorted(options - claimed), [])

    def test_exit_statuses_of_the_readme_have_a_claim(self):
        statuses = re.search(r"^Exit status: (.*?)\. ", text("README.md"), re.MULTILINE | re.DOTALL)
        numbers = re.findall(r"\b\d\b", statuses[1])
        self.assertGreater(len(numbers), 5)
        for number in numbers:
            rows = [row for row in claims() if row.startswith(f"exit status {number}: ")]
            self.assertEqual(len(rows), 1, f"exit status {number}")

    def test_commands_name_programs_that_exist(self):
        for page in ("README.md", "docs/tutorials.md", "docs/cluster.md"):
            programs = set(PROGRAM.findall(text(page)))
            self.assertTrue(programs, page)
            for program in programs:
                self.assertTrue((BUILD / "drivers" / program).exists(), f"{page}: {program}")

    def test_settings_in_tutorials_are_parameters(self):
        printed = subprocess.run([BUILD / "drivers" / "asperity", "--print-parameters"], text=True,
                                 capture_output=True, check=True).stdout
        names = set(re.findall(r"^  (\S.*)$", printed, re.MULTILINE))
        settings = re.findall(r'--set "([^"=]+)=', " ".join(text("docs/tutorials.md").split()))
        for name in [each for each in settings if each.startswith("Names/")]:
            settings.remove(name)
            self.assertIn(f'<Parameter name="{name.split("/")[1]}"', text("xml/wedge_2d.xml"))
        self.assertGreater(len(settings), 10)
        for setting in settings:
            self.assertIn(setting.split("/")[-1], names, setting)

    def test_claims_cite_tests_that_exist(self):
        listed = subprocess.run([os.environ["ASPERITY_CTEST"], "--test-dir", str(BUILD), "-N"],
                                text=True, capture_output=True, check=True).stdout
        tests = set(re.findall(r"Test +#\d+: (\S+)", listed))
        tests |= {re.sub(r"_MPI_\d+$", "", test) for test in tests}
        cited = re.findall(r"`((?:unit|regression|verification|style|performance)\.[\w.-]+)`",
                           text("docs/claims.md"))
        self.assertGreater(len(cited), 20)
        benchmarks = {path.parent.name for path in (SOURCE / "tests").glob("benchmark/*/*")}
        for test in cited:
            self.assertIn(test, tests, "docs/claims.md")
        for name in re.findall(r"`tests/benchmark/(\w+)`", text("docs/claims.md")):
            self.assertIn(name, benchmarks)

    def test_versions_agree(self):
        version = re.search(r"project\(Asperity VERSION (\S+)", text("CMakeLists.txt"))[1]
        self.assertIn(f"version: {version}\n", text("CITATION.cff"))
        self.assertIn(f'__version__ = "{version}"', text("python/asperity/__init__.py"))
        self.assertIn(f"## {version}", text("CHANGELOG.md"))


if __name__ == "__main__":
    unittest.main()
