"""A screen in memory for tests that start rviz."""

import os


def start_screen(start, size):
    """Xvfb chooses a number that is free and says which; returns what DISPLAY has to be.
    @param start  starts a command as a process with the file descriptors `pass_fds`, and ends it when the test ends"""
    read_end, write_end = os.pipe()
    start(["Xvfb", "-displayfd", str(write_end), "-screen", "0", size + "x24", "-nolisten", "tcp"], pass_fds=[write_end])
    os.close(write_end)
    with os.fdopen(read_end) as pipe:
        number = pipe.readline().strip()
    if not number:
        raise RuntimeError("Xvfb did not come up")
    return ":" + number
