"""The program and a browser for the tests of the page.

RIFFEL is the program, CHROMIUM the browser of the system; `cargo xtask test` sets both. Screenshots are kept
in SCREENSHOTS.
"""

import base64
import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import time
import urllib.request

import pytest
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("RIFFEL", str(ROOT / "target/debug/riffel"))
CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium")
SCREENSHOTS = pathlib.Path(os.environ.get("SCREENSHOTS", ROOT / "target/browser-tests/screenshots"))
# The longest wait for any state [s]: far more than a busy machine needs, so that only what never comes runs out of it.
PATIENCE = 300
# Nothing that Chromium does by itself reaches for a network.
ARGUMENTS = [
    "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
    "--disable-component-update", "--disable-sync",
]


class Served:
    """`riffel serve`, with its temporary files in a folder of the test."""

    def __init__(self, folder):
        self.folder = folder
        self.process = subprocess.Popen(
            [PROGRAM, "serve", "--port", "0"], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
            env={**os.environ, "TMPDIR": str(folder)},
        )
        self.url = self.process.stdout.readline().strip()
        assert re.fullmatch(r"http://127\.0\.0\.1:\d+/", self.url), self.url
        with urllib.request.urlopen(self.url + "api/vocabulary") as answer:
            nominal = json.load(answer)["nominal"]
        # What a page keeps of a visit before, on which the nominal case was open.
        self.visited = "#" + base64.urlsafe_b64encode(json.dumps({"case": nominal}).encode()).decode().rstrip("=")

    def end(self, signal_=signal.SIGTERM):
        self.process.send_signal(signal_)
        return self.process.wait(timeout=PATIENCE)


# Messages of an answer in English, as the page says them.
ENGLISH = """async (answer) => {
  const { pieces } = await import(document.querySelector('script[type=module]').src.replace('main.js', 'wording.js'));
  const is = (value) => 'capital' in value || ('id' in value && ('values' in value || 'english' in value));
  const said = (value) => pieces(value, 'en').map((piece) => piece.text ?? piece).join('');
  const told = (value) => Array.isArray(value) ? value.map(told)
    : Object(value) !== value ? value
    : is(value) ? said(value)
    : Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, told(inner)]));
  return told(answer);
}"""


def in_english(page, answer):
    """An answer to the page as `--json` has it."""
    return page.page.evaluate(ENGLISH, answer)


@pytest.fixture(scope="session")
def served(tmp_path_factory):
    served = Served(tmp_path_factory.mktemp("served"))
    yield served
    served.end()


@pytest.fixture(autouse=True)
def closed_afterwards(browser):
    """Close what a test has opened, whatever becomes of it: a page that stays open goes on painting beside the others."""
    before = browser.contexts
    yield
    for context in browser.contexts:
        if context not in before:
            context.close()


@pytest.fixture(scope="session")
def browser():
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


