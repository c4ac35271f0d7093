"""Calibration on the page: what it is told, how it goes, and what is concluded and ranked."""

import json
import pathlib
import subprocess

import pytest
from axe_playwright_python.sync_playwright import Axe
from conftest import PROGRAM, ROOT
from test_explore import english

pytestmark = pytest.mark.without_curves

SETS = ROOT / "validation/calibration"


def opened(page):
    page.page.click("#tab-calibrate")
    page.settle()


def with_example(page):
    opened(page)
    page.page.click("#calibration-example")
    page.page.locator("#priors tbody tr").first.wait_for()
    page.settle()


def saved(page, button, count, folder):
    downloads = []
    page.on("download", lambda download: downloads.append(download))
    page.page.click(button)
    page.until(lambda: len(downloads) == count)
    for download in downloads:
        download.save_as(folder / download.suggested_filename)


def program(folder, *words):
    told = subprocess.run([PROGRAM, *words], cwd=folder, capture_output=True, text=True)
    assert told.returncode == 0, told.stderr
    return json.loads(told.stdout)


def children(process):
    """Processes that a program has started and that still run."""
    listed = pathlib.Path(f"/proc/{process.pid}/task").glob("*/children")
    return [child for one in listed for child in one.read_text().split()]


# Long: has a file of every kind read.
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

    page.page.select_option("#draws", "3000")
    page.settle()

    # A reload finds the files and what was changed again, and what grinding costs.
    grinding = lambda cost: page.page.locator("#cost-grinding").evaluate("(field, cost) => { field.value = cost; field.dispatchEvent(new Event('change', { bubbles: true })); }", cost)
    grinding("7000")
    page.page.reload()
    page.settle()
    assert page.page.locator("#cost-grinding").input_value() == "7000"
    page.until(lambda: "receptance of the rail" in page.text("#calibration-files"))
    page.settle()
    assert page.page.locator("#priors input[type=text]").first.input_value() == "280 MN/m"
    _, project = page.take("project")
    page.page.locator("#calibration-files button").first.click()
    page.page.select_option("#draws", "1500")
    grinding("10")
    page.settle()
    assert page.page.locator("#calibration-files li").count() == 3
    # An opened project has its plan in the place of the other.
    page.open_case(project.decode(), name="all.riffel")
    page.page.click("#tab-calibrate")
    page.settle()
    assert page.page.locator("#calibration-files li").all_inner_texts() == rows
    assert page.page.locator("#priors input[type=text]").first.input_value() == "280 MN/m"
    assert [page.page.locator(place).input_value() for place in ("#draws", "#cost-grinding")] == ["3000", "7000"]
    assert not page.page.locator("#trouble").is_visible()
    for _ in range(4):
        page.page.locator("#calibration-files button").first.click()
    page.settle()
    assert "Measurements tell" in page.text("#view-calibrate") and not page.page.locator("#priors").is_visible()
    page.refused(422)
    # Files of the plan before are gone, whoever still asks about them.
    page.refused(410)


def test_a_file_that_is_removed_while_it_is_read_leaves_the_others(page):
    opened(page)
    page.give("#calibration-file", SETS / "c-all-together/axlebox.csv")
    page.settle()
    asked = page.asked("/api/calibration/plan")
    release = page.hold("**/api/calibration/plan")
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
    page.refused(422)
    page.refused(410)


def test_chains_are_run_stopped_concluded_and_ranked(page, served):
    """The answers are stand-ins where the program would take a minute: they say what it says of its own example."""
    with_example(page)
    assert page.page.locator("#priors .left-out").count() == 6
    page.page.select_option("#draws", "6000")
    page.settle()
    page.page.click("#calibrate")
    page.until(lambda: "of 26000 draws" in page.text("#calibration-state"))
    assert children(served.process)
    page.page.locator("#priors-panel button:visible", has_text="Cancel").click()
    page.until(lambda: not children(served.process))
    page.until(lambda: "nothing was concluded" in page.text("#calibration-state"))
    assert page.page.locator("#calibrate").is_enabled()


