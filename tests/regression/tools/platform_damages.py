"""Damages to the files of a run for a platform, and what asperity-platform has to say of each."""

import math

STATION, SCEC_STATION = "fltst_dp075", "faultst000dp075"


def read(folder, name):
    return (folder / name).read_text().split("\n")


def write(folder, name, lines):
    (folder / name).write_text("\n".join(lines))


def replace(name, old, new):
    """In the first line that has it; there must be one."""
    def damage(folder):
        lines = read(folder, name)
        place = next(i for i, line in enumerate(lines) if old in line)
        lines[place] = lines[place].replace(old, new)
        write(folder, name, lines)
    return damage


def is_row(line):
    return line.strip() != "" and not line.startswith("#") and not line[0].isalpha()


def rows(name, change):
    """change(number of the row from 0, its words) gives the new words, None for no row."""
    def damage(folder):
        number, result = 0, []
        for line in read(folder, name):
            words = line.split()
            if is_row(line):
                words = change(number, words)
                number += 1
                line = None if words is None else " ".join(words)
            if line is not None:
                result.append(line)
        write(folder, name, result)
    return damage


def word(row, column, text):
    """Replaces one word; columns count from 0."""
    return lambda number, words: [text if (number, i) == (row, column) else each
                                  for i, each in enumerate(words)]


def values(column, function, first=0):
    """Of a column in all rows from `first` on."""
    return lambda number, words: [
        f"{function(float(each)):.6E}" if i == column and number >= first else each
        for i, each in enumerate(words)]


def swap_fields(folder):
    replace(STATION, "slip slip_rate", "slip_rate slip")(folder)


def drop_shear_stress(folder):
    rows(STATION, lambda _, words: words[:3] + words[4:])(folder)
    replace(STATION, " shear_stress", "")(folder)


def add_column(folder):
    rows(STATION, lambda _, words: [*words, "1.0"])(folder)
    replace(STATION, "shear_stress state", "shear_stress state slip_deficit")(folder)


def without(name, beginning):
    def damage(folder):
        write(folder, name, [line for line in read(folder, name)
                             if not line.startswith(beginning)])
    return damage


def not_ascii(folder):
    (folder / STATION).write_bytes((folder / STATION).read_bytes().replace(
        b"author=", "author=Käthe ".encode("utf-8")))


def too_large(folder):
    with open(folder / STATION, "ab") as file:
        file.write(b"#" * 11 * 2**20)


SEAS = {
    "station missing": (lambda folder: (folder / STATION).unlink(), "fltst_dp075: is missing."),
    "file missing": (lambda folder: (folder / "slip.dat").unlink(), "slip.dat: is missing"),
    "wrong name": (lambda folder: (folder / STATION).rename(folder / "fltst_dp75"),
                   "fltst_dp75: no file of BP1-QD has this name."),
    "a file too many": (lambda folder: (folder / "notes.txt").write_text("x"),
                        "notes.txt: no file of BP1-QD has this name."),
    "a folder inside": (lambda folder: (folder / "old").mkdir(), "old: is no file"),
    "empty file": (lambda folder: (folder / STATION).write_text(""), "fltst_dp075: is empty."),
    "too large": (too_large, "fltst_dp075: has 11.0 MB, the platform takes 10 MB"),
    "not ASCII": (not_ascii, "fltst_dp075, line 3: has a character that is not ASCII."),
    "header key missing": (without(STATION, "# element_size"),
                           "fltst_dp075: the header has no line `# element_size=`."),
    "header key empty": (replace(STATION, "# date=2024/05/31", "# date="),
                         "fltst_dp075, line 4: nothing stands after `date=`."),
    "other problem": (replace(STATION, "problem=BP1-QD", "problem=BP2-QD"),
                      "fltst_dp075, line 2: is of the problem BP2-QD, not of BP1-QD."),
    "no names of fields": (without(STATION, "t slip"), "no line with the names of the fields, `t"),
    "column missing": (drop_shear_stress, "line 18: column 4 (shear_stress) is missing"),
    "column too many": (add_column, "line 18: column 6 (slip_deficit) is none of"),
    "order of columns": (swap_fields, "line 18: the order of the columns is not `t slip slip_rate"),
    "column not described": (without(STATION, "# Column #4"),
                             "the header has no line `# Column #4 =` for shear_stress."),
    "unit in the header": (replace(STATION, "(MPa)", "(Pa)"),
                           "line 15: column 4 (shear_stress) is in Pa, the platform takes MPa."),
    "no rows": (rows(STATION, lambda *_: None), "fltst_dp075: has no rows of numbers."),
    "row too short": (rows(STATION, lambda number, words: words[:-1] if number == 2 else words),
                      "fltst_dp075, line 21: has 4 numbers, not 5."),
    "nan": (rows(STATION, word(1, 3, "nan")),
            "line 20: column 4 (shear_stress): `nan` is not finite."),
    "nan as the first number": (rows(STATION, word(0, 0, "nan")),
                                "line 19: column 1 (t): `nan` is not finite."),
    "inf": (rows(STATION, word(1, 2, "-inf")),
            "line 20: column 3 (slip_rate): `-inf` is not finite."),
    "Fortran's D": (rows(STATION, word(0, 3, "2.5D+01")),
                    "line 19: column 4 (shear_stress): `2.5D+01` is no decimal"),
    "comma": (rows(STATION, word(0, 4, "8,5")),
              "line 19: column 5 (state): `8,5` is no decimal number"),
    "time decreases": (rows(STATION, word(3, 0, "0.0")), "line 22: column 1 (t): 0 s follows"),
    "values in Pa": (rows(STATION, values(3, lambda value: 1e6 * value)),
                     "column 4 (shear_stress): "),
    "sign of slip": (rows(STATION, values(1, lambda value: -value)),
                     "column 2 (slip): -"),
    "slip rate without log10": (rows(STATION, values(2, lambda value: 10**value)),
                                "column 3 (slip_rate): no value is below 0; write log10"),
    "state without log10": (rows(STATION, values(4, lambda value: 10**value)),
                            "column 5 (state): "),
    "log10 of the moment rate": (rows("global.dat", values(2, math.log10)),
                                 "global.dat, line "),
    "depths not in order": (rows("slip.dat", word(0, 4, "1E-9")), "column 5: places do not"),
}

SCEC = {
    "uneven rows": (rows(SCEC_STATION, lambda number, words: None if number == 7 else words),
                    "column 1 (t): 0.02 s after the row before; all rows must be 0.01 s apart"),
    "number of rows": (replace(SCEC_STATION, "num_time_steps=", "num_time_steps=1"),
                       "rows."),
    "sign of stress": (rows(SCEC_STATION, values(7, lambda value: -value)),
                       "column 8 (n-stress): -120"),
    "log10 of the slip rate": (rows(SCEC_STATION, values(2, math.log10)),
                               "column 3 (h-slip-rate): begins with -12"),
    "log10 of the stress": (rows(SCEC_STATION, values(3, math.log10)),
                            "column 4 (h-shear-stress): begins with 1.8"),
    "a place twice": (rows("cplot", lambda number, words: ["0", "7500", words[2]]),
                      "the place (0, 7500) stands twice"),
    "all of one place missing": (lambda folder: (folder / "faultst120dp120").unlink(),
                                 "faultst120dp120: is missing; by symmetry faultst-120dp120 or"),
    "contours missing": (lambda folder: (folder / "cplot").unlink(), "cplot: is missing"),
}
