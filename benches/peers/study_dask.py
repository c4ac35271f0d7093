"""A study of Riffel on a local cluster of Dask: as many workers of one thread as RAYON_NUM_THREADS says.

Reads lines "study PLAN SAMPLES" from standard input, runs the plan into a folder beside it, and answers each with the seconds
from the call to the opened results, and the sum of the highest growth rates.
"""

import os
import shutil
import sys
import time
from pathlib import Path

import riffel
from distributed import Client, LocalCluster


def main() -> None:
    workers = int(os.environ["RAYON_NUM_THREADS"])
    cluster = LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=None, silence_logs="CRITICAL")
    with cluster, Client(cluster) as client:
        client.wait_for_workers(workers)
        for line in sys.stdin:
            plan = Path(line.split()[1])
            folder = plan.with_name("results")
            begun = time.perf_counter()
            results = riffel.Study.from_toml(plan).run(folder, client, progress=False)
            seconds = time.perf_counter() - begun
            print(seconds, float(results["highest_growth_rate"].sum()), flush=True)
            shutil.rmtree(folder)


if __name__ == "__main__":
    main()
