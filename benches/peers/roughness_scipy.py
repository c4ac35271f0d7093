"""The steps of `riffel roughness` in NumPy and SciPy, on text and on arrays.

Tasks, one a line: "read FILE SAMPLES" or "process - SAMPLES". Answers with seconds and a sum of the result.
"""

import sys
import time

import numpy as np
from scipy import ndimage, signal

SPACING = 1e-3
RADIUS = 0.375
BANDS = [(0.010, 0.030), (0.030, 0.100), (0.100, 0.300), (0.300, 1.000)]


def made(samples):
    """A rough rail of heights in metres: sums of sinusoids, alike in every language."""
    x = np.arange(samples) * SPACING
    heights = np.zeros(samples)
    for index in range(12):
        wavelength = 0.02 * 1.37**index
        heights += 1e-5 * wavelength**0.5 * np.sin(2 * np.pi * x / wavelength + index)
    return heights


def despike(r):
    """Peaks that bend down more than 10 per metre, removed if higher than w squared over 3 m."""
    while True:
        step = np.diff(r)
        peaks = np.flatnonzero((step[:-1] > 0) & (step[1:] <= 0) & (np.diff(step) < -10 * SPACING**2)) + 1
        removed = False
        for peak in peaks:
            left, right = peak, peak
            while left > 0 and r[left] - r[left - 1] >= 5e-3 * SPACING:
                left -= 1
            while right + 1 < len(r) and r[right] - r[right + 1] >= 5e-3 * SPACING:
                right += 1
            if right == left:
                continue
            line = r[left] + (r[right] - r[left]) * (peak - left) / (right - left)
            if r[peak] - line > ((right - left) * SPACING) ** 2 / 3:
                r[left : right + 1] = np.linspace(r[left], r[right], right - left + 1)
                removed = True
        if not removed:
            return r


def rolled(r):
    """Grey dilation by the lower arc of the wheel, as far as the range of heights lets it matter."""
    reach = min(int(np.sqrt(2 * RADIUS * np.ptp(r)) / SPACING) + 1, int(RADIUS / SPACING))
    distance = np.arange(-reach, reach + 1) * SPACING
    circle = np.sqrt(RADIUS**2 - distance**2) - RADIUS
    return ndimage.grey_dilation(r, structure=circle)


def process(heights):
    r = despike(heights.copy())
    extremes = []
    window = {0.030: 1000, 0.100: 1000, 0.300: 3000, 1.000: 10000}
    for short, long in BANDS:
        sections = signal.butter(4, [1 / long, 1 / short], "bandpass", fs=1 / SPACING, output="sos")
        band = signal.sosfiltfilt(sections, r)
        width = window[long]
        sums = np.concatenate([[0.0], np.cumsum(band * band)])
        rms = np.sqrt(np.maximum(sums[width:] - sums[:-width], 0) / width)
        peaks = ndimage.maximum_filter1d(band, width) - ndimage.minimum_filter1d(band, width)
        extremes += [rms.max(), peaks.max()]
    wheel = rolled(r)
    wavenumber, density = signal.welch(wheel, 1 / SPACING, "hann", 20000, detrend="linear")
    assert np.isfinite(extremes).all()
    return np.sqrt(density.sum() * wavenumber[1])


profiles = {}
for line in sys.stdin:
    task, file, samples = line.split()
    if task == "read":
        begun = time.perf_counter()
        table = np.loadtxt(file, delimiter=",", skiprows=1)
        print(time.perf_counter() - begun, table[:, 1].sum(), flush=True)
    else:
        heights = profiles.get(samples)
        if heights is None:
            heights = profiles[samples] = made(int(samples))
        begun = time.perf_counter()
        value = process(heights)
        print(time.perf_counter() - begun, value, flush=True)
