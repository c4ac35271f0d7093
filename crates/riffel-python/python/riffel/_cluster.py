"""Studies on a cluster of Dask.

Workers write their results themselves; the client knows the numbers of chunks and nothing else. A chunk is finished when
its record is in the folder, so that it may be computed twice, by a worker that was given up and by another: both write
the same bytes.
"""

from __future__ import annotations

import functools
import statistics
import time
from collections import Counter, deque
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from distributed import Client, Future, KilledWorker, get_worker, wait
from distributed.comm.core import CommClosedError

from riffel import _riffel

LONG_ENOUGH = 1.0
"""Seconds of a task: far beyond the millisecond that a scheduler takes for one."""
QUEUE = 2
"""Tasks for each thread of the cluster, so that none waits for the client."""
FIRST_PATIENCE = 60.0
BROKEN = 3
"""Failures to write or to answer after which a worker gets nothing more."""
SHARED = "it must be a folder that all machines of the cluster share"
KEPT = "Finished chunks are kept: the same call goes on where it stopped"


@dataclass
class Task:
    """Chunks that one worker computes in turn."""

    chunks: tuple[int, ...]
    attempts: int = 0
    refused: set[str] = field(default_factory=set)
    """Workers that failed it or do not answer."""
    reasons: list[str] = field(default_factory=list)
    begun: float = 0.0

    @property
    def name(self) -> str:
        first, last = self.chunks[0], self.chunks[-1]
        return f"chunk {first}" if first == last else f"chunks {first} to {last}"


@functools.lru_cache(maxsize=4)
def _study(folder: str, fingerprint: str) -> _riffel.Study:
    return _riffel.Study.open(folder)


def compute(folder: str, fingerprint: str, chunks: tuple[int, ...]) -> tuple[str, float, str | None]:
    """On a worker: compute chunks and write them. Its address, the seconds it took, and why it could not write."""
    address = str(get_worker().address)
    begun = time.perf_counter()
    # A study that was opened before would make the folder anew, where nobody looks for it.
    if not Path(folder).is_dir():
        return address, 0.0, f"does not see {folder}: {SHARED}"
    try:
        _study(folder, fingerprint).compute(folder, list(chunks))
    except OSError as error:
        return address, time.perf_counter() - begun, str(error)
    return address, time.perf_counter() - begun, None


def _threads(client: Client) -> dict[str, int]:
    """Threads of each worker, as the scheduler knows them now.

    `Client.scheduler_info` tells the same from what it keeps, which a timer replaces now and then by one without workers.
    """
    if client.scheduler is None:
        return {}
    known = client.sync(client.scheduler.identity, n_workers=-1)
    return {address: worker["nthreads"] for address, worker in known["workers"].items()}


def run(
    study: _riffel.Study,
    folder: Path,
    client: Client,
    *,
    shard: str,
    progress: Callable[[int, int], object] | None,
    patience: float | None,
    attempts: int,
) -> None:
    """Compute the pending chunks of a shard on a cluster."""
    if patience is not None and not patience > 0.0:
        raise ValueError(f"patience is {patience}, but must be above zero")
    if attempts < 1:
        raise ValueError(f"attempts is {attempts}, but must be one or more")
    if not _threads(client):
        raise RuntimeError("the cluster has no workers: wait for them with client.wait_for_workers(1)")
    study.begin(str(folder))
    chunks = study.pending(str(folder), shard)
    _Run(study, folder, client, chunks, progress, patience, attempts).finish()


