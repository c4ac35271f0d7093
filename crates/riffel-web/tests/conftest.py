"""The program and a browser for the tests of the page.

RIFFEL is the program, CHROMIUM the browser of the system; `cargo xtask test` sets both. Screenshots are kept
in SCREENSHOTS where it is set.
"""

import base64
import json
import os
import pathlib
import re
import shutil
import subprocess
import time
import urllib.request

import pytest
from playwright.sync_api import sync_playwright

ROOT = pathlib.Path(__file__).resolve().parents[3]
PROGRAM = os.environ.get("RIFFEL", str(ROOT / "target/debug/riffel"))
CHROMIUM = os.environ.get("CHROMIUM") or shutil.which("chromium")
SCREENSHOTS = os.environ.get("SCREENSHOTS")
SIZE = {"width": 1440, "height": 900}
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
        with urllib.request.urlopen(self.url) as answer:
            self.picture = self.url + re.search(r"assets/\w+/icon\.svg", answer.read().decode())[0]
        with urllib.request.urlopen(self.url + "api/vocabulary") as answer:
            nominal = json.load(answer)["nominal"]
        # What a page keeps of a visit before, on which the nominal case was open.
        self.visited = "#" + base64.urlsafe_b64encode(json.dumps({"case": nominal}).encode()).decode().rstrip("=")

    def end(self):
        self.process.terminate()
        self.process.wait(timeout=PATIENCE)


def small(name):
    """A case of the book with a map of few points."""
    text = (ROOT / f"cases/{name}.toml").read_text()
    for axis, points in [("wavelength", 61), ("speed", 31)]:
        text, count = re.subn(rf'^{axis} = {{ (min = "[^"]*", max = "[^"]*").*', rf"{axis} = {{ \1, points = {points} }}", text, flags=re.M)
        assert count == 1, name
    return text


@pytest.fixture(scope="session")
def served(tmp_path_factory):
    served = Served(tmp_path_factory.mktemp("served"))
    yield served
    served.end()


@pytest.fixture(scope="session")
def browser():
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield browser
        browser.close()


class Page:
    """A page with what every test asks of it. Complaints of the browser fail the test, but for those that it expects.

    Without curves their places know what they would show, and nothing is drawn, which takes most of the time of a page. Without remedies the program
    ranks none, which of a case with a wheelset takes most of its time.
    """

    def __init__(self, browser, url, curves=True, remedies=True, visited=None, picture=None, **context):
        settings = {"viewport": SIZE, "locale": "en-GB", "accept_downloads": True, "reduced_motion": "reduce", **context}
        self.context = browser.new_context(**settings)
        self.context.set_default_timeout(1000 * PATIENCE)
        if not curves:
            script = {"content_type": "text/javascript", "body": "window.Plotly = { react: async (place, data, layout) => Object.assign(place, { data, layout }) };"}
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
        self.handlers = []
        self.home, self.picture = url, picture
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

    def forget(self):
        """Leave the page for a picture of its origin, which runs no script that could write once more, and keep nothing of it."""
        self.page.goto(self.picture)
        self.page.evaluate("() => { localStorage.clear(); sessionStorage.clear(); }")

    def again(self):
        """Open it anew, as somebody who was never here but to see the nominal case: of the test before nothing is left."""
        for event, handler in self.handlers:
            self.page.remove_listener(event, handler)
        self.page.unroute_all(behavior="ignoreErrors")
        for other in self.context.pages:
            if other is not self.page:
                other.close()
        self.forget()
        self.page.set_viewport_size(SIZE)
        self.page.emulate_media(media="screen", color_scheme="light", reduced_motion="reduce")
        for own in (self.complaints, self.foreign, self.handlers):
            own.clear()
        self.open(self.home)

    def on(self, event, handler):
        """Be told of an event until the test ends."""
        self.handlers.append((event, handler))
        self.page.on(event, handler)

    def asked(self, path):
        """The questions at a path, as they come."""
        questions = []
        self.on("request", lambda request: request.url.endswith(path) and questions.append(request.post_data_json))
        return questions

    def answers(self, path):
        """The answers to a question, as they come."""
        given = []
        self.on("response", lambda response: response.url.endswith(path) and response.ok and given.append(json.loads(response.text())))
        return given

    def hold(self, path):
        """Keep answers back until the function that is returned is called."""
        kept = []
        self.page.route(path, lambda route: kept.append(route))

        def release():
            self.page.unroute(path)
            for route in kept:
                try:
                    route.continue_()
                except Exception:  # noqa: BLE001 - the page has given up the question.
                    pass

        return release

    def saved(self, act):
        """The name and the bytes of the file that the page gives."""
        with self.page.expect_download() as download:
            act()
        return download.value.suggested_filename, pathlib.Path(download.value.path()).read_bytes()

    def take(self, kind):
        """What the menu of what can be taken away gives."""
        self.page.click("[popovertarget=take-away]")
        return self.saved(lambda: self.page.click(f"[data-take={kind}]"))

    def speak(self, language):
        self.page.select_option("#language", language)

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
            self.page.wait_for_timeout(80)

    def fits(self):
        """Wait until nothing is wider than the window: charts follow a new width a third of a second later."""
        self.until(lambda: self.page.evaluate("() => document.documentElement.scrollWidth") <= self.page.viewport_size["width"])

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
        if SCREENSHOTS:
            self.page.screenshot(path=pathlib.Path(SCREENSHOTS) / f"{name}.png", full_page=whole)

    def refused(self, status):
        """The browser complains of each answer that is none: those of a status are what the test is about."""
        self.complaints = [complaint for complaint in self.complaints if f"status of {status}" not in complaint]

    def check_complaints(self):
        assert self.foreign == [], "the page asked elsewhere"
        assert self.complaints == []

    def close(self):
        self.context.close()
        self.check_complaints()


@pytest.fixture(scope="module")
def shared(browser, served, request):
    """One page for the tests of a module."""
    page = Page(browser, served.url, visited=served.visited, picture=served.picture, **parts(request))
    yield page
    page.context.close()


@pytest.fixture
def page(shared):
    shared.again()
    yield shared
    shared.check_complaints()


@pytest.fixture
def open_page(browser, served, request):
    """Pages with other settings; of somebody who was here before, if not told otherwise."""
    settings = {"visited": served.visited, **parts(request)}
    opened = []

    def open_(path="", **context):
        opened.append(Page(browser, served.url + path, **{**settings, **context}))
        return opened[-1]

    yield open_
    for page in opened:
        page.close()


def parts(request):
    """What the pages of a module have, but for what its markers leave out."""
    return {part: request.node.get_closest_marker(f"without_{part}") is None for part in ("curves", "remedies")}
