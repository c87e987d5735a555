#!/usr/bin/env python3
"""Each rule lets a good tree pass and finds each bad sample, alone, in it."""

import importlib
import os
import pathlib
import tempfile
import unittest
import unittest.mock

import check
import parameter_texts
from rules import format as format_rule

README = ("# {}\n\nThe package is for a test of the rules, among others. It is not for \n"
          "computations of any kind.\n\n| header | for |\n")

GOOD = {
    ".clang-format": "DisableFormat: true\n",
    "CMakeLists.txt": "asperity_add_package(friction LIBRARIES Asperity::Kokkos)\n"
                      "asperity_add_package(base)\n"
                      "asperity_add_package(mesh PACKAGES friction base\n"
                      "  LIBRARIES Asperity::METIS)\n",
    "packages/base/README.md": README.format("base"),
    "packages/mesh/README.md": README.format("mesh").replace(
        "kind.", "kind. It includes\n`friction`\nand `base`; `other` does not."),
    "packages/friction/README.md": README.format("friction"),
    "packages/base/Types.hpp": "#pragma once\n#include <Teuchos_RCP.hpp>\n",
    "packages/mesh/Mesh.hpp": '#pragma once\n#include "base/Types.hpp"\n// #include "io/H5.hpp"\n',
    "packages/friction/Law.hpp": "#pragma once\n#include <Kokkos_Core.hpp>\n#include <cmath>\n",
    "packages/friction/Law.cpp":
        '#include "friction/Law.hpp"\nconst std::string label = "asperity::friction::b";\n'
        'Kokkos::parallel_for(\n  "asperity::friction::a", n, f);\n'
        "Kokkos::parallel_for(Kokkos::TeamThreadRange(team, n), f);\n"
        "Kokkos::parallel_reduce(label, n, f, sum); // parallel_for(n, f)\n"
        "ASPERITY_REGISTER_FRICTION_LAW(Law)\n",
    # Rooms that include each other one way; detail/ is a part of its folder.
    "packages/mesh/faults/Split.hpp":
        '#pragma once\n#include "mesh/Mesh.hpp"\n#include "mesh/faults/detail/Side.hpp"\n',
    "packages/mesh/faults/detail/Side.hpp":
        '#pragma once\n#include "mesh/faults/Pair.hpp"\n',
    "packages/mesh/file/File.hpp": '#pragma once\n#include "mesh/faults/Split.hpp"\n',
    # Device lambdas where nvcc takes them; other functions of the class are private.
    "packages/mesh/Kernels.cpp":
        "namespace a\n{\nclass A\n{\npublic:\n  void f(int n);\nprivate:\n  void h();\n};\n"
        "void A::f(int n)\n{\n  g(n, KOKKOS_LAMBDA(int i) { h(i); });\n}\n"
        "void h()\n{\n  g(1, KOKKOS_LAMBDA(int) {});\n}\n} // namespace a\n",
    "drivers/asperity.cpp": "int main(int, char**)\n{\n}\n",
    "tests/ATest.cpp": 'GTEST_' 'SKIP() << "one rank only";\n',
    "xml/wedge.xml": "<!-- Ranks: 1. Run time: 1 s. Expected: two events. -->\n"
                     '<ParameterList name="Asperity"/>\n',
}