class _Run:
    """Tasks under way, and those to come."""

    def __init__(
        self,
        study: _riffel.Study,
        folder: Path,
        client: Client,
        chunks: list[int],
        progress: Callable[[int, int], object] | None,
        patience: float | None,
        attempts: int,
    ) -> None:
        self.study, self.folder, self.client = study, str(folder), client
        self.progress, self.patience, self.attempts = progress, patience, attempts
        self.chunks = deque(chunks)
        self.again: deque[Task] = deque()
        self.futures: dict[Future[Any], Task] = {}
        self.open = set(chunks)
        self.samples = self._samples(chunks)
        self.seconds: deque[float] = deque(maxlen=50)
        """Of a chunk, in the latest tasks."""
        self.longest = 0.0
        self.broken: Counter[str] = Counter()
        self.refusal = ""
        """Why the latest worker could not write."""
        self.seen = time.monotonic()
        """When there was a worker."""

    def finish(self) -> None:
        """Work until all chunks are there, or raise with those that are there kept."""
        computed = tuple(self.open)
        try:
            while self.open:
                self._give()
                self._take()
                self._look_after()
                self._tell()
        except (CommClosedError, TimeoutError) as error:
            raise RuntimeError(f"the scheduler does not answer. {KEPT}") from error
        finally:
            if self.client.status == "running":
                self.client.cancel(list(self.futures), force=True)
            self.futures.clear()
        self._check_written(computed)

    def _samples(self, chunks: Iterable[int]) -> int:
        size = self.study.samples_per_chunk
        return sum(min(size, self.study.samples - chunk * size) for chunk in chunks)

    def _tell(self) -> None:
        if self.progress is not None:
            self.progress(self.samples - self._samples(self.open), self.samples)

    def _workers(self) -> dict[str, int]:
        """Threads of the workers that may get tasks."""
        workers = _threads(self.client)
        return {address: threads for address, threads in workers.items() if self.broken[address] < BROKEN}

    def _give(self) -> None:
        workers = self._workers()
        if workers:
            self.seen = time.monotonic()
        elif time.monotonic() - self.seen > (self.patience or FIRST_PATIENCE):
            raise RuntimeError(f"the cluster has no worker left that answers and can write{self.refusal}. {KEPT}")
        room = QUEUE * sum(workers.values()) - len(self.futures)
        while room > 0 and (self.again or self.chunks):
            task = self.again.popleft() if self.again else self._next(sum(workers.values()))
            self._submit(task, workers)
            room -= 1

    def _next(self, threads: int) -> Task:
        """As many chunks as take long enough, and not so many that some threads idle at the end."""
        long_enough = LONG_ENOUGH / statistics.median(self.seconds) if self.seconds else 1.0
        fair = len(self.chunks) / (4 * threads)
        count = max(1, min(round(long_enough), int(fair)))
        return Task(tuple(self.chunks.popleft() for _ in range(min(count, len(self.chunks)))))

    def _submit(self, task: Task, workers: dict[str, int]) -> None:
        if task.attempts >= self.attempts:
            raise self._stopped(task, f"failed {task.attempts} times")
        others = [address for address in workers if address not in task.refused]
        if not others:
            raise self._stopped(task, "failed on every worker")
        task.attempts += 1
        task.begun = time.monotonic()
        future = self.client.submit(
            compute,
            self.folder,
            self.study.fingerprint,
            task.chunks,
            workers=others if task.refused or self.broken else None,
            pure=False,
        )
        self.futures[future] = task

    def _stopped(self, task: Task, how: str) -> Exception:
        reasons = f": {task.reasons[-1]}" if task.reasons else ""
        sentence = f"{task.name} {how}{reasons}. {KEPT}"
        return OSError(sentence) if task.reasons and "cannot write" in task.reasons[-1] else RuntimeError(sentence)

    def _take(self) -> None:
        """Wait a moment, and take what has ended."""
        if not self.futures:
            # All workers are gone, or broken; others may come.
            time.sleep(0.1)
            return
        try:
            wait(list(self.futures), timeout=0.5, return_when="FIRST_COMPLETED")
        except TimeoutError:
            return
        for future in [future for future in self.futures if future.done()]:
            task = self.futures.pop(future)
            if future.status == "finished":
                self._finished(task, *future.result())
            elif future.status == "error":
                self._failed(task, future.exception())
            elif self.open.intersection(task.chunks):
                task.reasons.append("the scheduler lost it")
                self.again.append(task)

    def _finished(self, task: Task, address: str, seconds: float, refusal: str | None) -> None:
        if refusal is not None:
            self.broken[address] += 1
            task.refused.add(address)
            task.reasons.append(f"worker {address}: {refusal}")
            self.refusal = f": {task.reasons[-1]}"
            if self.open.intersection(task.chunks):
                self.again.append(task)
            return
        self.open.difference_update(task.chunks)
        self.seconds.append(seconds / len(task.chunks))
        self.longest = max(self.longest, seconds)
        if len(self.seconds) == 1:
            self._check_written(task.chunks)

    def _failed(self, task: Task, error: BaseException | None) -> None:
        if not isinstance(error, KilledWorker):
            # Another version, or a damaged folder: nothing that another worker would do better.
            raise error if error is not None else RuntimeError(f"{task.name} failed without a reason")
        if self.open.intersection(task.chunks):
            task.reasons.append("its workers died")
            self.again.append(task)

    def _look_after(self) -> None:
        """Give what has not answered for long to another worker as well; the first to end counts."""
        patience = self.patience or max(FIRST_PATIENCE, 20.0 * self.longest)
        late = {
            future.key: (future, task)
            for future, task in self.futures.items()
            if time.monotonic() - task.begun > patience
        }
        if not late:
            return
        holders = {key: address for address, keys in self.client.processing().items() for key in keys}
        for key, (future, task) in late.items():
            if not self.open.intersection(task.chunks):
                # A second worker was quicker.
                self.client.cancel([self._forget(future)], force=True)
                continue
            if key in holders:
                task.refused.add(holders[key])
                self.broken[holders[key]] += 1
            task.reasons.append(f"no answer for {patience:.0f} s from worker {holders.get(key, 'that is unknown')}")
            self._forget(future)
            self.client.cancel([future], force=True)
            self.again.append(task)

    def _forget(self, future: Future[Any]) -> Future[Any]:
        self.futures.pop(future)
        return future

    def _check_written(self, chunks: Iterable[int]) -> None:
        """What workers say they wrote must be here."""
        if set(chunks).intersection(self.study.pending(self.folder, "1/1")):
            raise RuntimeError(f"workers have written chunks that are not in {self.folder} here: {SHARED}")
