"""Pictures and table of the chapter "Held against the field", from the JSON of `riffel validate --field --json`.

    python docs/src/field.py validation/field/prediction.json
"""

import json
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
LEFT, RIGHT, ROW, TOP = 250, 40, 26, 40


def picture(name, title, rows, low, high, ticks):
    """Rows of (label, prediction, measured as two ends or none) on a logarithmic axis."""
    width = 760
    height = TOP + ROW * len(rows) + 46

    def x(value):
        share = math.log(min(max(value, low), high) / low) / math.log(high / low)
        return LEFT + share * (width - LEFT - RIGHT)

    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        f'<rect width="{width}" height="{height}" fill="#fff"/>',
        f'<text x="{width / 2}" y="20" text-anchor="middle" font-size="14">{title}</text>',
    ]
    bottom = TOP + ROW * len(rows)
    for tick in ticks:
        parts.append(f'<line x1="{x(tick):.1f}" x2="{x(tick):.1f}" y1="{TOP}" y2="{bottom}" stroke="#ddd"/>')
        parts.append(f'<text x="{x(tick):.1f}" y="{bottom + 16}" text-anchor="middle">{tick:g}</text>')
    for place, (label, predicted, measured) in enumerate(rows):
        y = TOP + ROW * (place + 0.5)
        parts.append(f'<text x="{LEFT - 8}" y="{y + 4:.1f}" text-anchor="end">{label}</text>')
        if measured:
            a, b = (x(end) for end in measured)
            parts.append(f'<rect x="{a:.1f}" y="{y - 9:.1f}" width="{max(b - a, 2):.1f}" height="18" fill="#f4b183"/>')
        if predicted and predicted["band_80"][1] > 0:
            for band, thick in (("band_80", 2), ("band_50", 6)):
                a, b = (x(max(end, low)) for end in predicted[band])
                parts.append(f'<line x1="{a:.1f}" x2="{b:.1f}" y1="{y:.1f}" y2="{y:.1f}" stroke="#1f4e79" stroke-width="{thick}"/>')
            parts.append(f'<circle cx="{x(max(predicted["median"], low)):.1f}" cy="{y:.1f}" r="4" fill="#1f4e79"/>')
    parts.append(f'<text x="{LEFT}" y="{bottom + 36}">blue: median, bands of 50 and 80 %; orange: measured</text>')
    parts.append("</svg>")
    (HERE / "images" / name).write_text("\n".join(parts) + "\n")


def ends(measured):
    """Two positive ends of a measured value on an axis; none where one is open."""
    if isinstance(measured, list):
        return measured if None not in measured else None
    return [measured / 1.122, measured * 1.122]


def main():
    document = json.loads(pathlib.Path(sys.argv[1]).read_text())
    waves, growth = [], []
    for site in document["cases"]:
        name = site["name"]
        found = [o for o in site["outcomes"] if o["unit"] in ("mm", "Hz")]
        for outcome in found:
            waves.append((f"{name} [{outcome['unit']}]", outcome["predicted"], ends(outcome["measured"])))
        if not found:
            waves.append((f"{name} [Hz]", site["frequency_hz"], None))
        of_growth = [o for o in site["outcomes"] if o["unit"] == "dB per million axles"]
        measured = ends(of_growth[0]["measured"]) if of_growth else None
        growth.append((name, site["growth_db_per_million_axles"], measured))
        growth.append(("without wave geometry", site["without_wave_geometry"]["growth_db_per_million_axles"], None))
    picture("field-frequency.svg", "Wavelength or frequency, predicted and measured", waves, 10, 3000, [10, 30, 100, 300, 1000, 3000])
    picture("field-growth.svg", "Growth, dB per million axles, predicted and measured", growth, 0.01, 3000, [0.01, 0.1, 1, 10, 100, 1000])
    for site in document["cases"]:
        for outcome in site["outcomes"]:
            predicted = outcome["predicted"]
            text = "–"
            if predicted:
                low, high = predicted["band_80"]
                text = f"{predicted['median']:.3g} ({low:.3g} to {high:.3g})"
            measured = outcome["measured"]
            if isinstance(measured, list):
                low, high = measured
                measured = f"up to {high}" if low is None else f"{low} to {high}"
            verdict = "inside" if outcome["inside"] else "**outside**"
            print(f"| {site['name']} | {outcome['what']}, {outcome['unit']} | {text} | {measured} | {verdict} |")


if __name__ == "__main__":
    main()
