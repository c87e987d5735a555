"""What the documents name is there: files, decks, programs, options, messages; versions agree."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"])
BUILD = pathlib.Path(os.environ["ASPERITY_BUILD_DIR"])
LINK = re.compile(r"\]\(([^)#\s]+)(?:#[^)]*)?\)")
PICTURE = re.compile(r"!\[[^]]+\]\(([^)\s]+\.png)\)")
PROGRAM = re.compile(r"^ {4}(?:\S+ )*?(?:\S*/)?(asperity(?:-[a-z]+)?) ", re.MULTILINE)
# A diary: when, beside what and with which state something was measured.
DIARY = re.compile(r"beside other work|commit [0-9a-f]{7}|asked for|"
                   r"20[0-9]{2}-[01][0-9]-[0-3][0-9]")


def pages(*folders):
    """All Markdown of these folders, and of the top, that git would keep."""
    return sorted(SOURCE.glob("*.md")) + [path for folder in folders
                                          for path in sorted((SOURCE / folder).rglob("*.md"))]


def text(name):
    return (SOURCE / name).read_text(encoding="utf-8")


def sources():
    """All that prints messages; literals that are split over lines are joined."""
    parts = [path.read_text(encoding="utf-8")
             for folder in ("packages", "drivers", "python", "cmake")
             for path in sorted((SOURCE / folder).rglob("*"))
             if path.suffix in (".cpp", ".hpp", ".py", ".cmake")]
    return re.sub(r'"\s*\n\s*f?"', "", "\n".join(parts))


class Pages(unittest.TestCase):
    def test_links_lead_somewhere(self):
        all_pages = pages("docs", "log", "python", "packages", "drivers", "examples", "xml",
                          "tests")
        found = [(path.relative_to(SOURCE), link) for path in all_pages
                 for link in LINK.findall(path.read_text(encoding="utf-8"))
                 if "://" not in link and not (path.parent / link).exists()]
        self.assertEqual(found, [])
        self.assertGreater(sum(len(LINK.findall(path.read_text())) for path in all_pages), 30)

    def test_documents_are_no_diary(self):
        for folder in ("docs", "xml", "packages", "drivers", "python", "examples"):
            for path in sorted((SOURCE / folder).rglob("*")):
                if path.suffix in (".md", ".xml", ".hpp", ".cpp", ".py", ".txt"):
                    self.assertIsNone(DIARY.search(path.read_text(encoding="utf-8")), path)
        for path in pages():
            if path.name != "CHANGELOG.md":
                self.assertIsNone(DIARY.search(path.read_text(encoding="utf-8")), path)

    def test_the_first_page_is_short(self):
        self.assertLessEqual(len(text("README.md").splitlines()), 100)

    def test_versions_agree(self):
        version = re.search(r"project\(Asperity VERSION (\S+)", text("CMakeLists.txt"))[1]
        self.assertIn(f"version: {version}\n", text("CITATION.cff"))
        self.assertIn(f'__version__ = "{version}"', text("python/asperity/__init__.py"))
        self.assertIn(f"## {version}", text("CHANGELOG.md"))


class Examples(unittest.TestCase):
    def test_every_deck_has_a_section(self):
        examples = text("docs/examples.md")
        for deck in sorted((SOURCE / "xml").glob("*.xml")):
            section = re.search(rf"^### [^\n]*`{deck.stem}`\n.*?(?=^##|\Z)", examples,
                                re.MULTILINE | re.DOTALL)
            self.assertIsNotNone(section, f"{deck.name} has no section")
            for words in (f"xml/{deck.name}", "**Look at:**", "**Change:**"):
                self.assertIn(words, section[0], deck.name)
            pictures = PICTURE.findall(section[0])
            self.assertTrue(pictures, f"{deck.name} has no picture")
            for picture in pictures:
                self.assertTrue((SOURCE / "docs" / picture).is_file(), f"{deck.name}: {picture}")

    def test_regions_of_the_model_are_valid(self):
        piece = re.search(r"^```xml\n(.*?)^```", text("docs/model.md"), re.MULTILINE | re.DOTALL)
        deck = SOURCE / "tests" / "verification" / "flow" / "savage_prescott.xml"
        with tempfile.TemporaryDirectory() as folder:
            overlay = pathlib.Path(folder) / "regions.xml"
            overlay.write_text('<ParameterList name="Asperity"><ParameterList name="Bulk">'
                               f"{piece[1]}</ParameterList></ParameterList>")
            told = subprocess.run([BUILD / "drivers" / "asperity", deck, "--overlay", overlay,
                                   "--set", "Mesh/Regions/crust=y > -plate", "--validate"],
                                  text=True, capture_output=True, check=False)
        self.assertEqual(told.returncode, 0, told.stderr)
        self.assertIn("is valid", told.stdout)

    def test_settings_are_parameters(self):
        printed = subprocess.run([BUILD / "drivers" / "asperity", "--print-parameters"], text=True,
                                 capture_output=True, check=True).stdout
        names = set(re.findall(r"^  (\S.*)$", printed, re.MULTILINE))
        settings = re.findall(r'--set "([^"=]+)=', " ".join(text("docs/examples.md").split()))
        decks = "".join(deck.read_text() for deck in (SOURCE / "xml").glob("*.xml"))
        for name in [each for each in settings if each.startswith("Names/")]:
            settings.remove(name)
            self.assertIn(f'<Parameter name="{name.split("/")[1]}"', decks)
        self.assertGreater(len(settings), 10)
        for setting in settings:
            self.assertIn(setting.split("/")[-1], names, setting)

    def test_pieces_of_the_first_model_are_its_deck(self):
        pieces = re.findall(r"^```xml\n(.*?)^```", text("docs/first_model/plane.md"),
                            re.MULTILINE | re.DOTALL)
        self.assertGreater(len(pieces), 5)
        deck = " ".join(text("examples/first_model/plane.xml").split())
        for piece in pieces:
            self.assertIn(" ".join(piece.split()), deck)


# Of programs whose commands have helps of their own.
COMMANDS = {"asperity-platform": [["write"], ["check"], ["zip"]]}


class Reference(unittest.TestCase):
    def test_commands_name_programs_that_exist(self):
        for page in ("README.md", "docs/examples.md", "docs/start/cluster.md",
                     "docs/reference/programs.md"):
            programs = set(PROGRAM.findall(text(page)))
            self.assertTrue(programs, page)
            for program in programs:
                self.assertTrue((BUILD / "drivers" / program).exists(), f"{page}: {program}")

    def test_every_option_is_described(self):
        page = text("docs/reference/programs.md")
        described = set(re.findall(r"`(--[a-z][a-z-]+)", page))
        for program in sorted((BUILD / "drivers").glob("asperity*")):
            if not program.is_file() or not os.access(program, os.X_OK):
                continue
            self.assertIn(f"`{program.name}`", page)
            told = "".join(subprocess.run([program, *command, "--help"], text=True,
                                          capture_output=True, check=True).stdout
                           for command in COMMANDS.get(program.name, [[]]))
            options = set(re.findall(r"(?<![\w-])(--[a-z][a-z-]+)", told)) - {"--help"}
            self.assertGreater(len(options), 0, program)
            self.assertEqual(sorted(options - described), [], program)

    def test_messages_are_those_of_the_programs(self):
        entries = re.findall(r"^\| `([^`|]+)` \|", text("docs/reference/messages.md"), re.MULTILINE)
        self.assertGreater(len(entries), 30)
        all_sources = sources()
        self.assertEqual([entry for entry in entries if entry not in all_sources], [])


if __name__ == "__main__":
    unittest.main()
