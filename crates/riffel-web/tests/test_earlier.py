"""Earlier records of a rail and several vehicles on it: the same answers as from the program, and what is refused."""

import base64
import json
import math
import random
import re
import subprocess

import pytest
from conftest import PROGRAM, in_english
from test_german import english, panels
from test_noise import GROWING

BAND = "() => { const { from, to } = document.getElementById('map').view.band; return [from, to]; }"
DAILY = 4000
# Name, share, speeds, wheel load and tractive ratio.
VEHICLES = [("tram", 0.7, [40, 60], None, None), ("works car", 0.3, [20, 70], 55e3, 0.05)]
DATES = ["2025-05-01", "2026-05-01"]


def record(height, seed=1, metres=12):
    """Two rails with corrugation of 40 mm, so many µm high on the left one, on a rough floor."""
    random.seed(seed)
    rows, left, right = ["position_m,left_um,right_um"], 0.0, 0.0
    for k in range(1000 * metres):
        left, right = 0.995 * left + random.gauss(0, 0.4), 0.995 * right + random.gauss(0, 0.4)
        rows.append(f"{k / 1000:.3f},{height * math.sin(2 * math.pi * k / 40) + left:.3f},{right:.3f}")
    return "\n".join(rows) + "\n"


def files(**texts):
    return [{"name": f"{name}.csv", "mimeType": "text/csv", "buffer": text.encode()} for name, text in texts.items()]


def type_into(page, field, text):
    page.page.fill(field, text)
    page.page.press(field, "Tab")


def change(page, field, text):
    """The same as typing, for many values in one test."""
    page.page.locator(field).evaluate("(field, text) => { field.value = text; field.dispatchEvent(new Event('change', { bubbles: true })); }", text)


def add_vehicles(page, type_into=type_into):
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    type_into(page, "#traffic-daily", str(DAILY))
    for k, (name, _, speeds, load, traction) in enumerate(VEHICLES):
        page.page.click("#add-vehicle")
        type_into(page, f"#vehicle-{k}-name", name)
        # The first begins with the usual 80 to 140 km/h, the second with the speeds of the first.
        for end in ("from", "to"):
            type_into(page, f"#vehicle-{k}-{end}", f"{speeds[end == 'to']} km/h")
        if load:
            type_into(page, f"#vehicle-{k}-wheel", f"{load:g} N")
        if traction:
            type_into(page, f"#vehicle-{k}-tractive", f"{100 * traction:g} %")
    for k, (_, share, *_) in enumerate(VEHICLES):
        type_into(page, f"#vehicle-{k}-share", f"{100 * share:g}")


def traffic_file():
    text = f"[line]\npassages_per_day = {DAILY}\n"
    for name, share, (slow, fast), load, traction in VEHICLES:
        text += f'[[vehicle]]\nname = "{name}"\nshare = "{100 * share:g} %"\n'
        if load:
            text += f'wheel_load = "{load / 1e3:g} kN"\ntractive_ratio = {traction}\n'
        # Of speeds spread evenly: their standard deviation, or the middles of sixteenths where that would reach below standstill.
        mean, deviation = (slow + fast) / 2, (fast - slow) / math.sqrt(12)
        if 4 * deviation < mean:
            text += f'speed = {{ mean = "{mean} km/h", standard_deviation = "{deviation} km/h" }}\n'
        else:
            middles = [slow + (fast - slow) * (k + 0.5) / 16 for k in range(16)]
            text += "speeds = [" + ", ".join(f'{{ speed = "{speed} km/h", share = {1 / 16} }}' for speed in middles) + "]\n"
    return text


