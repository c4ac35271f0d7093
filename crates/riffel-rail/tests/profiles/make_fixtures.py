"""Write 60E1 and S1002 in the text formats of devices and programs, a point every millimetre.

The rail from the arcs of EN 13674-1, the wheel from the sections of EN 13715; run here with Python 3.
"""

import math

# Radius and half width at the end of each arc from the crown; the last one ends at the flank of 1:20.
ARCS = [(300.0, 10.228), (80.0, 26.0265), (13.0, None)]
TREAD = [0.0, -0.03358537058, 0.001565681624, -2.810427944e-05, 5.844240864e-08, -1.562379023e-08, 5.309217349e-15,
         -5.957839843e-12, 2.646656573e-13]
THROAT = [-4320.221063, -1038.384026, -106.5501873, -6.051367875, -0.2054332446, -0.004169739389, -4.687195829e-05,
          -2.25275554e-07]


def rail():
    """Points (x, height) from the gauge side to the field side."""
    half = [(0.0, 0.0)]
    x, depth, angle = 0.0, 0.0, 0.0
    for radius, end in ARCS:
        centre = x - radius * math.sin(angle), depth + radius * math.cos(angle)
        to = math.atan(20.0) if end is None else math.asin((end - centre[0]) / radius)
        pieces = math.ceil(radius * (to - angle))
        for piece in range(1, pieces + 1):
            at = angle + (to - angle) * piece / pieces
            half.append((centre[0] + radius * math.sin(at), -(centre[1] - radius * math.cos(at))))
        x, depth, angle = half[-1][0], -half[-1][1], to
    half += [(x + (down - depth) / 20.0, -down) for down in range(16, 31)]
    return [(-x, height) for x, height in half[:0:-1]] + half


def depth_of_wheel(x):
    """How far the profile is below the datum circle, towards the flange."""
    if x < -62.764705882:
        return 9.519259302 + math.sqrt(20.5**2 - (x + 49.5) ** 2)
    if x < -49.662510381:
        return 16.0 + math.sqrt(12.0**2 - (x + 55.0) ** 2)
    if x < -39.764473993:
        return 8.834924130 + math.sqrt(20.0**2 - (x + 58.558326413) ** 2)
    if x < -38.426669071:
        return -93.576667419 - 2.747477419 * x
    if x < -35.0:
        return 16.446 - math.sqrt(13.0**2 - (x + 26.210665) ** 2)
    of = THROAT if x < -26.0 else TREAD
    return sum(one * x**power for power, one in enumerate(of)) if x < 32.15796 else 1.364323640 - 0.066666667 * x


def wheel():
    """Points (x, height) from the flange back to the field side, about a millimetre apart along the profile."""
    points, x = [(-70.0, 5.0), (-69.99, -4.0), (-69.9, -depth_of_wheel(-69.9))], -69.9
    while x < 60.0:
        slope = (depth_of_wheel(x + 1e-6) - depth_of_wheel(x - 1e-6)) / 2e-6 if x > -69.8 else 8.0
        x = min(x + 1.0 / math.hypot(1.0, slope), 60.0)
        points.append((x, -depth_of_wheel(x)))
    return points


def write(name, lines):
    with open(name, "w", encoding="ascii") as file:
        file.writelines(line + "\n" for line in lines)


RAIL, WHEEL = rail(), wheel()

# MiniProf: the rail with y downward, the wheel with its origin at the flange back and y towards the tip; masked points at an end.
write("rail.ban", ["ProgramName=MiniProf", f"XYPoints={len(RAIL)}", "Rail=", "Gauge=", "ColumnDef=X,Y", ""]
      + [f'{chr(34) if place < 2 else " "}{x:9.4f}\t{-y:9.4f}' for place, (x, y) in enumerate(RAIL)])
write("wheel.whl", ["ProgramName=MiniProf", f"XYPoints={len(WHEEL)}", "WheelID=17", "ColumnDef=X,Y,A", ""]
      + [f"{x + 70.0:9.4f}, {-y:9.4f}, 0.0" for x, y in WHEEL])
# Simpack: z downward; the wheel in metres, mirrored, from the field side, with weights.
write("rail.prr", ["header.begin", "  version = 1", "  type = 0", "header.end", "spline.begin", "  units.len.f = 1000.",
                   "  point.begin"]
      + [f"    {x:10.5f} {-y:10.5f}" for x, y in RAIL] + ["  point.end", "spline.end"])
write("wheel.prw", ["header.begin", "  version = 1", "  type = 1 ! a wheel", "header.end", "spline.begin", "  comment = 'S1002'",
                    "  mirror.y = 1", "  units.len.f = 1.", "  point.begin"]
      + [f"    {-1e-3 * x:12.8f} {-1e-3 * y:12.8f} 1.0" for x, y in WHEEL[::-1]] + ["  point.end", "spline.end"])
# Vampire: both sides, from the middle of the track; rails with z upward, wheels downward. The right rail is inclined by nothing.
write("rail.rai", ["RAILPROFILE", "60E1 on both sides", "GAUGEPOINT EUROPEAN", "GAUGE 1435.0"]
      + [f"{-x - 753.5:10.4f} {y:9.4f} {x + 753.5:10.4f} {y:9.4f}" for x, y in RAIL])
write("wheel.whe", ["WHEELPROFILE", "S1002 on both sides", "TREADDATUM EUROPEAN", "FLANGEBACK 1360.0"]
      + [f"{-x - 750.0:10.4f} {-y:9.4f} {x + 750.0:10.4f} {-y:9.4f}" for x, y in WHEEL])


def cut(points, gauge):
    """Points of a rail that a wheel has worn: at most 1.2 mm at the crown and some 3 mm at the gauge corner and face, none on the field side."""
    worn = []
    for x, y in points:
        share = min(1.0, max(0.0, (8.0 - x) / 40.0))
        if x < 8.0:
            x, y = x + gauge * share**2, y - 1.2 * math.sin(math.pi * min(1.0, (8.0 - x) / 40.0)) ** 2
        worn.append((x, y))
    return worn


def hollow(points):
    """Points of a wheel: a tread hollowed by 1.5 mm 40 mm wide, a flange thinner by up to 2 mm; the tip and the back as they were."""
    worn = []
    for x, y in points:
        tread = 1.5 * math.sin(math.pi * (x + 20.0) / 40.0) ** 2 if -20.0 < x < 20.0 else 0.0
        flank = 2.0 * math.sin(math.pi * (x + 50.0) / 30.0) ** 2 if -50.0 < x < -20.0 else 0.0
        worn.append((x - flank, y + tread))
    return worn


write("../../../../cases/worn-wheel.csv", ["# S1002, worn; made by make_fixtures.py", "x_mm,y_mm"] + [f"{x:.4f},{y:.4f}" for x, y in hollow(WHEEL)])
write("../../../../cases/worn-rail.csv", ["# 60E1, worn, 3 mm aside and 2 mm too high; made by make_fixtures.py", "x_mm,y_mm"]
      + [f"{x + 3.0:.4f},{y + 2.0:.4f}" for x, y in cut(RAIL, 3.0)])