# rule -> files that break it, each laid over the good tree by itself
PARAMETERS = """<ParameterList name="Asperity">
  <!-- This list describes the mesh. -->
  <ParameterList name="Mesh">
    <!-- a number in (0, inf) m; default 0.1. Unit: m. The body reaches along z to this depth. -->
    <Parameter name="Depth" type="double" value="0.1"/>
    <!-- an array of numbers; optional. Gravity has this direction. Its length has no effect. -->
    <!-- <Parameter name="Up" type="Array(double)" value="{0, 1}"/> -->
    <!-- Each entry defines a region by a condition. -->
    <!-- A list with any number of entries, named by you:
Regions
  <region>
      a number in (-inf, inf); required. Unit: 1. A cell belongs to it where this is not zero.

# This list is one of the pieces.
Regions / <piece>
  Name
      a text; required. The piece has this name.
    -->
    <!--
Mesh, with Type = Box
  Height
      a number in (0, inf) m; required. Unit: m. The box has this height.
    -->
    <!-- For Type = Wedge. -->
    <ParameterList name="Wedge">
    </ParameterList>
  </ParameterList>
</ParameterList>
"""
# a part of PARAMETERS, and what makes it bad
BAD_TEXTS = [
    ("The body reaches along z to this depth.", "Depth along z of the body."),
    ("The body reaches along z to this depth.", "It is deep."),
    ("The body reaches along z to this depth.", "the body reaches to this depth."),
    ("The body reaches along z to this depth.", "The body reaches to this depth"),
    (" The body reaches along z to this depth.", ""),
    (" Unit: m.", ""),
    (" Its length has no effect.", ""),
    ("Each entry defines a region by a condition.", "Regions by a condition."),
    ("A cell belongs to it where this is not zero.", "Condition in x, y, z."),
    ("This list is one of the pieces.", "One of the pieces."),
    ("The piece has this name.", "Name of the piece."),
    ("The box has this height.", "Height of the box."),
    ("  <!-- This list describes the mesh. -->\n", ""),
]

BAD = {
    "includes": [
        ("packages/base/Types.hpp", '#pragma once\n#include "mesh/Mesh.hpp"\n'),
        ("packages/mesh/Mesh.hpp", '#pragma once\n  # include "io/H5.hpp"\n'),
        ("packages/mesh/Mesh.hpp", '#pragma once\n#include "Types.hpp"\n'),
        ("packages/friction/Law.hpp", "#pragma once\n#include <Teuchos_RCP.hpp>\n"),
        ("packages/friction/Law.hpp", "#pragma once\n#include <KokkosBlas.hpp>\n"),
        ("packages/other/Thing.cpp", "int i;\n"),
        ("CMakeLists.txt", "asperity_add_package(friction PACKAGES base)\n"),
        ("CMakeLists.txt", "asperity_add_package(friction)\nasperity_add_package(base)\n"
                           "asperity_add_package(mesh PACKAGES base)\n"
                           "asperity_add_package(catalogue)\n"
                           "asperity_add_package(io PACKAGES catalogue)\n"),
        ("CMakeLists.txt", "asperity_add_package(mesh PACKAGES base)\n"
                           "asperity_add_package(friction)\nasperity_add_package(base)\n"),
        ("CMakeLists.txt", "asperity_add_package(friction)\nasperity_add_package(base)\n"
                           "asperity_add_package(mesh PACKAGES base)\n"
                           "asperity_add_package(tnnmg PACKAGES mesh)\n"),
        ("CMakeLists.txt", "project(Asperity)\n"),
        ("packages/mesh/Mesh.hpp", "#pragma once\n"),
        ("packages/friction/Law.cpp", '#include "friction/Law.hpp"\n'),
    ],
    "folders": [
        ("packages/mesh/Mesh.cpp", '#include "mesh/faults/Split.hpp"\n'),
        ("packages/mesh/faults/detail/Side.hpp", '#pragma once\n#include "mesh/file/File.hpp"\n'),
    ],
    "kernels": [
        ("packages/friction/Law.cpp", "Kokkos::parallel_for(n, f);\n"),
        ("packages/friction/Law.cpp", 'Kokkos::parallel_for("asperity::mesh::a", n, f);\n'),
        ("packages/friction/Law.cpp", 'Kokkos::parallel_reduce("a", n, f, sum);\n'),
        ("packages/friction/Law.cpp", "Kokkos::parallel_scan(label, n, f);\n"),
        ("packages/friction/Law.cpp", 'label = "b";\nKokkos::parallel_for(label, n, f);\n'),
        ("packages/friction/Law.cpp", "// \"\nKokkos::parallel_for<Policy<A, B>>(n, f);\n"),
    ],
    "renamed": [
        ("packages/mesh/Rows.cpp", "int n = A.getNodeNumRows();\n"),
        ("packages/mesh/Rows.cpp", "int n = A->getLocalNumEntries();\n"),
        ("tests/ATest.cpp", "double x = Kokkos::Experimental::sqrt(2.);\n"),
        ("packages/tnnmg/A.cpp", "auto A = MueLu::Utilities<double>::Op2TpetraCrs(wrapped);\n"),
        ("drivers/A.cpp", "auto A = MueLu::TpetraCrs_To_XpetraMatrix<double>(matrix);\n"),
    ],
    "devices": [
        ("packages/mesh/A.cpp", "class A\n{\n  void f() { g(KOKKOS_LAMBDA(int) {}); }\n};\n"),
        ("packages/mesh/A.cpp", "struct A\n{\nprivate:\n  void f() const;\n};\n"
                                "void A::f() const\n{\n  if (x) {\n    g(KOKKOS_LAMBDA(int i) "
                                "{ h(i); });\n  }\n}\n"),
        ("tests/ATest.cpp", "TEST(A, b)\n{\n  g(KOKKOS_LAMBDA(int i) { h(i); });\n}\n"),
        ("packages/tnnmg/Sweep.cpp", "auto x = r.getLocalViewHost(ReadOnly);\n"),
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
    "drivers": [
        ("drivers/asperity.cpp", "int main(int, char**)\n{\n}\n" + "//\n" * 77),
        ("drivers/CMakeLists.txt", "asperity_add_driver(asperity SOURCES asperity.cpp)\n"
                                   "foreach(program other)\nendforeach()\n"),
        ("cmake/quickstart.sh", "compile --target asperity\n"),
    ],
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
        ("tests/ATest.cpp", "TEST_F(A, holds)\n{\n}\n"),
    ],
    "readmes": [
        ("packages/base/README.md", README.format("mesh")),
        ("packages/base/README.md", README.format("base").replace("is for", "has")),
        ("packages/base/README.md", README.format("base").replace("is not for", "has no")),
        ("packages/base/README.md", "# base\n\n| header | is for this and is not for that |\n"),
        ("packages/base/README.md", "# base\n\nIt is for it. It is not for it.\n"),
        ("packages/base/README.md", README.format("base") + "`mesh/Gone.hpp`\n"),
        ("packages/other/Thing.cpp", "int i;\n"),
        ("packages/mesh/README.md", README.format("mesh")),
        ("packages/mesh/README.md",
         README.format("mesh").replace("kind.", "kind. It includes `base`. `friction` does not.")),
        ("packages/base/README.md",
         README.format("base").replace("kind.", "kind. It includes `mesh`.")),
    ],
    "format": [(".clang-format", "BasedOnStyle: LLVM\n"), (".clang-format", "NoSuchOption: 1\n")],
}


