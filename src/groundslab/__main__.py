"""The command line as ``python -m groundslab``."""

import sys

from groundslab.cli import main

if __name__ == "__main__":
    sys.exit(main())
