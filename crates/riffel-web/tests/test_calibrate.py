"""Calibration on the page: the answers of the program, what it refuses, and what it does not conclude."""

import json
import pathlib
import subprocess

import pytest
from axe_playwright_python.sync_playwright import Axe

from conftest import PROGRAM, ROOT, in_english
from test_german import told_in_english
from test_work import hold

SETS = ROOT / "validation/calibration"


def opened(page):
    page.page.click("#tab-calibrate")
    page.settle()


def with_example(page):
    opened(page)
    page.page.click("#calibration-example")
    page.page.locator("#priors tbody tr").first.wait_for()
    page.settle()


def answers(page, path):
    """The answers to a question, as they come."""
    given = []
    page.page.on("response", lambda response: response.url.endswith(path) and response.ok and given.append(json.loads(response.text())))
    return given


def saved(page, button, count, folder):
    downloads = []
    page.page.on("download", lambda download: downloads.append(download))
    page.page.click(button)
    page.until(lambda: len(downloads) == count)
    for download in downloads:
        download.save_as(folder / download.suggested_filename)


def program(folder, *words):
    told = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True)
    assert told.returncode == 0, told.stderr
    return json.loads(told.stdout)


def same(own, answer):
    return {key: answer.get(key) for key in own} == own


def test_the_example_is_calibrated_and_decided_as_the_program_does_it(page, tmp_path):
    calibrations, decisions = answers(page, "/api/calibration"), answers(page, "/api/calibration/decision")
    with_example(page)
    assert page.page.locator("#priors .left-out").count() == 6
    page.page.click("#calibrate")
    page.page.locator("#marginals figure").first.wait_for()
    page.settle()
    calibration = in_english(page, calibrations[0])
    assert calibration["is_conclusive"], calibration["doubts"]
    saved(page, "#save-plan", 3, tmp_path)
    (tmp_path / "roughness.csv").write_bytes((SETS / "b-three-dates/roughness.csv").read_bytes())
    assert same(program(tmp_path, "calibrate", "plan.toml", "-o", "posterior", "--json"), calibration)
    # As the second implementation has it, of which some values that are left out here are uncertain: within half of its deviation.
    [pad] = [one for one in calibration["parameters"] if one["name"] == "track.pad.stiffness"]
    other = json.loads((SETS / "b-three-dates/posterior.json").read_text())["parameters"]["kp"]
    assert abs(pad["quantiles"][2] - other["q50"]) < 0.5 * other["sd"] and pad["is_told"]
    assert "Rail pad, stiffness k" in page.text("#calibration-conclusion")
    assert page.page.locator("#predicted .main-svg").count() > 0

    page.page.click("#rank")
    page.page.locator("#ranking tbody tr").first.wait_for()
    decision = in_english(page, decisions[0])
    ranked = page.page.locator("#ranking tbody th").all_inner_texts()
    titles = ["leave all as it is", *[action["title"] for action in decision["actions"][1:]]]
    order = sorted(range(len(titles)), key=lambda place: decision["actions"][place]["rank"])
    assert ranked == [titles[place] for place in order] and len(ranked) >= 4
    saved(page, "#save-decision", 1 + len(decision["files"]), tmp_path)
    assert same(program(tmp_path, "decide", "posterior", "--plan", "plan.toml", "--json"), decision)
    page.keep("calibrate", whole=True)

    # Among the remedies of the map stands how likely each helps, as the decision has it, and how likely it does the most.
    page.page.click("#tab-explore")
    page.until(lambda: len(decisions) == 2 and "by the calibration" in page.text("#remedies thead"))
    page.settle()
    likely = {action["title"]: action for action in in_english(page, decisions[1])["actions"]}
    longest = [action["months_to_limit"]["quantiles"][2] or float("inf") for action in decisions[1]["actions"]]
    best = max(likely, key=lambda title: likely[title]["probability_cheapest"])
    # Where only grinding costs, what is most often the cheapest has the longest interval in the median.
    assert longest[list(likely).index(best)] == max(longest) and best != "as it is"
    rows = page.page.locator("#remedies tbody tr").evaluate_all("(rows) => rows.map((row) => [row.querySelector('input').id.slice(8), ...[...row.cells].slice(5, 7).map(({ textContent }) => textContent)])")
    assert {row[0] for row in rows} == set(likely) - {"as it is"}
    for id_, *shares in rows:
        expected = [likely[id_][key] for key in ("probability_longer", "probability_cheapest")]
        # Two digits are shown.
        assert [float(share.rstrip(" %")) for share in shares] == [pytest.approx(100 * share, rel=0.05) for share in expected]
    # Of another case nothing is said of it.
    page.set("contact.friction", "0.3")
    page.settle()
    assert "by the calibration" not in page.text("#remedies thead")
    page.page.click("#undo")
    page.settle()
    page.page.click("#tab-calibrate")
    page.settle()

    # Only what may be written back is, and one step takes it back.
    before = page.page.evaluate("() => window.riffel.state.keys.track.pad.stiffness")
    page.page.click("#take-medians")
    page.settle()
    after = page.page.evaluate("() => window.riffel.state.keys.track.pad.stiffness")
    assert before == "300 MN/m" and abs(float(after.split()[0]) * 1e6 / pad["quantiles"][2] - 1) < 1e-3
    assert page.page.locator("#view-calibrate .panel.stale").count() > 0
    page.page.click("#undo")
    page.settle()
    assert page.page.evaluate("() => window.riffel.state.keys.track.pad.stiffness") == before
    page.until(lambda: page.page.locator("#view-calibrate .panel.stale").count() == 0)

    # Chains that disagree: the page says so, tells no interval, writes nothing back and ranks nothing.
    doubt = "the chains disagree on track.pad.stiffness: R̂ is 1.100, but must be 1.01 at most; take more draws, or look for a second way to fit the data"
    doubtful = {**calibration, "is_conclusive": False, "conclusion": "the chains allow no conclusion, by 1 doubts that are told with them: more draws may settle these", "doubts": [doubt]}
    doubtful["parameters"] = [{**one, "may_be_written_back": False} for one in doubtful["parameters"]]
    page.page.route("**/api/calibration", lambda route: route.fulfill(json=doubtful))
    page.page.click("#calibrate")
    page.until(lambda: "allow no conclusion" in page.text("#calibration-conclusion"))
    page.settle()
    assert "the chains disagree on Rail pad, stiffness k" in page.text("#calibration-words")
    assert page.page.locator("#marginals .after:not(path)").count() == 0
    assert page.page.locator("#take-medians").is_disabled() and not page.page.locator("#decision-asked").is_visible()


