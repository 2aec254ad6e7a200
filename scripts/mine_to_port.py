#!/usr/bin/env python3
"""Writes config/tracks/mine_to_port.csv and port_to_mine.csv: a synthetic line of 66 km from a mine down to a port.

No real line. The rule, with every number chosen:
- Eleven blocks of 6 km with one grade each, in the order of GRADES: 294 m down from the mine to the port, with one
  climb after a descent of 24 km. Grades change evenly over 400 m around a block's end.
- Every block but the first and the last has two curves: a left one from its 1.5 km on and a right one from its 3.5 km
  on, each of 0.1 km transition, 0.6 km full curvature, 0.1 km transition. Their radius goes through RADII in turn.
- Cant is that of 2/3 of the limit's lateral acceleration, rounded to 5 mm.
- Limits: 80 km/h; 60 on descents of 9 permille and more; 60 in curves of 400 m and less, from the start of their
  transition to its end.
- port_to_mine.csv is the same line run from the other end: chainage 66 km - x, grades and radii with the other sign.
"""
import argparse
import pathlib

LENGTH_KM = 66.0
BLOCK_KM = 6.0
GRADES = [0.0, -4.0, -9.0, -12.0, -6.0, 0.0, 5.0, -10.0, -10.0, -3.0, 0.0]
RADII = [800, 600, 400, 300, 500]
EASE_KM = 0.2
RAIL_DISTANCE_MM = 1500.0
GRAVITY_MPS2 = 9.81


def grade(x):
    """Grade [permille] at chainage x [km]."""
    for i in range(1, len(GRADES)):
        from_end_km = x - i * BLOCK_KM
        if abs(from_end_km) <= EASE_KM:
            share = 0.5 + 0.5 * from_end_km / EASE_KM
            return GRADES[i - 1] + share * (GRADES[i] - GRADES[i - 1])
    return GRADES[min(int(x / BLOCK_KM), len(GRADES) - 1)]


def curves():
    """(start of the transition [km], radius [m], + left)"""
    found = []
    for block in range(1, len(GRADES) - 1):
        for start_km, sign in ((1.5, 1), (3.5, -1)):
            found.append((block * BLOCK_KM + start_km, sign * RADII[len(found) % len(RADII)]))
    return found


def limit(x):
    """Speed limit [km/h] that holds from x on."""
    steep = GRADES[min(int(x / BLOCK_KM), len(GRADES) - 1)] <= -9.0
    narrow = any(start <= x < round(start + 0.8, 6) and abs(radius) <= 400 for start, radius in curves())
    return 60 if steep or narrow else 80


def cant(x_km, radius_m):
    v_mps = limit(x_km) / 3.6
    return 5 * round(2 / 3 * v_mps**2 / (abs(radius_m) * GRAVITY_MPS2) * RAIL_DISTANCE_MM / 5)


def rows():
    """(chainage [km], grade [permille], radius [m], cant [mm], limit [km/h]), the limit holding from there on"""
    shape = {}
    for start, radius in curves():
        for along, full in ((0.0, False), (0.1, True), (0.7, True), (0.8, False)):
            shape[round(start + along, 6)] = (radius, cant(start, radius)) if full else (0, 0)
    places = set(shape) | {0.0, LENGTH_KM}
    for i in range(1, len(GRADES)):
        places |= {round(i * BLOCK_KM + ease, 6) for ease in (-EASE_KM, 0.0, EASE_KM)}
    return [(x, grade(x), *shape.get(x, (0, 0)), limit(x)) for x in sorted(places)]


def reversed_rows(forward):
    """The limit of a row holds until the next: seen from the other end it is that of the row before."""
    limits = [row[4] for row in forward]
    back = []
    for i in range(len(forward) - 1, -1, -1):
        x, g, radius, cant_mm, _ = forward[i]
        back.append((round(LENGTH_KM - x, 6), 0.0 - g, 0 - radius, cant_mm, limits[max(i - 1, 0)]))
    return back


def write(path, table, title):
    lines = [f"# {title} Written by scripts/mine_to_port.py; the rule stands there.",
             "chainage_km,grade_permille,radius_m,cant_mm,speed_limit_kmph"]
    lines += [f"{x:.2f},{g:g},{radius},{cant_mm},{v}" for x, g, radius, cant_mm, v in table]
    path.write_text("\n".join(lines) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, nargs="?", metavar="FOLDER", help="default: config/tracks",
                        default=pathlib.Path(__file__).parents[1] / "config/tracks")
    tracks = parser.parse_args().folder
    if not tracks.is_dir():
        parser.error(f"FOLDER {tracks}: is no folder")
    forward = rows()
    write(tracks / "mine_to_port.csv", forward, "Mine to port: a synthetic line.")
    write(tracks / "port_to_mine.csv", reversed_rows(forward), "Port to mine: mine_to_port.csv from the other end.")


if __name__ == "__main__":
    main()