def test_two_dated_records_and_two_vehicles_are_answered_as_by_the_program(page, tmp_path):
    page.open_case(GROWING.read_text(), GROWING.name)
    page.page.click("#tab-measure")
    add_vehicles(page)
    assert not page.page.locator("#trouble").is_visible() and not page.page.locator("#traffic-from").is_visible()
    texts = {"before": record(8, seed=2), "now": record(14)}
    page.give("#record", files=files(now=texts["now"]))
    page.until(page.page.locator("#earlier").is_visible)
    # Nothing of dates before there is something to compare with.
    assert not page.page.locator("#record-date").is_visible()
    page.give("#earlier-file", files=files(before=texts["before"]))
    page.page.locator("#earlier-records input").wait_for()
    given = {}
    page.page.on("response", lambda response: response.url.endswith("/api/ask/measure") and response.ok and given.update(json.loads(response.text())))
    page.page.fill("#record-date", DATES[1])
    page.page.locator("#earlier-records input").fill(DATES[0])
    page.until(lambda: (given.get("forecast") or {}).get("wear_fit"))

    for name, text in texts.items():
        (tmp_path / f"{name}.csv").write_text(text)
    (tmp_path / "traffic.toml").write_text(traffic_file())

    def program(command, *more):
        words = [PROGRAM, command, GROWING, "--traffic", "traffic.toml", "--earlier", "before.csv", "--json", *more]
        return json.loads(subprocess.run(words, cwd=tmp_path, capture_output=True, check=True, text=True).stdout)

    diagnosis = program("diagnose", "--roughness", "now.csv", "--dates", ",".join(DATES))
    forecast = program("forecast", "--spectrum", "now.csv", "--months", "12", "--dates", ",".join(DATES))
    page.until(lambda: page.page.locator(".course").count() > 0)
    for own, there in [(in_english(page, given["diagnosis"]), diagnosis), (in_english(page, given["forecast"]), forecast)]:
        # Speeds come over the page in m/s, which costs a bit or two of the last digits.
        numbers(own, there)
    [first, *_] = diagnosis["dominant_wavelengths"]
    course = first["course"]
    assert course["records"] == DATES and course["levels_db"][1] - course["levels_db"][0] == pytest.approx(20 * math.log10(14 / 8), abs=0.3)
    shown = page.page.locator(".course").first.inner_text()
    assert f"{DATES[0]} {course['levels_db'][0]:.1f} dB, {DATES[1]} {course['levels_db'][1]:.1f} dB" in shown and "a year" in shown
    fit = forecast["wear_fit"]
    outlook = page.text("#view-measure")
    assert "1.5 million axle passages" in outlook and all(minus(sentence.split(": forecast with")[0]) in outlook for sentence in fit["sentences"])
    # Both rails of then beside both of now, by their dates.
    page.until(lambda: sum(DATES[0] in name for name in spectra(page)) == 2)
    levels = spectra(page)
    at = lambda name: levels[name][min(levels[name], key=lambda wavelength: abs(wavelength - 40))]
    assert at("rail left, Now") - at(f"rail left, {DATES[0]}") == pytest.approx(20 * math.log10(14 / 8), abs=0.3)
    page.settle()
    page.keep("earlier", whole=True)
    # The report has the dates, too, and no name of a file that the user does not know.
    with page.page.expect_download() as download:
        page.page.click("#report")
    download.value.save_as(tmp_path / "report.html")
    report = (tmp_path / "report.html").read_text()
    assert "before.csv" in report and "earlier-1" not in report and "works car" in report


def minus(sentence):
    """With the minus of the numbers of the page."""
    return re.sub(r"(?<=[\s(=])-(?=\d)", "−", sentence)


def spectra(page):
    data = page.page.evaluate("() => (document.getElementById('spectrum').data ?? []).map(({ name, x, y }) => [name, x, y])")
    return {name: dict(zip(x, y)) for name, x, y in data}


def numbers(own, there, where=""):
    """The same document, its numbers to nine digits."""
    if isinstance(there, dict):
        assert own.keys() == there.keys(), where
        for key, value in there.items():
            # What was asked is written in other words.
            if key not in ("inputs", "file"):
                numbers(own[key], value, f"{where}.{key}")
    elif isinstance(there, list):
        assert len(own) == len(there), where
        for k, value in enumerate(there):
            numbers(own[k], value, f"{where}[{k}]")
    elif isinstance(there, float) and isinstance(own, (int, float)):
        assert own == pytest.approx(there, rel=1e-9, abs=1e-12), where
    else:
        assert own == there, where