# The rule `format` needs a program, whose absence tests/style/CMakeLists.txt reports.
RUNNING = [rule for rule in check.RULES if rule != "format" or format_rule.program()]


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
        for rule in RUNNING:
            self.assertEqual(self.breaches(rule), [], rule)

    def test_bad_samples_are_found(self):
        for rule in RUNNING:
            for name, text in BAD.get(rule, []):
                with self.subTest(rule=rule, file=name, text=text[:60]):
                    self.assertTrue(self.breaches(rule, {name: text}))

    def test_texts_of_parameters(self):
        self.assertEqual(parameter_texts.breaches(PARAMETERS), [])
        for good, bad in BAD_TEXTS:
            with self.subTest(bad=bad):
                self.assertIn(good, PARAMETERS)
                self.assertTrue(parameter_texts.breaches(PARAMETERS.replace(good, bad)))

    def test_a_missing_clang_format_is_a_breach(self):
        with unittest.mock.patch.dict(os.environ, ASPERITY_CLANG_FORMAT="no-such-program"):
            self.assertIn("apt-get install", self.breaches("format")[0])

    def test_a_tree_without_decks_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            decks = importlib.import_module("rules.decks")
            self.assertTrue(decks.check(pathlib.Path(folder)))


if __name__ == "__main__":
    unittest.main()
