"""Finds the program bannwald and runs it with progress and cancel."""

import io
import os
import queue
import re
import shutil
import signal
import subprocess
import threading

from processing.core.ProcessingConfig import ProcessingConfig
from qgis.core import QgsProcessingException

SETTING = "BANNWALD_PROGRAM"

# Lines such as "falling:  61 %, 6144 of 10000, 5752 per second, 1 s left".
PROGRESS = re.compile(r"^[^:]+:\s+(\d+) %")


def program():
    """The path of the program; an exception says what to do where there is none."""
    chosen = (ProcessingConfig.getSetting(SETTING) or "").strip()
    if chosen:
        if not os.access(chosen, os.X_OK) or os.path.isdir(chosen):
            raise QgsProcessingException(
                f"{chosen} is not a program that can be started: correct it in Settings > Options > "
                "Processing > Providers > Bannwald"
            )
        return chosen
    found = shutil.which("bannwald")
    if found is None:
        raise QgsProcessingException(
            "The program bannwald is not on the PATH: install it, or name it in Settings > Options > "
            "Processing > Providers > Bannwald"
        )
    return found


def read_lines(stream, kind, lines):
    """Hands every line of a pipe to the queue, and None at its end."""
    with io.TextIOWrapper(stream, encoding="utf-8", errors="replace") as text:
        for line in text:
            lines.put((kind, line.rstrip("\n")))
    lines.put((kind, None))


def stop(process):
    """Ends the program as Ctrl-C does: it keeps finished parts."""
    if os.name == "nt":
        process.terminate()
    else:
        process.send_signal(signal.SIGINT)


def call(arguments, feedback):
    """Runs the program and returns its lines. Its progress goes to the feedback, a cancel ends it (a run
    of more than some 20 s keeps what it has, and goes on with the next call); an exit code other than 0 is an exception with the
    messages of the program."""
    path = program()
    feedback.pushCommandInfo(" ".join([path, *arguments]))
    try:
        process = subprocess.Popen(
            [path, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE
        )
    except OSError as error:
        raise QgsProcessingException(f"{path} cannot be started ({error.strerror}): is it built for this system?")
    lines = queue.Queue()
    for stream, kind in ((process.stdout, "answer"), (process.stderr, "message")):
        threading.Thread(target=read_lines, args=(stream, kind, lines), daemon=True).start()

    answers, messages = [], []
    open_pipes, stopped = 2, False
    while open_pipes > 0:
        if feedback.isCanceled() and not stopped:
            stop(process)
            stopped = True
        try:
            kind, line = lines.get(timeout=0.1)
        except queue.Empty:
            continue
        if line is None:
            open_pipes -= 1
        elif kind == "answer":
            answers.append(line)
            feedback.pushConsoleInfo(line)
        elif PROGRESS.match(line):
            feedback.setProgress(float(PROGRESS.match(line).group(1)))
            feedback.setProgressText(line)
        elif line.strip():
            messages.append(line)
            (feedback.pushWarning if "warning: " in line else feedback.pushInfo)(line)
    code = process.wait()
    if stopped:
        raise QgsProcessingException(
            "Cancelled. The program said above whether anything of the run is kept; if so, the same call goes on from there."
        )
    if code != 0:
        text = "\n".join(messages) or "no message"
        raise QgsProcessingException(f"bannwald ended with exit code {code}:\n{text}")
    return answers
