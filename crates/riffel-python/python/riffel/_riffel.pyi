"""The extension in Rust: numbers and arrays in SI, checked by the modules that call it."""

from collections.abc import Callable, Mapping, Sequence
from typing import Any, TypeAlias, TypeVar

import numpy as np
import numpy.typing as npt

_Meanwhile = TypeVar("_Meanwhile")
_Floats: TypeAlias = npt.NDArray[np.float64]
_Complexes: TypeAlias = npt.NDArray[np.complex128]
_Stretches: TypeAlias = Sequence[tuple[float, _Floats]]
_Levels: TypeAlias = tuple[_Floats, _Floats, _Floats]
_Spectra: TypeAlias = Sequence[tuple[_Floats, _Floats]]
_Dominant: TypeAlias = tuple[float, float, float, float, float, float | None, float | None]
_Traffic: TypeAlias = str | dict[str, Any] | tuple[float, float]
_Roughness: TypeAlias = (
    str
    | tuple[float, Sequence[tuple[str, _Stretches]]]
    | Sequence[tuple[Sequence[tuple[str, str]], tuple[_Floats, _Floats]]]
)
_Record: TypeAlias = tuple[str, str | None, _Roughness]
_Layout: TypeAlias = tuple[str | None, float | None, str | None, str | None]

VERSION: str
TILE: int

def program(arguments: Sequence[str], again: Sequence[str]) -> int: ...

class ConvergenceError(RuntimeError):
    """An iteration did not reach its tolerance."""

class ReceptanceError(ValueError):
    """A receptance given from Python raised, or did not return one finite complex number for each frequency."""

class Universal:
    def __init__(
        self,
        title: str,
        function_type: int,
        load_case: int,
        directions: tuple[int, int],
        vertical_axis: str,
        abscissa_kind: int,
        numerator: tuple[int, str],
        denominator: tuple[int, str],
        frequencies: _Floats,
        values: _Complexes,
    ) -> None: ...

class PortableCase:
    """What makes a case anew elsewhere; to be pickled."""

class Case:
    @staticmethod
    def read(path: str, overrides: dict[str, Any]) -> Case: ...
    @staticmethod
    def parse(text: str, name: str, overrides: dict[str, Any]) -> Case: ...
    @staticmethod
    def from_dict(keys: dict[str, Any]) -> Case: ...
    def with_overrides(self, overrides: dict[str, Any]) -> Case: ...
    def with_track(self, track: Any) -> Case: ...
    def with_wheel(self, wheel: Any) -> Case: ...
    @staticmethod
    def restore(portable: PortableCase, track: Any | None, wheel: Any | None) -> Case: ...
    def portable(self) -> PortableCase: ...
    def to_dict(self) -> dict[str, Any]: ...
    @property
    def title(self) -> str | None: ...
    @property
    def remarks(self) -> list[str]: ...
    def wavelengths(self) -> _Floats: ...
    def speeds(self) -> _Floats: ...
    def growth_on_irregular_supports(
        self, point: tuple[float, float], deviation: float, supports: int, seed: int
    ) -> tuple[list[float], list[float], list[float], list[float]]: ...
    def sensitivities(self, wavelength: float, speed: float) -> list[tuple[str, str, float, float, float, float]]: ...
    def points(self, wavelengths: _Floats, speeds: _Floats) -> list[tuple[str, str, str, npt.NDArray[Any]]]: ...
    def growth_map(
        self, wavelengths: _Floats, speeds: _Floats, values: _Complexes, meanwhile: Callable[[float], _Meanwhile]
    ) -> _Meanwhile: ...
    def bay_maps(self) -> tuple[list[_Complexes], float]: ...
    def ridge(
        self, wavelength: tuple[float, float, int], speeds: _Floats
    ) -> tuple[list[_Floats], npt.NDArray[np.bool_], float | None]: ...
    def ridge_branches(
        self, wavelength: tuple[float, float, int], speeds: _Floats
    ) -> list[tuple[dict[str, Any], list[_Floats], npt.NDArray[np.bool_]]]: ...
    def receptance(
        self, frequencies: _Floats | None, speed: float | None, direction: str
    ) -> tuple[_Floats, list[tuple[str, str, _Complexes]]]: ...
    def resonances(self) -> list[tuple[str, float, float]]: ...
    def decay_rate(self, direction: str) -> list[tuple[float, float, bool]]: ...
    def creep_curve(self, creepages: _Floats | None) -> tuple[_Floats, list[tuple[str, str, _Floats]]]: ...
    def frequency_response(
        self, ratios: _Floats | None
    ) -> tuple[_Floats, list[tuple[str, str, str, _Complexes, _Floats]], bool]: ...
    def contact(self) -> dict[str, Any]: ...