@pytest.mark.without_curves
def test_earlier_records_are_dated_left_out_removed_and_kept(open_page):
    page = open_page(locale="de-DE", viewport={"width": 360, "height": 780})
    questions = []
    page.page.on("request", lambda request: request.url.endswith("/api/ask/measure") and questions.append(request.post_data_json))
    rows = page.page.locator("#earlier-records > li")
    date = lambda k: rows.nth(k).locator("input")
    asked = lambda: [(one["name"], day) for one, day in zip(questions[-1].get("earlier", []), questions[-1].get("dates", [None] * 6))]
    page.page.click("#tab-measure")
    page.give("#record", files=files(messung=record(14, metres=3)))
    page.until(page.page.locator("#earlier").is_visible)
    good = record(8, metres=3)
    page.give("#earlier-file", files=files(last=good, older=good) + [{"name": "notes.txt", "mimeType": "text/plain", "buffer": b"no table\n"}])
    page.until(lambda: rows.count() == 3 and rows.nth(2).locator(".fault").last.is_visible())
    # What cannot be read says so under the name that the user knows, and the rest is asked for without it.
    assert "notes.txt" in rows.nth(2).inner_text() and "earlier-3" not in rows.nth(2).inner_text()
    page.until(lambda: questions and asked() == [("last.csv", None), ("older.csv", None)])
    rows.nth(2).locator("button").click()
    page.until(lambda: rows.count() == 2)
    # The order of the dates counts, not that of the files; one that is not before the record is told of and not taken.
    for field, day in [(page.page.locator("#record-date"), "2026-05-01"), (date(0), "2026-06-01")]:
        field.fill(day)
    page.until(rows.nth(0).locator(".fault").first.is_visible)
    fault = rows.nth(0).locator(".fault").first.inner_text()
    assert "vor dem 2026-05-01" in fault and english(fault) == []
    before = len(questions)
    date(1).fill("2024-05-01")
    assert date(0).get_attribute("aria-invalid") == "true" and len(questions) == before
    date(0).fill("2024-05-01")
    page.until(lambda: "older.csv" in rows.nth(1).inner_text() and rows.nth(1).locator(".fault").first.is_visible())
    date(0).fill("2025-05-01")
    page.until(lambda: asked() == [("older.csv", "2024-05-01"), ("last.csv", "2025-05-01")] and questions[-1]["dates"][-1] == "2026-05-01")
    page.until(lambda: page.page.locator(".course").count() > 0 and "im Jahr" in page.page.locator(".course").first.inner_text())
    page.until(lambda: page.page.locator("#noise-panel:not(.stale)").is_visible())
    assert "kein Verschleißbeiwert" in page.text("#view-measure")
    assert english(panels(page, "measure")) == []
    page.fits()
    page.keep("earlier-360", whole=True)
    # A reload finds files and dates; one that is removed is gone from the answer.
    page.page.reload()
    page.settle()
    page.until(lambda: page.page.locator(".course").count() > 0)
    assert [date(k).input_value() for k in range(2)] == ["2025-05-01", "2024-05-01"]
    rows.nth(1).locator("button").click()
    page.until(lambda: asked() == [("last.csv", "2025-05-01")])
    # Another record has no earlier ones until they are added.
    page.give("#record", files=files(another=good))
    page.until(lambda: "another.csv" in page.text("#record-state") and "earlier" not in questions[-1])
    assert rows.count() == 0 and "früheren" in page.text("#notice")
    page.close(complaints=len([text for text in page.complaints if "422" in text]))


