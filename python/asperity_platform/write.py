"""Writes the files of a platform into the folder of a run."""

import os
import time
from argparse import Namespace
from dataclasses import dataclass, field
from pathlib import Path
from typing import Iterable, List

from asperity.errors import InputError, NoStepYet
from asperity.journal import Journal
from asperity.run import READ_AS, Run

from . import model, platforms
from .content import Content
from .header import Facts
from .model import Model
from .problem import FileKind, Platform

TWO_SENSES = ("positive slip has not the same sense on all faults (see their lines in run.log), "
              "and these files take one: slip and shear stress of some have the wrong sign. Take "
              "them from fault.h5 and receivers.h5.")


@dataclass
class Written:
    """`lacking` says which files are not there, and why."""

    directory: Path
    platform: Platform
    files: List[str] = field(default_factory=list)
    lacking: List[str] = field(default_factory=list)
    warning: str = ""


def write(options: Namespace) -> Written:
    """`options` are those of the command line. InputError if no file can be written."""
    run = Run(options.directory)
    platform = _platform(options)
    of_run = model.of_run(run)
    content = Content(run, platform, of_run, _facts(options, run, of_run),
                      options.depth_of_upper_end, options.time_step)
    written = Written(options.directory / platform.folder, platform)
    for kind in platform.files(of_run):
        missing = _missing(run, kind)
        if missing:
            written.lacking.append(f"{kind.prefix}{'*' if kind.is_station else ''}: {missing}")
            continue
        for name, text in content.files(kind):
            _replace(written.directory / name, text)
            written.files.append(name)
    if not written.files:
        raise InputError(f"{options.directory} has nothing of which files for {platform.name} are "
                         f"made: {'; '.join(written.lacking)}.")
    _remove_others(written, platform.files(of_run))
    written.warning = "" if of_run.fault.get("one_sense", 1) else TWO_SENSES
    return written


def _platform(options: Namespace) -> Platform:
    if options.format:
        return platforms.named(options.format)
    found = platforms.of_problem(options.problem)
    if found is None:
        raise InputError(f"'{options.problem}' is no problem of a known platform. Name its "
                         "platform with --format.")
    return found


def _facts(options: Namespace, run: Run, of_run: Model) -> Facts:
    journal = Journal.read(run.directory)
    date = options.date or time.strftime("%Y/%m/%d", time.gmtime(journal.clock))
    version = options.code_version or journal.log.version
    size = options.element_size or of_run.fault["element_size"]
    for option, text in (("PROBLEM", options.problem), ("--author", options.author),
                         ("--date", date), ("--code-version", version)):
        if not text.isprintable():
            raise InputError(f"{option} {text!r} has a line end or another control character, and "
                             "stands in the files' headers. Write it in one line.")
    return Facts(options.problem, options.author, date, version, size)


def _missing(run: Run, kind: FileKind) -> str:
    """Why there are no files of this kind, or ''."""
    name = "receivers.h5" if kind.is_station else kind.source
    if not run.has(name):
        return run.reason_missing(name)
    try:
        if kind.is_station and not run.receivers.has(f"{kind.source}/names"):
            return f"there are no receivers {kind.source.replace('_', ' ')}"
        if not kind.is_station:
            getattr(run, READ_AS[kind.source])
    except NoStepYet as error:
        return str(error).rstrip(".")
    return ""


def _replace(path: Path, text: Iterable[str]) -> None:
    """A reader finds the old file or the whole new one."""
    unfinished = path.with_name(path.name + ".part")
    try:
        path.parent.mkdir(exist_ok=True)
        with open(unfinished, "w", encoding="utf-8", newline="\n") as file:
            file.writelines(text)
        os.replace(unfinished, path)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise InputError(f"{path} cannot be written ({error.strerror}).") from error


def _remove_others(written: Written, kinds: Iterable[FileKind]) -> None:
    """Files of these kinds that an earlier run has left."""
    for path in written.directory.iterdir():
        if path.name not in written.files and any(kind.matches(path.name) for kind in kinds):
            path.unlink()
