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