class Page:
    """A page with what every test asks of it. Complaints of the browser fail the test.

    Without curves nothing is drawn in place of them, which takes most of the time of a page. Without remedies the program
    ranks none, which of a case with a wheelset takes most of its time.
    """

    def __init__(self, browser, url, curves=True, remedies=True, visited=None, **context):
        self.context = browser.new_context(
            **{"viewport": {"width": 1440, "height": 900}, "locale": "en-GB", "accept_downloads": True, "reduced_motion": "reduce", **context}
        )
        self.context.set_default_timeout(1000 * PATIENCE)
        if not curves:
            script = {"content_type": "text/javascript", "body": "window.Plotly = { react: async () => {} };"}
            self.context.route("**/plotly.min.js", lambda route: route.fulfill(**script))
        if not remedies:
            nothing = {"remedies": [], "left_out": [], "notes": []}
            self.context.route("**/api/remedies", lambda route: route.fulfill(json=nothing))
        if visited:
            kept = {"riffel-last": visited, "riffel-all-keys": "true"}
            self.context.add_init_script(f"for (const [name, value] of Object.entries({json.dumps(kept)})) localStorage.getItem(name) ?? localStorage.setItem(name, value)")
        self.page = self.context.new_page()
        self.complaints = []
        self.foreign = []
        self.page.on("console", lambda message: message.type == "error" and self.complaints.append(message.text))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("request", lambda request: self.check(request.url, "/".join(url.split("/")[:3])))
        self.open(url)

    def check(self, asked, own):
        if not asked.startswith((own, "data:", "blob:")):
            self.foreign.append(asked)

    def open(self, url):
        self.page.goto(url)
        self.settle()

    def settle(self):
        """Wait until nothing is asked, drawn or written any more."""
        quiet = 0

        def at_rest():
            nonlocal quiet
            idle = self.page.evaluate("() => Boolean(window.riffel?.state.at && window.riffel.idle())")
            quiet = quiet + 1 if idle else 0
            return quiet >= 3

        self.until(at_rest)

    def until(self, condition):
        """Wait for a state. The policy of the page forbids conditions that the browser evaluates by itself."""
        end = time.monotonic() + PATIENCE
        while not condition():
            assert time.monotonic() < end, "waited in vain"
            self.page.wait_for_timeout(50)

    def fits(self):
        """Wait until nothing is wider than the window: charts follow a new width a third of a second later."""
        self.until(lambda: self.page.evaluate("() => document.documentElement.scrollWidth") <= self.page.viewport_size["width"])

    def pause(self):
        """A moment for what must not happen; what must happen is waited for by its state."""
        self.page.wait_for_timeout(300)

    def map(self):
        """The colours of the map, as one number that changes with any of them."""
        return self.page.evaluate(
            """() => {
              const canvas = document.querySelector('#map canvas');
              const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
              let sum = 0;
              for (let k = 0; k < data.length; k += 4) sum = (sum * 31 + data[k] + 3 * data[k + 1] + 7 * data[k + 2]) >>> 0;
              return sum;
            }"""
        )

    def text(self, selector):
        return self.page.locator(selector).inner_text()

    def set(self, key, value):
        field = self.page.locator(f"#key-{key.replace('.', '-')}")
        field.evaluate("(field) => (field.closest('details').open = true)")
        if field.evaluate("(field) => field.tagName") == "SELECT":
            field.select_option(value)
        else:
            field.fill(value)
            field.press("Tab")

    def give(self, selector, files):
        """Choose files once their place is shown: what is given to a hidden one is lost, as an earlier record is while the record itself is on its way."""
        self.until(lambda: self.page.locator(selector).evaluate("(input) => !input.disabled && !input.closest('[hidden]')"))
        self.page.set_input_files(selector, files)

    def open_case(self, text, name="case.toml"):
        """Open a case file and wait until it is the case of the page: what is typed before would be lost to it."""
        self.page.set_input_files("#open-toml", files=[{"name": name, "mimeType": "text/plain", "buffer": text.encode()}])
        self.settle()

    def keep(self, name, whole=False):
        SCREENSHOTS.mkdir(parents=True, exist_ok=True)
        self.page.screenshot(path=SCREENSHOTS / f"{name}.png", full_page=whole)

    def close(self, complaints=0):
        self.context.close()
        assert self.foreign == [], "the page asked elsewhere"
        assert len(self.complaints) == complaints, self.complaints


@pytest.fixture
def page(browser, served, request):
    page = Page(browser, served.url, visited=served.visited, **parts(request))
    yield page
    page.close()


@pytest.fixture
def open_page(browser, served, request):
    """Pages with other settings, which the test closes itself; of somebody who was here before, if not told otherwise."""
    settings = {"visited": served.visited, **parts(request)}
    return lambda path="", **context: Page(browser, served.url + path, **{**settings, **context})


def parts(request):
    """What a page has, but for what the markers of its test leave out."""
    return {part: request.node.get_closest_marker(f"without_{part}") is None for part in ("curves", "remedies")}