@pytest.mark.without_curves
def test_files_are_told_by_their_columns_and_what_cannot_be_told_is_refused_alone(page, tmp_path):
    opened(page)
    assert "Measurements tell" in page.text("#view-calibrate")
    page.open_case((SETS / "c-all-together/case.toml").read_text())
    wrong = tmp_path / "wrong.csv"
    wrong.write_text("a,b\n1,2\n")
    for name in ["hammer", "decay", "axlebox"]:
        page.give("#calibration-file", SETS / f"c-all-together/{name}.csv")
        page.settle()
    page.give("#calibration-file", wrong)
    page.page.locator("#calibration-files li:nth-child(4) .fault").wait_for()
    page.settle()
    rows = page.page.locator("#calibration-files li").all_inner_texts()
    assert "receptance of the rail" in rows[0] and "decay rates" in rows[1], rows
    assert "whose speed no column says" in rows[2] and "has the columns a, b, from which no kind of measurement follows" in rows[3], rows
    values = page.page.locator("#priors tbody tr").all_inner_texts()
    assert any("Rail pad, stiffness" in row and "hammer, decay" in row for row in values), values

    # A prior that excludes the case is refused in a sentence, and another is taken.
    median = page.page.locator("#priors input[type=text]").first
    median.fill("3 MN/m")
    median.press("Tab")
    page.until(lambda: "excludes" in page.text("#plan-fault"))
    assert page.page.locator("#calibrate").is_disabled()
    median = page.page.locator("#priors input[type=text]").first
    median.fill("280 MN/m")
    median.press("Tab")
    page.until(lambda: not page.page.locator("#plan-fault").is_visible())
    page.settle()

    # A reload finds the files and what was changed again, and what grinding costs.
    page.page.locator("#cost-grinding").evaluate("(field) => { field.value = '7000'; field.dispatchEvent(new Event('change', { bubbles: true })); }")
    page.page.reload()
    page.settle()
    assert page.page.locator("#cost-grinding").input_value() == "7000"
    page.until(lambda: "receptance of the rail" in page.text("#calibration-files"))
    page.settle()
    assert page.page.locator("#priors input[type=text]").first.input_value() == "280 MN/m"
    page.page.locator("#calibration-files button").first.click()
    page.settle()
    assert page.page.locator("#calibration-files li").count() == 3
    for _ in range(3):
        page.page.locator("#calibration-files button").first.click()
    page.settle()
    assert "Measurements tell" in page.text("#view-calibrate") and not page.page.locator("#priors").is_visible()
    page.complaints.clear()


