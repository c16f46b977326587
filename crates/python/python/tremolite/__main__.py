"""The command `tremolite`."""

import signal
import sys

from ._tremolite import command


def main() -> int:
    """Runs the command with the arguments of this process; the status to end with."""
    sys.stdout.flush()
    # Python's own handler only takes note of Ctrl-C, which nobody reads while the command works; `run` sets its own.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    return command(["tremolite", *sys.argv[1:]], [sys.executable, "-m", "tremolite"])


if __name__ == "__main__":
    sys.exit(main())