@pytest.mark.without_curves
def test_undo_brings_back_a_record_with_its_earlier_ones(page):
    questions = []
    page.page.on("request", lambda request: request.url.endswith("/api/ask/measure") and questions.append(request.post_data_json))
    rows = page.page.locator("#earlier-records > li")
    asked = lambda: [(one["name"], day) for one, day in zip(questions[-1].get("earlier", []), questions[-1].get("dates", []))]
    dated = [("older.csv", "2024-05-01"), ("last.csv", "2025-05-01")]
    good = record(8, metres=3)
    page.page.click("#tab-measure")
    page.give("#record", files=files(now=record(14, metres=3)))
    page.until(page.page.locator("#earlier").is_visible)
    page.give("#earlier-file", files=files(older=good, last=good))
    page.until(lambda: rows.count() == 2 and page.page.locator(".course").count() > 0)
    page.page.locator("#record-date").fill("2026-05-01")
    for k, (_, day) in enumerate(dated):
        rows.nth(k).locator("input").fill(day)
    page.until(lambda: questions[-1].get("dates", [])[:-1] == [day for _, day in dated])
    page.give("#record", files=files(another=good))
    page.until(lambda: questions[-1]["roughness"]["name"] == "another.csv" and "earlier" not in questions[-1])
    page.page.locator("#notice button").first.click()
    page.until(lambda: questions[-1]["roughness"]["name"] == "now.csv" and len(questions[-1].get("earlier", [])) == 2)
    assert asked() == dated and questions[-1]["dates"][-1] == "2026-05-01"
    assert page.page.locator("#record-date").input_value() == "2026-05-01"
    assert [rows.nth(k).locator("input").input_value() for k in range(2)] == [day for _, day in dated]
    page.until(lambda: page.page.locator(".course").count() > 0 and "a year" in page.page.locator(".course").first.inner_text())


