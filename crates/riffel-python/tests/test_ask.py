"""Questions by their names."""

from __future__ import annotations

import datetime
import inspect
import json
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import Any

import numpy as np
import pytest
from conftest import ROOT

import riffel

BAD = json.loads((ROOT / "crates/riffel-answers/tests/bad-questions.json").read_text())
TRAFFIC = "cases/traffic.toml"


@pytest.mark.parametrize("bad", BAD, ids=[bad["sentence"][:40] for bad in BAD])
def test_what_the_program_refuses_is_refused_by_the_same_sentence(bad: dict[str, Any]) -> None:
    with pytest.raises((ValueError, FileNotFoundError)) as caught:
        riffel.ask(bad["name"], bad["question"])
    assert bad["sentence"] in str(caught.value)
    assert isinstance(caught.value, FileNotFoundError) == ("cannot read" in bad["sentence"])


def test_the_answer_is_that_of_the_program(program: Callable[..., Any]) -> None:
    asked = ("compare", "cases/nominal.toml", "--remedies", "--json")
    assert riffel.ask("compare", {"case": "cases/nominal.toml", "remedies": True, "cost": None}) == program(*asked)


def test_cases_and_levels_stand_for_files(nominal: riffel.Case) -> None:
    keys = {"wavelength": np.float64(0.056), "speed": np.int64(30)}
    changed = riffel.ask("point", {"case": nominal, "set": ["contact.friction=0.3"], **keys})
    assert changed == riffel.ask("point", {"case": nominal.with_({"contact.friction": 0.3}), **keys})
    rails = [riffel.roughness.levels([0.04, 0.05, 0.063], [level] * 3) for level in (1.0, 2.0)]
    dates = [datetime.date(2025, 1, 31), np.datetime64("2026-01-31")]
    question = {"case": nominal, "spectrum": rails[1], "earlier": rails[:1], "dates": dates, "traffic": TRAFFIC}
    forecast = riffel.ask("forecast", question)
    assert [band["level_db"] for band in forecast["spectrum_now"]] == pytest.approx([2.0] * 3, rel=1e-12)
    assert forecast["bands"][0]["growth_is_measured"]


def test_a_report_names_a_case_in_memory(nominal: riffel.Case) -> None:
    assert "<td>case</td>" in riffel.ask("report", {"case": nominal})["page"]


def test_questions_of_several_threads_keep_their_documents_apart() -> None:
    def friction(value: float) -> Any:
        change = {"title": "friction", "contact": {"friction": value}}
        question = {"case": "cases/nominal.toml", "set": ["map.speed.points=5"], "with": [change], "speed": 30}
        return riffel.ask("compare", question)["outcomes"][1]["fastest_growth_rate_per_passage"]

    values = [0.2, 0.25, 0.3, 0.35] * 2
    with ThreadPoolExecutor(4) as threads:
        found = list(threads.map(friction, values))
    assert found == [friction(value) for value in values[:4]] * 2
    assert len(set(found)) == 4


@pytest.mark.parametrize(
    ("value", "error", "sentence"),
    [
        (float("inf"), ValueError, "set is inf, but must be finite"),
        ([object()], TypeError, r"`set\[0\]` is of type object"),
    ],
)
def test_what_no_question_holds(value: object, error: type[Exception], sentence: str) -> None:
    with pytest.raises(error, match=sentence):
        riffel.ask("map", {"case": "cases/nominal.toml", "set": value})


def test_what_is_unusual_is_a_warning(nominal: riffel.Case) -> None:
    with pytest.warns(UserWarning, match="speed is 200 m/s; usual values are"):
        riffel.ask("point", {"case": nominal, "wavelength": 0.06, "speed": 200.0})


# The questions whose keys are keywords of Python, too.
FACES: dict[str, Callable[..., Any]] = {
    "noise": riffel.Case.noise,
    "compare": riffel.Case.compare,
    "network worst": riffel.Network.worst,
    "network growth": riffel.Network.growth,
    "network plan": riffel.Network.plan,
    "network chart": riffel.Network.chart,
}
UNITS = {"m": 1.0, "mm": 1e-3, "m2": 1.0}


@pytest.mark.parametrize("name", FACES)
def test_defaults_are_those_of_the_question(program: Callable[..., Any], name: str) -> None:
    def si(value: Any) -> Any:
        number, _, unit = str(value).partition(" ")
        return float(number) * UNITS[unit] if unit in UNITS else value

    keys = program("schema", "--question", name)["properties"]
    keywords = inspect.signature(FACES[name]).parameters
    both = {key: default for key in keys if key in keywords and (default := keys[key].get("default")) is not None}
    assert {key: si(keywords[key].default) for key in both} == {key: si(default) for key, default in both.items()}
    assert both
