"""The program `riffel`, as the package brings it along: ``riffel map case.toml`` or ``python -m riffel map case.toml``."""

import signal
import sys

from riffel import _riffel


def main() -> int:
    """Run the program with the arguments of this process and return its exit status."""
    # Ctrl-C is for the program, which leaves nothing half-written.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return _riffel.program(["riffel", *sys.argv[1:]], [sys.executable, __file__])


if __name__ == "__main__":
    sys.exit(main())