@pytest.mark.without_curves
@pytest.mark.parametrize("start", [b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR", b"RIFF\x24\0\0\0WAVEfmt ", b"PK\x03\x04\x14\0word/document.xml"])
def test_a_file_that_is_no_text_takes_no_place(page, start):
    rows = page.page.locator("#earlier-records > li")
    page.page.click("#tab-measure")
    page.give("#record", files=files(now=record(14, metres=3)))
    page.until(page.page.locator("#earlier").is_visible)
    page.give("#earlier-file", files=files(older=record(8, metres=3)))
    page.until(lambda: rows.count() == 1)
    page.give("#record", files=[{"name": "wrong.csv", "mimeType": "text/csv", "buffer": start + bytes(500)}])
    page.until(lambda: "wrong.csv" in page.text("#trouble") and "the file is" in page.text("#trouble"))
    page.until(lambda: page.text("#record-state").startswith("now.csv"))
    assert rows.count() == 1
    page.complaints.clear()


@pytest.mark.without_curves
def test_a_link_says_what_it_holds_and_that_it_holds_no_record(open_page):
    page = open_page(locale="de-DE", permissions=["clipboard-read", "clipboard-write"])
    copy = lambda: (page.page.click("[popovertarget=take-away]"), page.page.click("[data-take=link]"), page.page.keyboard.press("Escape"))
    copied = lambda: page.page.evaluate("() => navigator.clipboard.readText()")
    copy()
    page.until(lambda: copied() == page.page.url)
    page.until(page.page.locator("#notice").is_visible)
    told = page.text("#notice")
    assert page.page.locator("#notice #link").input_value() == page.page.url
    assert "Der Link enthält" in told and "keinen eigenen Verkehr" in told and "Messung" not in told
    page.page.click("#tab-measure")
    page.give("#record", files=files(messung=record(14, metres=3)))
    page.until(page.page.locator("#earlier").is_visible)
    copy()
    page.until(lambda: "Er enthält nicht: die Messung messung.csv" in page.text("#notice"))
    assert english(page.text("#notice")) == []
    page.page.select_option("#language", "en")
    copy()
    page.until(lambda: "does not hold the record messung.csv" in page.text("#notice"))
    page.close(complaints=len(page.complaints))


@pytest.mark.without_curves
def test_vehicles_make_a_traffic_or_say_why_not(page):
    growth = lambda: page.page.evaluate("() => window.riffel.state.at.state.growth_rate_per_passage")
    add_vehicles(page, change)
    # Two wheels of an axle: seven tenths of the passages with the 50 kN of the case, three with 55 kN.
    megatonnes = math.log(2) / growth() * 2 * (0.7 * 50e3 + 0.3 * 55e3) / 9.80665 / 1e9
    page.until(lambda: f"{megatonnes:.2g} MGT" in page.text("#why"))
    # The band on the map spans the speeds of all.
    page.until(lambda: page.page.evaluate(BAND) == pytest.approx([20 / 3.6, 70 / 3.6]))
    trouble = page.page.locator("#trouble [data-field]")
    for field, texts, words in [
        ("share", ["0", "-20", "120 %"], "must be"), ("share", ["40"], "sum to 110 %"), ("from", ["80"], "highest speed"), ("to", ["30 knots"], "no unit"),
        ("wheel", ["6 t", "3 GN"], "no unit"), ("wheel", ["5,000"], "two ways"), ("tractive", ["1.2"], "must be"), ("name", ["", "tram"], "vehicle"),
    ]:
        place = f"#vehicle-1-{field}"
        before = page.page.locator(place).input_value()
        for text in texts:
            change(page, place, text)
            page.until(lambda: trouble.count() == 1)
            told = page.page.locator("#vehicles .fault:visible, #vehicles-fault:visible").all_inner_texts()
            assert len(told) == 1 and words in told[0], (text, told)
        change(page, place, before)
        page.until(lambda: trouble.count() == 0)
    # Thousands, other units and a unit of one's own choice for speeds.
    type_into(page, "#vehicle-1-wheel", "10,000.5 lbf")
    page.until(lambda: page.text("#vehicle-1-wheel-echo") == "= 44.48 kN")
    assert page.page.locator("#vehicle-1-wheel").input_value() == "10,000.5 lbf"
    page.page.select_option("#speed-unit", "m/s")
    assert page.page.locator("#vehicle-0-to").input_value() == f"{60 / 3.6:.5g}"
    page.page.select_option("#speed-unit", "km/h")
    # Undo, a link, and what is left of the shares where one goes.
    page.page.click("#undo")
    page.until(lambda: page.page.locator("#vehicle-1-wheel").input_value() == "55")
    page.settle()
    link = page.page.url
    page.page.click("#vehicles [role=group]:first-child button")
    page.until(lambda: page.page.locator("#vehicles [role=group]").count() == 1)
    assert page.page.locator("#vehicle-0-name").input_value() == "works car" and page.page.locator("#vehicle-0-share").input_value() == "100"
    page.page.click("#vehicles [role=group] button")
    page.until(page.page.locator("#traffic-from").is_visible)
    page.page.goto(link)
    page.settle()
    assert [page.page.locator(f"#vehicle-{k}-name").input_value() for k in range(2)] == ["tram", "works car"]
    # A link of before has no vehicles, one whose shares make no traffic has none, either.
    for vehicles, daily in [(None, "4000"), ([{"name": "a", "share": 0.5, "from_km_per_h": 20, "to_km_per_h": 30}], "")]:
        traffic = {"from_km_per_h": 30, "to_km_per_h": 70, "passages_per_day": 4000, "months": 12, **({"vehicles": vehicles} if vehicles else {})}
        open_link(page, traffic)
        assert page.page.locator("#traffic-daily").input_value() == daily and page.page.locator("#traffic-from").count() == 1
        assert page.page.locator("#vehicles [role=group]").count() == 0


def open_link(page, traffic):
    case = page.page.evaluate("() => window.riffel.state.keys")
    text = json.dumps({"case": case, "point": None, "tab": "explore", "traffic": traffic}).encode()
    page.page.goto(page.page.url.split("#")[0] + "#" + base64.urlsafe_b64encode(text).decode().rstrip("="))
    page.settle()