def curve(
    case: Case | dict[str, Any] | str, overrides: dict[str, Any], radii: Sequence[float] | None
) -> tuple[str | None, dict[str, Any]]: ...
def profile(
    file: str, scatter: float | None, orientation: str | None
) -> tuple[dict[str, Any], list[str]]: ...
def profile_wear(
    file: str,
    nominal: str,
    scatter: float | None,
    orientation: str | None,
    align: str | None,
    inclination: str,
    gauge_height: float,
) -> dict[str, Any]: ...
def contact_geometry(
    case: Case | dict[str, Any] | str, overrides: dict[str, Any], shifts: Sequence[float], yaw: float
) -> tuple[str | None, dict[str, Any]]: ...
def contact_under_load(
    case: object, overrides: dict[str, Any], load: float, shifts: list[float], yaw: float
) -> tuple[str | None, dict[str, Any], list[str]]: ...

def si(text: str, kind: str) -> float: ...
def axis(min: float, max: float, points: int) -> _Floats: ...
def presets() -> list[dict[str, Any]]: ...
def forecast(
    case: Case,
    measured: tuple[_Floats, _Floats] | None,
    ground: tuple[str | None, str | None],
    traffic: _Traffic,
    passages: _Floats | None,
    mgt: _Floats | None,
    months: _Floats | None,
    limit: str,
) -> dict[str, Any]: ...
def fit_wear(
    case: Case,
    earlier: tuple[str, _Roughness],
    later: tuple[str, _Roughness],
    passages: float | None,
    days: float | None,
    traffic: _Traffic,
) -> dict[str, Any]: ...
def compare(
    case: Case,
    variants: Sequence[str | dict[str, Any]],
    traffic: _Traffic,
    measured: tuple[_Floats, _Floats] | None,
    ground: tuple[str | None, str | None],
    hold: str | None,
    limit: str,
) -> tuple[_Floats, _Floats, list[dict[str, Any]]]: ...
def compare_models(case: Case, models: Sequence[str] | None, speed: float | None) -> dict[str, Any]: ...
def simulate(
    case: Case,
    surface: tuple[float, float] | tuple[float, float, _Floats],
    speed: float,
    step: float | None,
    contact_filter: bool,
    transient: bool,
) -> tuple[dict[str, _Floats], dict[str, Any]]: ...
def on_smooth_rail(
    case: Case, speed: float, step: float | None
) -> tuple[dict[str, _Floats], dict[str, Any], list[str]]: ...
def evolve(
    case: Case,
    surface: tuple[float, float] | tuple[float, float, _Floats],
    periodic: bool,
    traffic: _Traffic,
    passages: int,
    step: float | None,
    contact_filter: bool,
) -> tuple[dict[str, Any], list[int], _Floats, float, list[str]]: ...
def axlebox(
    case: Case,
    run: Sequence[str] | Sequence[tuple[str, _Floats]],
    rate: float | None,
    place: tuple[float | None, _Floats | None, _Floats | None],
    channels: Sequence[str],
    within: tuple[float, float, float, float],
    contact_filter: bool,
    limits: Sequence[str],
) -> dict[str, Any]: ...
def noise(
    case: Case,
    spectrum: tuple[_Floats, _Floats],
    speed: float,
    train: tuple[int, float | None, float, float],
    wheel_roughness: str | tuple[_Floats, _Floats] | None,
    decay_rate: str | None,
    transfer: tuple[str, str] | None,
    radiators: tuple[float, float],
    ground_to: str,
    traffic: _Traffic | None,
    ahead: tuple[float, float | None],
) -> dict[str, Any]: ...
def diagnose(
    case: Case,
    rail: _Record,
    earlier: Sequence[_Record],
    layout: _Layout,
    speeds: Sequence[tuple[float, float]] | str | dict[str, Any] | None,
    torsion: Sequence[float],
    bending: Sequence[float],
    choose: Sequence[str],
    by: str | None,
    from_vehicle: bool,
) -> dict[str, Any]: ...
def level(mean_squares: _Floats) -> _Floats: ...
def mean_square(levels: _Floats) -> _Floats: ...
def remove_spikes(heights: _Floats, spacing: float) -> tuple[_Floats, list[tuple[int, int]]]: ...
def roll_over(
    heights: _Floats, spacing: float, radius: float | None, pit_depth: float | None
) -> tuple[_Floats, list[tuple[int, int]]]: ...
def third_octaves(stretches: _Stretches, spacing: float, longest: float) -> _Levels: ...
def band_pass(heights: _Floats, spacing: float, from_: float, to: float) -> _Floats: ...
def moving_rms(values: _Floats, window: int) -> _Floats: ...
def moving_peak_to_peak(values: _Floats, window: int) -> _Floats: ...
def analyse(
    stretches: _Stretches,
    spacing: float,
    longest: float,
    window: float | None,
    block: float,
    limit: str | None,
    merge: float,
    grinding_length: float,
) -> dict[str, Any]: ...
def limits() -> list[tuple[str, str, str, str, _Levels | None, list[tuple[float, float, float]]]]: ...
def compare_with_limit(wavelengths: _Floats, levels: _Floats, limit: str) -> _Levels: ...
def energy_mean(spectra: _Spectra) -> _Levels: ...
def dominant_of_profile(stretches: _Stretches, spacing: float) -> list[_Dominant]: ...
def dominant_of_spectra(spectra: _Spectra) -> list[_Dominant]: ...
def read_date(text: str) -> str: ...
def read_roughness(
    path: str, layout: _Layout
) -> tuple[
    tuple[float, list[tuple[str, list[tuple[float, _Floats]]]]] | None,
    list[tuple[list[tuple[str, str]], _Levels]],
    list[str],
]: ...
def synthesise(recipe: Mapping[str, Any] | None) -> list[tuple[str, float, _Floats]]: ...

