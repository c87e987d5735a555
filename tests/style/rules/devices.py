"""What devices forbid: kernels in private functions, and more ways of whole vectors to the host.

nvcc refuses a device lambda whose function is private or protected, as the body of a TEST is. In
the packages that compute in every step a host view of a vector stands only where HOST says why.
"""

import re

from . import source

FOLDERS = ["packages", "drivers", "tests", "examples"]
COMPUTING = ["packages/multigrid", "packages/tnnmg", "packages/dynamics"]
HOST = {
    "packages/multigrid/AddedBlocks.cpp": "set-up; MPI sends blocks of the fault from the host",
    "packages/multigrid/CoarsestSolver.cpp": "Eigen's dense factor, of the coarsest level",
    "packages/multigrid/Cycle.cpp": "which components of the coarsest level are free",
    "packages/multigrid/NodeGraph.cpp": "MPI sends ghosts from the host",
    "packages/multigrid/NodeGraph.hpp": "couplings of the coarsest level",
    "packages/tnnmg/DenseRateMatrix.cpp": "set-up; Eigen's product with a dense matrix",
    "packages/tnnmg/DenseRateMatrix.hpp": "Eigen's product with a dense matrix",
    "packages/tnnmg/FaultColumns.cpp": "MPI sends some hundred numbers of the fault from the host",
    "packages/tnnmg/direct/DenseCorrection.cpp": "right sides and answers of Eigen's dense factor",
    "packages/tnnmg/direct/KeptFactor.cpp": "Eigen's dense factor, of the fault's unknowns",
    "packages/tnnmg/direct/KeptFactor.hpp": "Eigen's dense factor, of the fault's unknowns",
    "packages/tnnmg/direct/EigenMatrix.hpp": "set-up of Eigen's factors",
    "packages/tnnmg/direct/SchurComplement.cpp": "Eigen's sparse factor, on one rank",
    "packages/tnnmg/hierarchy/CoarseFault.cpp": "set-up; blocks of the fault, which MPI sends",
    "packages/tnnmg/hierarchy/FewerRanks.cpp": "set-up of coarse levels",
    "packages/tnnmg/hierarchy/NodeGraphs.cpp": "set-up",
    "packages/tnnmg/correction/OwnPreconditioner.cpp": "set-up",
    "packages/tnnmg/correction/MultigridSymmetry.cpp": "set-up: the trial of the preconditioner",
    "packages/dynamics/fault/FaultMotion.cpp": "the message of a refusal",
    "packages/dynamics/observables/FaultSample.cpp": "the nodes of the fault, for outputs",
    "packages/dynamics/initial/StaticNormalStress.cpp": "set-up",
    "packages/dynamics/initial/InitialAlpha.cpp": "set-up",
    "packages/dynamics/initial/InitialAcceleration.cpp": "set-up",
    "packages/dynamics/initial/WithHeld.cpp": "set-up",
    "packages/dynamics/fault/NormalReaction.cpp": "set-up: rows of the matrices",
    "packages/dynamics/condensation/CondensedModel.cpp": "set-up of the condensed model",
    "packages/dynamics/condensation/StaticCondensation.cpp": "direct solver; checkpoints",
    "packages/dynamics/condensation/VertexMotion.cpp": "the rows of a few points, on one rank",
    "packages/dynamics/control/NotFinite.cpp": "the place of a number that ends the run",
    "packages/dynamics/processes/DiffusionStep.cpp": "Eigen's factor, of the nodes of the fault",
    "packages/dynamics/processes/Permeability.cpp": "the nodes of the fault, for its stiffness",
    "packages/dynamics/processes/PorePressure.cpp": "the nodes of the fault, for outputs",
    "packages/dynamics/rate/CondensedFunctionals.cpp": "the direct solver, on Eigen's factors",
    "packages/dynamics/rate/CondensedRateSolver.cpp": "the direct solver, on Eigen's factors",
}
_TO_HOST = re.compile(r"\b(?:getLocalViewHost|getLocalMatrixHost|create_mirror_view\w*|toHost)\b"
                      r"|(?<!\.)\btoVector\b")
