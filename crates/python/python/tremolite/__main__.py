"""The command `tremolite`."""

import sys

from ._tremolite import command


def main() -> int:
    """Runs the command with the arguments of this process; the status to end with."""
    sys.stdout.flush()
    return command(["tremolite", *sys.argv[1:]], [sys.executable, "-m", "tremolite"])


if __name__ == "__main__":
    sys.exit(main())
