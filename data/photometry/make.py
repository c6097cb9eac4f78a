#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes photometric files of stated analytic distributions beside itself; their flux is known in closed form.

downlight.ies     I = I0 cos^2 gamma below, round 0.2 m: flux = 2 pi I0 / 3; I0 = 1000 cd
panel.ies         I = I0 (cos gamma) (1 + 0.3 sin^2 gamma cos 2C) below, 0.6 m square: flux = pi I0; I0 = 1100 cd
linear.ldt        I = I0 cos gamma (1 - 0.4 sin^2 gamma sin^2 C) below, 0.06 x 1.2 m: flux = 0.9 pi I0; I0 = 1100 cd
pendant.ldt       panel's light down with 700 cd, and I1 |cos gamma| up with I1 = 400 cd: flux = pi (I0 + I1)
"""
from pathlib import Path

import numpy as np

ANGLES = np.arange(0, 181, 2.5)
PLANES = np.arange(0, 360, 15)


def down(gamma):
    return np.where(gamma < 90, np.cos(np.radians(gamma)), 0)


def downlight(_plane, gamma):
    return 1000 * down(gamma) ** 2


def panel(plane, gamma, largest=1100):
    return largest * down(gamma) * (1 + 0.3 * np.sin(np.radians(gamma)) ** 2 * np.cos(2 * np.radians(plane)))


def linear(plane, gamma):
    return 1100 * down(gamma) * (1 - 0.4 * (np.sin(np.radians(gamma)) * np.sin(np.radians(plane))) ** 2)


def pendant(plane, gamma):
    return panel(plane, gamma, 700) + 400 * down(180 - gamma)


def write_ies(path, name, candela, planes, size):
    angles = ANGLES[ANGLES <= 90]
    rows = [" ".join(f"{v:.7g}" for v in candela(p, angles)) for p in planes]
    lines = ["IESNA:LM-63-2002", "[TEST] computed, not measured", "[MANUFAC] none", f"[LUMINAIRE] {name}", "TILT=NONE",
             f"1 -1 1 {len(angles)} {len(planes)} 1 2 {size}", "1 1 30", " ".join(f"{a:g}" for a in angles),
             " ".join(f"{p:g}" for p in planes), *rows]
    path.write_text("\n".join(lines) + "\n")


def write_ldt(path, name, candela, lamp_flux, size, output):
    kept = PLANES[PLANES <= 90]
    head = ["none", 1, 4, len(PLANES), 15, len(ANGLES), 2.5, "computed, not measured", name, "1", path.name, "", *size, 50, *size,
            0, 0, 0, 0, 100, f"{100 * output / lamp_flux:.1f}", 1, 0, 1, 1, "LED", lamp_flux, 4000, 80, 30, *[0.5] * 10, *PLANES, *ANGLES]
    body = [f"{v * 1000 / lamp_flux:.7g}" for p in kept for v in candela(p, ANGLES)]
    path.write_text("\n".join(map(str, [*head, *body])) + "\n")


def main(folder=Path(__file__).parent):
    quarter = PLANES[PLANES <= 90]
    write_ies(folder / "downlight.ies", "Downlight, cos2", downlight, (0,), "-0.2 0 0")
    write_ies(folder / "panel.ies", "Panel 600", panel, quarter, "0.6 0.6 0")
    write_ldt(folder / "linear.ldt", "Linear 1200", linear, 4000, (1200, 60), 0.9 * np.pi * 1100)
    write_ldt(folder / "pendant.ldt", "Pendant, direct and indirect", pendant, 4000, (1200, 200), np.pi * 1100)


if __name__ == "__main__":
    main()