_LAMBDA = re.compile(r"\bKOKKOS_(?:CLASS_)?LAMBDA\b")
_SCOPE = re.compile(r"\b(?:class|struct)\s+(\w+)[^;()]*$")
_FUNCTION = re.compile(r"(?:(\w+)::)?(~?\w+)\s*\($")
_TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|[{};]|\b(?:public|private|protected)\s*:(?!:)')


def check(root):
    texts = {path: source.without_comments(path.read_text())
             for path in source.files(root, FOLDERS, source.CXX)}
    hidden, lambdas = set(), []
    for path, text in texts.items():
        scopes = list(_scopes(text))
        hidden |= {(owner, name) for owner, name, access, _, _ in scopes if access == "hidden"}
        lambdas += [(path, text, match.start(), scopes) for match in _LAMBDA.finditer(text)]
        hidden |= set(_hidden_declarations(text))
    breaches = []
    for path, text, position, scopes in lambdas:
        around = [s for s in scopes if s[3] < position < s[4]]
        if any((s[0], s[1]) in hidden or s[1].startswith(("TEST", "TYPED_TEST")) for s in around):
            owner, name = around[0][:2]
            message = f"a device lambda in the private function {owner or ''}::{name}"
            breaches.append(source.breach(root, path, source.line_of(text, position), message))
    return breaches + _host_views(root, texts)


def _host_views(root, texts):
    breaches = []
    for path, text in texts.items():
        name = path.relative_to(root).as_posix()
        if name in HOST or not any(name.startswith(folder + "/") for folder in COMPUTING):
            continue
        for match in _TO_HOST.finditer(text):
            message = f"{match.group(0)}: vectors of a step stay on the device"
            breaches.append(source.breach(root, path, source.line_of(text, match.start()), message))
    return breaches


def _walk(text):
    """Yields (kind, head, begin, stack) at each brace and semicolon; head is the text before it.

    The stack holds [owner, access] of the enclosing classes and None for all other braces.
    """
    stack, begin = [], 0
    for token in _TOKEN.finditer(text):
        word = token.group(0)
        if word[0] == '"':
            continue
        head = text[begin:token.start()]
        if word == "{":
            scope = _SCOPE.search(head)
            kind = "class" if scope and "enum" not in head else "brace"
            yield kind, head, token.start(), list(stack)
            access = "hidden" if scope and re.search(r"\bclass\b", scope.group(0)) else "public"
            stack.append([scope.group(1), access] if kind == "class" else None)
        elif word == "}":
            yield "end", head, token.start(), list(stack)
            if stack:
                stack.pop()
        elif word == ";":
            yield "semicolon", head, token.start(), list(stack)
        elif stack and stack[-1]:
            stack[-1][1] = "public" if word.startswith("public") else "hidden"
        begin = token.end()


def _name_of(head):
    """(class or None, name) of the function whose declaration ends with this text, or None."""
    match = _FUNCTION.search(head[:head.find("(") + 1]) if "(" in head else None
    return match.groups() if match else None


def _scopes(text):
    """(owner, name, access, begin, end) of every function with a body."""
    open_functions = []
    for kind, head, position, stack in _walk(text):
        if kind == "brace" and not any(f is not None for f in open_functions):
            name = _name_of(head)
            inside = stack[-1] if stack else None
            owner, access = (inside if inside else (name[0] if name else None, "public"))
            function = (owner, name[1], access, position) if name else None
            open_functions.append(function)
        elif kind in ("brace", "class"):
            open_functions.append(None)
        elif kind == "end" and open_functions:
            function = open_functions.pop()
            if function:
                yield (*function, position)


def _hidden_declarations(text):
    for kind, head, _, stack in _walk(text):
        if kind == "semicolon" and stack and stack[-1] and stack[-1][1] == "hidden":
            name = _name_of(head)
            if name:
                yield stack[-1][0], name[1]
