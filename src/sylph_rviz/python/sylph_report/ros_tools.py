"""What the commands of this package share."""
import os
import sys

import roslib.packages


def fail(message):
    """Ends the program with one line and exit status 2: bad input."""
    print(f"{os.path.basename(sys.argv[0])}: {message}", file=sys.stderr)
    sys.exit(2)


def find_program(package, name):
    """Path of a package's executable."""
    found = roslib.packages.find_node(package, name)
    if not found:
        fail(f"executable {package}/{name} not found: is {package} installed?")
    return found[0]