class Study:
    @staticmethod
    def read(path: str) -> Study: ...
    @staticmethod
    def parse(text: str, case: str) -> Study: ...
    @staticmethod
    def from_dict(keys: dict[str, Any], case: str) -> Study: ...
    @staticmethod
    def open(folder: str) -> Study: ...
    @property
    def title(self) -> str | None: ...
    @property
    def remarks(self) -> list[str]: ...
    @property
    def fingerprint(self) -> str: ...
    @property
    def samples(self) -> int: ...
    @property
    def samples_per_chunk(self) -> int: ...
    @property
    def chunks(self) -> int: ...
    @property
    def is_saltelli(self) -> bool: ...
    def parameters(self) -> list[tuple[str, str | None, str, bool]]: ...
    def design(self, start: int, stop: int) -> list[_Floats | list[str]]: ...
    def begin(self, folder: str) -> None: ...
    def pending(self, folder: str, shard: str) -> list[int]: ...
    def compute(self, folder: str, chunks: list[int]) -> None: ...
    def run(self, folder: str, shard: str, progress: Callable[[int, int], object] | None) -> None: ...
    def tornado(
        self, output: str, shares: list[float]
    ) -> tuple[list[tuple[float | str, float | str]], list[tuple[float, float]], float]: ...

def study_summary(folder: str) -> dict[str, Any]: ...
def merge_study(into: str, folders: list[str]) -> tuple[int, int, list[int]]: ...
def sobol_indices(
    values: _Floats, parameters: int, confidence: float, resamples: int, seed: int
) -> tuple[list[list[float]], list[list[float]], float, int]: ...
