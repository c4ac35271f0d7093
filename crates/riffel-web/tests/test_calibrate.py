"""Calibration on the page: the answers of the program, what it refuses, and what it does not conclude."""

import json
import subprocess

import pytest

from conftest import PROGRAM, ROOT

SETS = ROOT / "validation/calibration"


def opened(page):
    page.page.click("#tab-calibrate")
    page.settle()


def with_example(page):
    opened(page)
    page.page.click("#calibration-example")
    page.page.locator("#priors tbody tr").first.wait_for()
    page.settle()


def test_the_example_is_calibrated_as_the_program_does_it(page, tmp_path):
    with_example(page)
    page.keep("calibrate-priors", whole=True)
    given = {}
    page.page.on("response", lambda response: response.url.endswith("/api/calibration") and response.ok and given.update(json.loads(response.text())))
    page.page.click("#calibrate")
    page.page.locator("#marginals figure").first.wait_for()
    page.settle()
    page.keep("calibrate", whole=True)
    print(given["conclusion"])
