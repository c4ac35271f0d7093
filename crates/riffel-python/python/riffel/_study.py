"""Studies: many cases of one kind, on one machine or on many."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import numpy as np
import xarray as xr

from riffel import _riffel
from riffel._ask import ask

if TYPE_CHECKING:
    from distributed import Client

Folder: TypeAlias = "str | os.PathLike[str]"
Progress: TypeAlias = "Callable[[int, int], object]"
"""Told the number of samples that are done and of those to do."""


class Study:
    """A plan on its case: what varies, by which design, and what is wanted of each sample.

    Make one with `from_toml`, `from_dict` or `open`. Samples do not depend on each other or on where they are computed:
    the same plan gives the same numbers bit for bit in one process, in shards and on a cluster.
    """

    __slots__ = ("_folder", "_study")

    def __init__(self, study: _riffel.Study) -> None:
        self._study = study
        # Where its results are, once it was opened or run.
        self._folder: Path | None = None

    @classmethod
    def from_toml(cls, path: str | os.PathLike[str]) -> Study:
        """Read a plan, as ``riffel study`` does.

        Raises
        ------
        FileNotFoundError
            If there is no such file.
        ValueError
            For a key or a value of plan or case that is not allowed, with the line of the file.

        Examples
        --------
        >>> study = riffel.Study.from_toml("cases/study.toml")
        >>> study.samples
        1024
        """
        return cls(_riffel.Study.read(os.fspath(path)))

    @classmethod
    def from_dict(cls, keys: Mapping[str, Any], *, case: str | os.PathLike[str]) -> Study:
        """A study from nested dicts with the keys of a plan, on a case file.

        Examples
        --------
        >>> study = riffel.Study.from_dict(
        ...     {
        ...         "design": {"method": "grid"},
        ...         "parameter": [{"key": "contact.friction", "values": [0.2, 0.3, 0.4]}],
        ...         "outputs": {"ridge": True},
        ...     },
        ...     case="cases/nominal.toml",
        ... )
        >>> study.design()["contact.friction"].values
        array([0.2, 0.3, 0.4])
        """
        return cls(_riffel.Study.from_dict({"case": os.fspath(case), **keys}, os.fspath(case)))

    @classmethod
    def open(cls, folder: Folder) -> Study:
        """The study whose results a folder holds, finished or not.

        Raises
        ------
        FileNotFoundError
            If the folder holds no study.
        ValueError
            If it was begun by another version of Riffel.
        """
        study = cls(_riffel.Study.open(os.fspath(folder)))
        study._folder = Path(folder).absolute()
        return study

    @property
    def title(self) -> str | None:
        """What the study is about."""
        return self._study.title

    @property
    def samples(self) -> int:
        """Number of samples."""
        return self._study.samples

    @property
    def remarks(self) -> list[str]:
        """What to know about the plan."""
        return self._study.remarks

    @property
    def parameters(self) -> list[str]:
        """Keys of the case that vary, in their order."""
        return [key for key, *_ in self._study.parameters()]

    def __repr__(self) -> str:
        return f"<riffel.Study {self.title or 'without title'!r}: {self.samples} samples of {', '.join(self.parameters)}>"

    def design(self, start: int = 0, stop: int | None = None) -> xr.Dataset:
        """Values of the parameters, in SI, in the samples from `start` up to `stop`.

        Examples
        --------
        >>> riffel.Study.from_toml("cases/study.toml").design(0, 4).sizes
        Frozen({'sample': 4})
        """
        stop = self.samples if stop is None else stop
        if not 0 <= start <= stop <= self.samples:
            raise ValueError(f"samples {start} to {stop} are not among the {self.samples} of the study")
        columns = {}
        for (key, unit, name, _), values in zip(self._study.parameters(), self._study.design(start, stop), strict=True):
            attributes = {"long_name": name} | ({} if unit is None else {"units": unit})
            columns[key] = ("sample", np.asarray(values), attributes)
        return xr.Dataset(columns, {"sample": np.arange(start, stop)}, _attributes(self.title))

    def run(
        self,
        folder: Folder,
        client: Client | None = None,
        *,
        shard: str = "1/1",
        progress: Progress | bool | None = None,
        patience: float | None = None,
        attempts: int = 3,
    ) -> xr.Dataset:
        """Compute what is missing, and open the results.

        Finished chunks are kept when it is interrupted, and the same call goes on from there.

        Parameters
        ----------
        folder : path-like
            Where the results are; made if need be. On a cluster all machines must see it under the same name.
        client : distributed.Client, optional
            Cluster that does the work, with Riffel installed on its workers; by default all cores of this machine.
        shard : str
            Only every n-th chunk, as in ``"3/8"`` for the third of eight jobs.
        progress : callable or bool, optional
            Called with the samples done and to do; by default a line on a terminal.
        patience : float, optional
            Seconds after which a task of the cluster that does not answer is given to another worker as well; by default
            a minute, or twenty times the longest task so far.
        attempts : int
            How often a task of the cluster is tried before the study stops.

        Returns
        -------
        xarray.Dataset
            As `results`. With a shard the chunks of others are NaN, or empty texts.

        Raises
        ------
        ValueError
            If the folder holds something else, or the results of another plan.
        OSError
            If results cannot be written. Finished chunks are kept.
        RuntimeError
            If tasks of a cluster keep failing. Finished chunks are kept.

        Examples
        --------
        >>> import tempfile
        >>> study = riffel.Study.from_toml("cases/study.toml")
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     results = study.run(folder).load()
        >>> float(results["ridge_frequency"].median()) > 400.0
        True
        """
        folder = Path(folder).absolute()
        tell = _progress(progress)
        if client is None:
            self._study.run(os.fspath(folder), shard, tell)
        else:
            from riffel import _cluster

            _cluster.run(self._study, folder, client, shard=shard, progress=tell, patience=patience, attempts=attempts)
        self._folder = folder
        return open_results(folder)

    def tornado(self, output: str, shares: tuple[float, float] = (0.1, 0.9)) -> xr.Dataset:
        """What each parameter does alone, from its low to its high quantile with the others at their medians.

        Parameters
        ----------
        output : str
            An output that is one number of each sample.
        shares : tuple of float
            Those of the low and the high quantile.

        Returns
        -------
        xarray.Dataset
            ``low`` and ``high``, the output at both ends, over ``parameter``, the widest swing first; ``low_value`` and
            ``high_value``, the values of the parameter; and ``median``, the output with all at their medians.

        Examples
        --------
        >>> tornado = riffel.Study.from_toml("cases/study.toml").tornado("highest_growth_rate")
        >>> tornado.sizes["parameter"]
        4
        """
        if not 0.0 < shares[0] < shares[1] < 1.0:
            raise ValueError(f"shares are {shares}, but must rise between 0 and 1, as in (0.1, 0.9)")
        values, outputs, median = self._study.tornado(output, list(shares))
        swings = np.array(outputs)
        low_value, high_value = (np.array([pair[end] for pair in values], dtype=object) for end in (0, 1))
        order = np.argsort(-np.abs(swings[:, 1] - swings[:, 0]), kind="stable")
        attributes = {"output": output, "shares": list(shares)}
        return xr.Dataset(
            {
                "low": ("parameter", swings[order, 0]),
                "high": ("parameter", swings[order, 1]),
                "low_value": ("parameter", low_value[order]),
                "high_value": ("parameter", high_value[order]),
                "median": median,
            },
            {"parameter": np.array(self.parameters)[order]},
            attributes | _attributes(self.title),
        )

    def sobol_indices(
        self, output: str | xr.DataArray, *, confidence: float = 0.95, resamples: int = 1000, seed: int = 0
    ) -> xr.Dataset:
        """First-order and total Sobol indices of an output of a study with the design ``saltelli``.

        Estimators of Saltelli et al. (2010) and Jansen (1999), intervals by bootstrap over the base samples.

        Parameters
        ----------
        output : str or xarray.DataArray
            One number of each sample: the name of an output of a study that was run or opened from its folder, as in
            ``"highest_growth_rate"``, or an array, as in ``results["highest_growth_rate"]``.
        confidence : float
            Confidence of the intervals.
        resamples, seed : int
            Samples of the bootstrap, and what their choice follows from.

        Returns
        -------
        xarray.Dataset
            ``first`` and ``total`` over ``parameter``, with ``first_low`` and so on; ``variance``; the attribute
            ``left_out`` counts base samples with a failed row.

        Raises
        ------
        ValueError
            For another design, a name that is no output, an output of another shape, or one that does not vary; for a
            name also where the study has no results yet.

        Examples
        --------
        >>> import tempfile
        >>> study = riffel.Study.from_dict(
        ...     {
        ...         "design": {"method": "saltelli", "samples": 32, "seed": 1},
        ...         "parameter": [
        ...             {"key": "contact.friction", "uniform": {"min": 0.2, "max": 0.5}},
        ...             {"key": "wheel.mass", "uniform": {"min": 340, "max": 360}},
        ...         ],
        ...         "outputs": {"ridge": True},
        ...     },
        ...     case="cases/nominal.toml",
        ... )
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     results = study.run(folder)
        ...     indices = study.sobol_indices("highest_growth_rate")
        >>> indices["total"].idxmax("parameter").item()
        'contact.friction'
        """
        width = len(self.parameters) + 2
        if not self._study.is_saltelli:
            raise ValueError("Sobol indices need the design: method = \"saltelli\" in [design]")
        if isinstance(output, str):
            output = self._output(output)
        if output.dims != ("sample",) or output.size != self.samples:
            raise ValueError(
                f"the output has the dimensions {dict(output.sizes)}, but must be one number for each of the "
                f"{self.samples} samples"
            )
        if not 0.0 < confidence < 1.0:
            raise ValueError(f"confidence is {confidence}, but must be between 0 and 1")
        values = np.ascontiguousarray(output.values, dtype=np.float64)
        first, total, variance, left_out = _riffel.sobol_indices(values, width - 2, confidence, resamples, seed)
        columns: dict[str, Any] = {"variance": variance}
        for name, rows in (("first", first), ("total", total)):
            for suffix, column in zip(("", "_low", "_high"), np.array(rows).T, strict=True):
                columns[name + suffix] = ("parameter", column)
        attributes = {"output": str(output.name), "confidence": confidence, "left_out": left_out}
        return xr.Dataset(columns, {"parameter": self.parameters}, attributes | _attributes(self.title))

    def _output(self, name: str) -> xr.DataArray:
        """The results of an output, every chunk of them finished."""
        if self._folder is None:
            raise ValueError(
                f"the study has no results to take {name} from: run it, open it from its folder with "
                "riffel.Study.open, or give the array, as in results[\"highest_growth_rate\"]"
            )
        results = open_results(self._folder)
        outputs = [str(known) for known in results.data_vars if known not in self.parameters]
        if name not in outputs:
            raise ValueError(f"the study has no output {name}, but {', '.join(outputs)}")
        summary = study_summary(self._folder)
        missing = summary["chunks"] - summary["chunks_finished"]
        if missing:
            raise ValueError(
                f"{self._folder} is not finished: {missing} of {summary['chunks']} chunks are missing; run the study again"
            )
        return results[name]

    def salib_problem(self) -> dict[str, Any]:
        """The problem as SALib wants it, for its other analyses of given samples.

        Rows of the design ``saltelli`` are in SALib's order: ``SALib.analyze.sobol.analyze(study.salib_problem(),
        results["ridge_frequency"].values, calc_second_order=False)``. Bounds are those of the shares of each
        distribution, 0 and 1.

        Examples
        --------
        >>> riffel.Study.from_toml("cases/study.toml").salib_problem()["num_vars"]
        4
        """
        names = self.parameters
        return {"num_vars": len(names), "names": names, "bounds": [[0.0, 1.0] for _ in names]}


def open_results(folder: Folder) -> xr.Dataset:
    """Results of a study, read when they are used; NaN where they are not computed yet.

    Parameters
    ----------
    folder : path-like
        The folder of the study.

    Returns
    -------
    xarray.Dataset
        Parameters and outputs over ``sample``, some over ``speed``, ``wavelength`` or ``band`` as well.

    Raises
    ------
    FileNotFoundError
        If the folder holds no study.
    """
    arrays = Path(folder) / "results.zarr"
    if not arrays.is_dir():
        raise FileNotFoundError(f"{folder} holds no study: there is no {arrays.name}")
    opened: xr.Dataset = xr.open_zarr(arrays, consolidated=False, chunks=None)
    return opened


def merge_studies(into: Folder, folders: Sequence[Folder]) -> list[int]:
    """Copy the finished chunks of the folders of shards into one, as ``riffel study merge``; chunks that none has.

    Raises
    ------
    ValueError
        For folders of different plans, or a damaged chunk; nothing is written then.
    """
    missing: list[int] = ask("study merge", {"into": into, "from": folders})["missing"]
    return missing


def study_summary(folder: Folder) -> dict[str, Any]:
    """How far a study is, and how many samples failed for which reasons."""
    return _riffel.study_summary(os.fspath(folder))


def _attributes(title: str | None) -> dict[str, Any]:
    return {} if title is None else {"title": title}


def _progress(progress: Progress | bool | None) -> Progress | None:
    if callable(progress):
        return progress
    shown = sys.stderr.isatty() if progress is None else progress
    return _Line() if shown else None


class _Line:
    """A line on the terminal with rate and time left."""

    def __init__(self) -> None:
        self.begun = time.monotonic()

    def __call__(self, done: int, samples: int) -> None:
        seconds = max(time.monotonic() - self.begun, 1e-9)
        rate = done / seconds
        left = f", {(samples - done) / rate:.0f} s left" if 0 < done < samples else ""
        end = "\n" if done == samples else ""
        print(f"\r{done}/{samples} samples, {rate:.0f}/s{left}   ", end=end, file=sys.stderr, flush=True)