@pytest.mark.without_curves
def test_a_file_that_is_removed_while_it_is_read_leaves_the_others(page):
    opened(page)
    page.give("#calibration-file", SETS / "c-all-together/axlebox.csv")
    page.settle()
    asked = []
    page.page.on("request", lambda request: request.url.endswith("/api/calibration/plan") and asked.append(request))
    release = hold(page, "**/api/calibration/plan")
    # Another case may take what this one refused: the file is read anew.
    page.set("contact.friction", "0.3")
    page.until(lambda: asked)
    with page.page.expect_response("**/api/upload/remove"):
        page.page.locator("#calibration-files button").click()
    page.give("#calibration-file", SETS / "c-all-together/hammer.csv")
    page.page.locator("#calibration-files li").wait_for()
    release()
    page.settle()
    assert "receptance of the rail" in page.text("#calibration-files")
    page.complaints.clear()


def children(process):
    """Processes that a program has started and that still run."""
    listed = pathlib.Path(f"/proc/{process.pid}/task").glob("*/children")
    return [child for one in listed for child in one.read_text().split()]


@pytest.mark.without_curves
def test_chains_tell_how_far_they_are_and_stop_when_asked(page, served):
    with_example(page)
    page.page.select_option("#draws", "6000")
    page.settle()
    page.page.click("#calibrate")
    page.until(lambda: "of 26000 draws" in page.text("#calibration-state"))
    assert children(served.process)
    page.page.locator("#priors-panel button:visible", has_text="Cancel").click()
    page.until(lambda: not children(served.process))
    page.until(lambda: "nothing was concluded" in page.text("#calibration-state"))
    assert page.page.locator("#calibrate").is_enabled()


def test_ranking_waits_for_the_remedies_and_its_german_follows_the_rules_of_accessibility(open_page):
    page = open_page(locale="de-DE")
    with_example(page)
    release = hold(page, "**/api/remedies")
    page.page.click("#calibrate")
    page.page.locator("#marginals figure").first.wait_for()
    page.until(page.page.locator("#rank").is_visible)
    assert page.page.locator("#rank").is_disabled()
    release()
    # A click waits until the button can be pressed.
    page.page.click("#rank")
    page.page.locator("#ranking tbody tr").first.wait_for()
    page.settle()
    assert told_in_english(page) == []
    for scheme in ["light", "dark"]:
        page.page.emulate_media(color_scheme=scheme)
        page.page.set_viewport_size({"width": 1440, "height": 900})
        page.settle()
        results = Axe().run(page.page, context="#view-calibrate", options={"resultTypes": ["violations"]})
        found = [(one["id"], [node["html"][:160] for node in one["nodes"]][:3]) for one in results.response["violations"]]
        assert found == [], scheme
        page.keep(f"calibrate-{scheme}", whole=True)
        page.page.set_viewport_size({"width": 390, "height": 844})
        page.settle()
        page.fits()
        page.keep(f"calibrate-phone-{scheme}", whole=True)
    page.close(complaints=len(page.complaints))
