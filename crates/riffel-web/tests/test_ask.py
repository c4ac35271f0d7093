"""Questions of the page: what the program refuses, by the same sentence."""

import json
import tomllib

import pytest
from conftest import ROOT, in_english

BAD = json.loads((ROOT / "crates/riffel-answers/tests/bad-questions.json").read_text())
ASK = """async ([name, question]) => {
  const headers = { 'Content-Type': 'application/json', 'X-Riffel-Page': 'test' };
  const answer = await fetch(`/api/ask/${name}`, { method: 'POST', headers, body: JSON.stringify(question) });
  return { status: answer.status, ...(await answer.json()) };
}"""


def without_files(question):
    """The question with what stands in the files of the project in their place: a page names none."""
    def document(value):
        is_file = isinstance(value, str) and value.endswith(".toml") and (ROOT / value).is_file()
        return tomllib.loads((ROOT / value).read_text()) if is_file else value

    return {key: document(value) for key, value in question.items()}


@pytest.mark.without_curves
def test_what_the_program_refuses_is_refused_by_the_same_sentence(page):
    for bad in BAD:
        fault = in_english(page, page.page.evaluate(ASK, [bad["name"], without_files(bad["question"])]))
        assert fault["status"] == 422
        assert bad["sentence"] in "; ".join(filter(None, [fault["message"], fault.get("help")]))
    assert len(page.complaints) == len(BAD)
    page.complaints.clear()


@pytest.mark.without_curves
def test_a_wide_range_of_speeds_keeps_the_mean_and_scatter_of_even_ones(page):
    asked = []
    page.page.on("request", lambda request: request.url.endswith("/api/line") and asked.append(request.post_data_json["traffic"]))
    page.page.locator("#traffic-group").evaluate("(group) => (group.open = true)")
    for field, speed in [("#traffic-from", "36"), ("#traffic-to", "144")]:
        page.page.fill(field, speed)
        page.page.press(field, "Tab")
    page.until(lambda: asked and asked[-1] and "speeds" in asked[-1]["vehicle"][0])
    speeds = asked[-1]["vehicle"][0]["speeds"]
    mean = sum(one["share"] * one["speed"] for one in speeds)
    deviation = sum(one["share"] * (one["speed"] - mean) ** 2 for one in speeds) ** 0.5
    assert mean == pytest.approx(25, rel=1e-12)
    # n middles of equal parts have √(1 − 1/n²) of the scatter, 0.998 for 16.
    assert deviation == pytest.approx(30 / 12**0.5, rel=3e-3)
