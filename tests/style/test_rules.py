#!/usr/bin/env python3
"""Each rule lets a good tree pass and finds each bad sample, alone, in it."""

import importlib
import pathlib
import tempfile
import unittest

import check

GOOD = {
    "CMakeLists.txt": "asperity_add_package(friction LIBRARIES Asperity::Kokkos)\n"
                      "asperity_add_package(base)\n"
                      "asperity_add_package(mesh PACKAGES base LIBRARIES Asperity::METIS)\n",
    "packages/base/Types.hpp": "#pragma once\n#include <Teuchos_RCP.hpp>\n",
    "packages/mesh/Mesh.hpp": '#pragma once\n#include "base/Types.hpp"\n// #include "io/H5.hpp"\n',
    "packages/friction/Law.hpp": "#pragma once\n#include <Kokkos_Core.hpp>\n#include <cmath>\n",
    "packages/friction/Law.cpp":
        '#include "friction/Law.hpp"\nconst std::string label = "asperity::friction::b";\n'
        'Kokkos::parallel_for(\n  "asperity::friction::a", n, f);\n'
        "Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), f);\n"
        "Kokkos::parallel_reduce(label, n, f, sum); // parallel_for(n, f)\n",
    "drivers/asperity.cpp": "int main(int, char**)\n{\n}\n",
    "tests/ATest.cpp": 'GTEST_' 'SKIP() << "one rank only";\n',
    "xml/wedge.xml": "<!-- Ranks: 1. Run time: 1 s. Expected: two events. -->\n"
                     '<ParameterList name="Asperity"/>\n',
}

# rule -> files that break it, each laid over the good tree by itself
BAD = {
    "includes": [
        ("packages/base/Types.hpp", '#pragma once\n#include "mesh/Mesh.hpp"\n'),
        ("packages/mesh/Mesh.hpp", '#pragma once\n  # include "io/H5.hpp"\n'),
        ("packages/mesh/Mesh.hpp", '#pragma once\n#include "Types.hpp"\n'),
        ("packages/friction/Law.hpp", "#pragma once\n#include <Teuchos_RCP.hpp>\n"),
        ("packages/friction/Law.hpp", "#pragma once\n#include <KokkosBlas.hpp>\n"),
        ("packages/other/Thing.cpp", "int i;\n"),
        ("CMakeLists.txt", "asperity_add_package(friction PACKAGES base)\n"),
        ("CMakeLists.txt", "asperity_add_package(mesh PACKAGES base)\n"
                           "asperity_add_package(friction)\nasperity_add_package(base)\n"),
        ("CMakeLists.txt", "asperity_add_package(friction)\nasperity_add_package(base)\n"
                           "asperity_add_package(mesh PACKAGES base)\n"
                           "asperity_add_package(tnnmg PACKAGES mesh)\n"),
        ("CMakeLists.txt", "project(Asperity)\n"),
    ],
    "kernels": [
        ("packages/friction/Law.cpp", "Kokkos::parallel_for(n, f);\n"),
        ("packages/friction/Law.cpp", 'Kokkos::parallel_for("asperity::mesh::a", n, f);\n'),
        ("packages/friction/Law.cpp", 'Kokkos::parallel_reduce("a", n, f, sum);\n'),
        ("packages/friction/Law.cpp", "Kokkos::parallel_scan(label, n, f);\n"),
        ("packages/friction/Law.cpp", 'label = "b";\nKokkos::parallel_for(label, n, f);\n'),
        ("packages/friction/Law.cpp", "// \"\nKokkos::parallel_for<Policy<A, B>>(n, f);\n"),
    ],
    "layout": [
        ("cmake/Long.cmake", "#" + "x" * 100 + "\n"),
        ("tests/tab.py", "if True:\n\tpass\n"),
        ("drivers/asperity.cpp", "int main() {} \n"),
        ("drivers/asperity.cpp", "int main() {}"),
        ("packages/base/Types.cpp", "int i;\n" * 501),
        ("packages/base/Types.hpp", "// types\n#pragma once\n"),
    ],
    "marks": [
        ("packages/base/Types.cpp", "// TO" "DO: all\n"),
        ("cmake/a.cmake", "# XX" "X\n"),
        ("packages/base/README.md", "This is a st" "ub.\n"),
        ("tests/ATest.cpp", "EXPECT_TRUE(" "true);\n"),
        ("tests/ATest.cpp", "TEST(A, DIS" "ABLED_b) {}\n"),
        ("tests/ATest.cpp", "GTEST_" "SKIP();\n"),
    ],
    "drivers": [("drivers/asperity.cpp", "int main(int, char**)\n{\n}\n" + "//\n" * 77)],
    "decks": [
        ("xml/wedge.xml", '<ParameterList name="Asperity"/>\n'),
        ("xml/wedge.xml", '<!-- Ranks: 1. Run time: 1 s. -->\n<ParameterList name="Asperity"/>\n'),
        ("xml/wedge.xml", GOOD["xml/wedge.xml"].replace("Asperity", "Other")),
        ("xml/wedge.xml", GOOD["xml/wedge.xml"].replace("/>", ">")),
        ("xml/Wedge 2D.xml", GOOD["xml/wedge.xml"]),
    ],
    "names": [
        ("packages/base/StepManager.hpp", "#pragma once\n"),
        ("tests/test_utils.py", "\n"),
        ("packages/base/Types.hpp", "#pragma once\nstruct MeshHelper\n{\n};\n"),
    ],
}


class Rules(unittest.TestCase):
    def breaches(self, rule, extra=None):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in {**GOOD, **(extra or {})}.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            return importlib.import_module(f"rules.{rule}").check(root)

    def test_every_rule_has_bad_samples(self):
        self.assertEqual(sorted(BAD), sorted(check.RULES))

    def test_good_tree_passes(self):
        for rule in check.RULES:
            self.assertEqual(self.breaches(rule), [], rule)

    def test_bad_samples_are_found(self):
        for rule, samples in BAD.items():
            for name, text in samples:
                with self.subTest(rule=rule, file=name, text=text[:60]):
                    self.assertTrue(self.breaches(rule, {name: text}))

    def test_a_tree_without_decks_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            decks = importlib.import_module("rules.decks")
            self.assertTrue(decks.check(pathlib.Path(folder)))


if __name__ == "__main__":
    unittest.main()