@pytest.mark.thorough
def test_the_example_is_calibrated_decided_and_ranked_as_the_program_does_it(page, tmp_path):
    """Chains take a minute, and more where the program is not optimised."""
    calibrations, decisions = page.answers("/api/calibration"), page.answers("/api/calibration/decision")
    with_example(page)
    page.page.click("#calibrate")
    page.page.locator("#marginals figure").first.wait_for()
    page.settle()
    calibration = calibrations[0]
    assert calibration["is_conclusive"] and "Rail pad, stiffness k" in page.text("#calibration-conclusion")
    numbers = lambda answer: [(one["name"], one["quantiles"], one["is_told"]) for one in answer["parameters"]]
    saved(page, "#save-plan", 3, tmp_path)
    (tmp_path / "roughness.csv").write_bytes((SETS / "b-three-dates/roughness.csv").read_bytes())
    assert numbers(program(tmp_path, "calibrate", "plan.toml", "-o", "posterior", "--json")) == numbers(calibration)
    # As the second implementation has it, of which some values that are left out here are uncertain: within half of its deviation.
    [pad] = [one for one in calibration["parameters"] if one["name"] == "track.pad.stiffness"]
    other = json.loads((SETS / "b-three-dates/posterior.json").read_text())["parameters"]["kp"]
    assert abs(pad["quantiles"][2] - other["q50"]) < 0.5 * other["sd"] and pad["is_told"]
    page.page.click("#rank")
    page.page.locator("#ranking tbody tr").first.wait_for()
    page.settle()
    saved(page, "#save-decision", 1 + len(decisions[0]["files"]), tmp_path)
    ranks = lambda answer: [(action["rank"], action["probability_cheapest"]) for action in answer["actions"]]
    assert ranks(program(tmp_path, "decide", "posterior", "--plan", "plan.toml", "--json")) == ranks(decisions[0])
    actions = decisions[0]["actions"]
    titles = ["leave all as it is" if action is actions[0] else action["title"] for action in sorted(actions, key=lambda one: one["rank"])]
    assert page.page.locator("#ranking tbody th").all_inner_texts() == titles and len(titles) >= 4
    # Among the remedies of the map stands how likely each helps, as long as the case is that which was calibrated.
    page.page.click("#tab-explore")
    page.until(lambda: "by the calibration" in page.text("#remedies thead"))
    page.set("contact.friction", "0.3")
    page.settle()
    assert "by the calibration" not in page.text("#remedies thead")
    page.page.click("#undo")
    page.page.click("#tab-calibrate")
    page.settle()
    # Only what may be written back is, and one step takes it back.
    stiffness = "() => window.riffel.state.keys.track.pad.stiffness"
    before = page.page.evaluate(stiffness)
    page.page.click("#take-medians")
    page.settle()
    assert abs(float(page.page.evaluate(stiffness).split()[0]) * 1e6 / pad["quantiles"][2] - 1) < 1e-3
    # What was concluded is of the case before.
    stale = page.page.locator("#view-calibrate .panel.stale")
    assert stale.count() > 0
    page.page.click("#undo")
    page.settle()
    assert page.page.evaluate(stiffness) == before and stale.count() == 0
    for scheme in ["light", "dark"]:
        page.page.emulate_media(color_scheme=scheme)
        page.settle()
        assert Axe().run(page.page, context="#view-calibrate", options={"resultTypes": ["violations"]}).response["violations"] == [], scheme
        page.keep(f"calibrate-{scheme}", whole=True)
    page.page.set_viewport_size({"width": 360, "height": 780})
    page.speak("de")
    page.settle()
    page.fits()
    assert english(page.text("#view-calibrate")) == []


# Chains that disagree are hard to come by: what the program says of them.
DOUBTFUL = {
    "is_conclusive": False, "conclusion": "the chains allow no conclusion, by 1 doubts that are told with them: more draws may settle these",
    "doubts": ["the chains disagree on track.pad.stiffness: R̂ is 1.100, but must be 1.01 at most; take more draws, or look for a second way to fit the data"],
    "together": [], "untold": [], "far_from_others": [], "remarks": [], "sampler": {}, "data": [],
    "parameters": [{
        "name": "track.pad.stiffness", "key": "track.pad.stiffness", "unit": "N/m", "may_be_written_back": False, "is_told": False, "quantiles": [1e8, 2e8, 3e8, 4e8, 5e8], "prior_quantiles": [1e8, 2e8, 3e8, 4e8, 5e8],
        "contraction": 0.5, "rhat": 1.1, "ess_bulk": 90, "ess_tail": 80, "densities": {"x": [1, 2], "after": [0, 1], "x_before": [1, 2], "before": [0, 1], "from": 1, "to": 2},
    }],
}


def test_chains_that_disagree_conclude_nothing_and_ranking_waits_for_the_remedies(page):
    with_example(page)
    page.page.route("**/api/calibration", lambda route: route.fulfill(json=DOUBTFUL))
    page.page.click("#calibrate")
    page.until(lambda: "allow no conclusion" in page.text("#calibration-conclusion"))
    page.settle()
    assert "the chains disagree on Rail pad, stiffness k" in page.text("#calibration-words")
    assert page.page.locator("#marginals .after:not(path)").count() == 0
    assert page.page.locator("#take-medians").is_disabled() and not page.page.locator("#decision-asked").is_visible()
    # Where they agree, nothing is ranked before there are remedies with their costs.
    levels = {"measured": "level_rise_db", "at": [0.04], "of": None, "observed": [1.0], "quantiles": [[0.5, 1.0, 1.5]]}
    page.page.route("**/api/calibration", lambda route: route.fulfill(json={**DOUBTFUL, "is_conclusive": True, "data": [levels]}))
    release = page.hold("**/api/remedies")
    page.page.click("#calibrate")
    page.page.locator("#decision-asked").wait_for()
    assert page.page.locator("#rank").is_disabled() and page.page.locator("#actions input").count() == 0
    release()
    page.until(page.page.locator("#rank").is_enabled)
    assert page.page.locator("#actions input[id$=investment]").count() > 3
    page.page.set_viewport_size({"width": 360, "height": 780})
    page.fits()
