#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""A corpus of damaged photometric files, made from two sound ones: name, text, and what is to happen.

What is to happen is a part of the error message, or a set of warning codes for what is repaired. They are seeds for fuzzing
too (tests/fuzz/seeds.py).
"""

IES = """IESNA:LM-63-2002
[TEST] none
[LUMINAIRE] Downlight
TILT=NONE
1 1200 1 5 3 1 2 0.2 0.2 0
1 1 12
0 22.5 45 67.5 90
0 45 90
300 290 250 120 5
300 280 240 110 5
300 285 245 115 5
"""

LDT = "\n".join(map(str, [
    "Company", 1, 4, 8, 45, 3, 45, "report", "Downlight", "7", "file", "date", 100, 100, 50, 90, 90, 0, 0, 0, 0, 100, 70.2, 1, 0, 1, 1,
    "LED", 1000, 4000, 80, 12, *[0.5] * 10, *range(0, 360, 45), 0, 45, 90, 150, 180, 5, 150, 180, 5, 150, 180, 5])) + "\n"


def swap(text, old, new, count=1):
    assert old in text, old
    return text.replace(old, new, count)


def line(text, number, new):
    """The text with line `number` (from 1) replaced, or left out for None."""
    lines = text.split("\n")
    lines[number - 1:number] = [] if new is None else [new]
    return "\n".join(lines)


def ies_cases():
    yield "sound", IES, set()
    yield from ies_header_cases()
    yield from ies_angle_cases()
    yield from ies_spelling_cases()


def ies_header_cases():
    yield "empty", "", "line 1: file: nothing but blanks; expected a photometric file"
    yield "blank", " \n\t\r\n  ", "line 1: file: nothing but blanks"
    yield "only-header", "IESNA:LM-63-2002\n", "line 1: TILT: the file ends before it; expected a line TILT="
    yield "no-tilt", line(IES, 4, None), "TILT: the file ends before it"
    yield "tilt-without-value", line(IES, 4, "TILT="), "line 4: TILT: no value; expected NONE, INCLUDE or the name of a file"
    yield "tilt-file-missing", line(IES, 4, "TILT=C:\\lamps\\a.tlt"), "line 4: TILT: there is no file of that name"
    yield "tilt-climbs", line(IES, 4, "TILT=../../etc/passwd"), "line 4: TILT: there is no file of that name"
    yield "tilt-include-cut", line(IES, 4, "TILT=INCLUDE\n1"), "line 6: number of horizontal angles: found 0.2; expected a whole number"
    yield "tilt-geometry", line(IES, 4, "TILT=INCLUDE\n7\n1\n0\n1"), "line 5: lamp to luminaire geometry: found 7; expected a whole"
    yield "tilt-angles", line(IES, 4, "TILT=INCLUDE\n1\n2\n0 0\n1 1"), "line 7: tilt angle: found 0 after 0; expected angles in asc"
    yield "tilt-negative", line(IES, 4, "TILT=INCLUDE\n1\n2\n0 9\n1 -1"), "line 8: tilt factor: found -1; expected a factor"
    yield "tilt-with-spaces", line(IES, 4, "TILT = NONE "), set()
    yield "cut-in-header", IES[:IES.index("1 1 12")], "line 5: ballast factor: the file ends before it; expected a number"
    yield "cut-in-angles", IES[:IES.index("45 90\n300")], "line 8: horizontal angle 2 of 3: the file ends before it"
    yield "cut-in-candela", IES[:IES.rindex("115")], "line 11: candela 14 of 15: the file ends before it; expected a number"
    yield "cut-in-number", IES[:IES.rindex("15 5")], "candela 15 of 15: the file ends before it"
    yield "one-candela-more", IES + "77\n", {"ies-trailing"}
    yield "text-behind", IES + "END\n", {"ies-trailing"}
    yield "lamps-zero", swap(IES, "1 1200 1 5", "0 1200 1 5"), "line 5: number of lamps: found 0; expected a whole number from 1"
    yield "lamps-fraction", swap(IES, "1 1200 1 5", "1.5 1000 1 5"), "number of lamps: found 1.5; expected a whole number"
    yield "lumens-negative", swap(IES, "1 1200", "1 -1000"), "lumens per lamp: found -1000; expected 0 or more, or -1 for absolute"
    yield "lumens-zero", swap(IES, "1 1200", "1 0"), {"ies-lamp-lumens"}
    yield "lumens-few", swap(IES, "1 1200", "1 10"), {"ies-flux"}
    yield "lumens-absolute", swap(IES, "1 1200", "1 -1"), set()
    yield "multiplier-zero", swap(IES, "1200 1 5", "1200 0 5"), "candela multiplier: found 0; expected a factor above 0"
    yield "multiplier-negative", swap(IES, "1200 1 5", "1200 -1 5"), "candela multiplier: found -1; expected a factor above 0"
    yield "verticals-zero", swap(IES, "1 5 3 1 2", "1 0 3 1 2"), "number of vertical angles: found 0; expected a whole number from 2"
    yield "verticals-few", swap(IES, "1 5 3 1 2", "1 4 3 1 2"), "line 8: horizontal angle: found 45 after 0; expected angles in ascending"
    yield "verticals-many", swap(IES, "1 5 3 1 2", "1 6 3 1 2"), "line 8: vertical angle: found 0 after 90; expected angles"
    yield "verticals-huge", swap(IES, "1 5 3 1 2", "1 99999 3 1 2"), "99999 numbers announced, more than the file holds"
    yield "verticals-overflow", swap(IES, "1 5 3 1 2", "1 5000000000 3 1 2"), "number of vertical angles: found 5e+09; expected"
    yield "horizontals-many", swap(IES, "1 5 3 1 2", "1 5 4 1 2"), "line 11: candela 15 of 20: the file ends before it; expected a number"
    yield "horizontals-negative", swap(IES, "1 5 3 1 2", "1 5 -3 1 2"), "number of horizontal angles: found -3; expected a whole"
    yield "type-four", swap(IES, "3 1 2 0.2", "3 4 2 0.2"), "photometric type: found 4; expected a whole number from 1 to 3"
    yield "type-a", swap(IES, "3 1 2 0.2", "3 3 2 0.2"), set()
    yield "type-b", swap(IES, "3 1 2 0.2", "3 2 2 0.2"), set()
    yield "units-three", swap(IES, "3 1 2 0.2", "3 1 3 0.2"), "units type: found 3; expected a whole number from 1 to 2"
    yield "size-huge", swap(IES, "0.2 0.2 0", "2000 0.2 0"), "luminous size: found 2000 m; expected less than 1000 m"
    yield "ballast-zero", swap(IES, "1 1 12", "0 1 12"), "line 6: ballast factor: found 0; expected a factor above 0"
    yield "future-use", swap(IES, "1 1 12", "1 0.9 12"), {"ies-future-use"}


def ies_angle_cases():
    yield "angles-repeated", swap(IES, "0 22.5 45", "0 45 45"), "vertical angle: found 45 after 45; expected angles in ascending"
    yield "angles-unordered", swap(IES, "0 22.5 45", "0 45 22.5"), "vertical angle: found 22.5 after 45; expected angles in"
    yield "angles-descending", swap(IES, "0 22.5 45 67.5 90", "90 67.5 45 22.5 0"), {"ies-reversed", "ies-flux"}
    yield "angles-beyond", swap(IES, "67.5 90", "67.5 200"), "vertical angle: found 200; expected degrees from 0 to 180"
    yield "angles-short", swap(IES, "67.5 90", "67.5 80"), {"ies-range"}
    yield "planes-repeated", swap(IES, "0 45 90\n", "0 0 90\n"), "line 8: horizontal angle: found 0 after 0; expected angles"
    yield "planes-odd", swap(IES, "0 45 90\n", "0 45 70\n"), "line 8: horizontal angle: from 0 to 70; expected 0 alone, 0 to 90"
    yield "planes-without-last", swap(IES, "0 45 90\n", "0 120 240\n"), {"ies-range"}
    yield "planes-seam", swap(IES, "0 45 90\n", "0 120 360\n"), {"ies-seam"}
    yield "plane-single-odd", swap(swap(IES, "1 5 3 1 2", "1 5 1 1 2"), "0 45 90\n", "45\n"), {"ies-range", "ies-trailing"}
    yield "candela-negative", swap(IES, "250 120", "-250 120"), "candela: found -250 in plane 0 at angle 45; expected 0 or more"
    yield "candela-all-zero", IES[:IES.index("300 290")] + "0 0 0 0 0\n" * 3, "candela: every intensity is 0; expected a luminaire"
    yield "candela-text", swap(IES, "250 120", "25O 120"), 'line 9: candela 3 of 15: found "25O"; expected a number'
    yield "candela-nan", swap(IES, "250 120", "nan 120"), 'found "nan"; expected a number of ordinary size'
    yield "candela-infinite", swap(IES, "250 120", "1e999 120"), 'found "1e999"; expected a number of ordinary size'
    yield "candela-huge", swap(IES, "250 120", "1e300 120"), "candela: found 1e+300 in plane 0 at angle 45; expected 0 or more"
    yield "candela-hex", swap(IES, "250 120", "0x1F 120"), 'found "0x1F"; expected a number'


def ies_spelling_cases():
    yield "commas", IES.replace(" 45", ",45").replace(" 90", ", 90"), set()
    yield "comma-decimals", swap(IES, "22.5", "22,5"), {"ies-decimal-comma"}
    yield "crlf", IES.replace("\n", "\r\n"), set()
    yield "cr-only", IES.replace("\n", "\r"), set()
    yield "latin-1", swap(IES, "Downlight", "Röhre 60°").encode("latin-1"), set()
    yield "utf-8-mark", b"\xef\xbb\xbf" + IES.encode(), set()
    yield "utf-16", IES.encode("utf-16"), "line 1: file: UTF-16 text; expected ASCII, Latin-1 or UTF-8"
    yield "zeros", b"\0" * 1000, "line 1: type indicator: the file ends before it; expected a number"
    yield "ctrl-z", IES + "\x1agarbage", set()
    yield "version-unknown", swap(IES, "2002", "2030"), {"ies-version"}
    yield "version-blank-line", "\n" + swap(IES, "LM-63-2002", "LM-63-2019"), set()
    yield "tilt-small", swap(IES, "TILT=NONE", "tilt = none"), set()
    yield "opening-cylinder", swap(IES, "3 1 2 0.2 0.2 0", "3 1 2 0 1.2 -0.04"), {"ies-opening"}
    yield "long-word", swap(IES, "250 120", "9" * 100000 + " 120"), "expected a number of ordinary size"
    yield "binary-word", swap(IES, "250 120", "2\x015 120"), 'found "2?5"; expected a number'


def ldt_cases():
    yield "sound", LDT, set()
    yield "cut-in-head", LDT[:40], "line 10: file name: the file ends before it"
    yield "cut-in-lamps", "\n".join(LDT.split("\n")[:28]), "line 28: luminous flux of lamp set 1: the file ends before it"
    yield "cut-in-angles", "\n".join(LDT.split("\n")[:47]), "angle C 6 of 8: the file ends before it; expected a number"
    yield "cut-in-candela", "\n".join(LDT.split("\n")[:-2]), "candela of plane C90 3 of 3: the file ends before it"
    yield "one-more", LDT + "7\n", {"ldt-trailing"}
    yield "line-missing", line(LDT, 9, None), "line 24: conversion factor: found 0; expected a factor above 0"
    yield "height-blank", line(LDT, 15, ""), {"ldt-blank"}
    yield "flux-grouped", line(LDT, 29, "1 000"), {"ldt-digit-groups"}
    yield "type-text", line(LDT, 2, "x"), 'line 2: type indicator: found "x"; expected a number'
    yield "symmetry-five", line(LDT, 3, "5"), "line 3: symmetry: found 5; expected a whole number from 0 to 4"
    yield "symmetry-none", line(LDT, 3, "0"), "candela of plane C135 1 of 3: the file ends before it"
    yield "symmetry-axial", line(LDT, 3, "1"), {"ldt-trailing"}
    yield "planes-zero", line(LDT, 4, "0"), "line 4: number of C planes: found 0; expected a whole number from 1"
    yield "planes-many", line(LDT, 4, "9"), "angle C: found 0 after 315; expected angles in ascending order"
    yield "planes-huge", line(LDT, 4, "90000"), "90000 numbers announced, more than the file holds; expected right counts"
    yield "angles-one", line(LDT, 6, "1"), "line 6: number of angles G: found 1; expected a whole number from 2"
    yield "size-negative", line(LDT, 16, "-90"), "line 16: length of the luminous area: found -90; expected millimetres"
    yield "factor-zero", line(LDT, 24, "0"), "line 24: conversion factor: found 0; expected a factor above 0"
    yield "ratio-off", line(LDT, 23, "90"), {"ldt-light-output-ratio"}
    yield "sets-zero", line(LDT, 26, "0"), "line 26: number of lamp sets: found 0; expected a whole number from 1 to 20"
    yield "sets-many", line(LDT, 26, "2"), "lamp set 2"
    yield "lamps-negative", line(LDT, 27, "-1"), {"ldt-negative-lamps"}
    yield "flux-zero", line(LDT, 29, "0"), "line 29: luminous flux of lamp set 1: found 0, and intensities are per 1000 lm of it"
    yield "flux-negative", line(LDT, 29, "-5"), "line 29: luminous flux of lamp set 1: found -5; expected lumens of 0 or more"
    yield "angle-repeated", line(LDT, 44, "0"), "angle C: found 0 after 0; expected angles in ascending order, none twice"
    yield "angle-beyond", line(LDT, 53, "270"), "angle G: expected degrees from 0 to 180"
    yield "candela-negative", line(LDT, 55, "-180"), "candela: found -180 in plane 0 at angle 45; expected 0 or more"
    yield "candela-zero", LDT[:LDT.index("150\n180")] + "0\n" * 9, "candela: every intensity is 0; expected a luminaire that shines"
    yield "candela-bright", swap(line(LDT, 23, "0"), "150\n180\n5\n", "950\n980\n5\n", 3), {"ldt-flux"}
    yield "decimal-comma", LDT.replace("0.5", "0,5").replace("70.2", "70,2"), {"ldt-decimal-comma"}
    yield "crlf", LDT.replace("\n", "\r\n"), set()
    yield "latin-1", swap(LDT, "Downlight", "Röhre").encode("latin-1"), set()
    yield "plane-90-missing", line(LDT, 45, "89"), "the planes that symmetry 4 needs are not all listed; expected 0 to 90 among them"
    yield "not-photometry", "\n".join(["hello"] * 100), 'line 2: type indicator: found "hello"; expected a number'


def corpus():
    """Name with ending, bytes, expectation."""
    for ending, cases in (("ies", ies_cases()), ("ldt", ldt_cases())):
        for name, text, expected in cases:
            yield f"{name}.{ending}", text if isinstance(text, bytes) else text.encode(), expected
