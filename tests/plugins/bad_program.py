# A program that misbehaves in the way that the first coordinate of the query, or its first argument, names.
# SPDX-License-Identifier: MIT
import os
import signal
import sys
import time

order = sys.argv[1] if len(sys.argv) > 1 else ""
if order == "exits":
    sys.exit("no licence found")
if order == "hangs":
    time.sleep(60)


def say(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def leave_a_daemon(note):
    """A process of its own session whose parent has ended. Returns once it runs; its number is in the file."""
    if os.fork() == 0:
        os.setsid()
        if os.fork() != 0:
            os._exit(0)
        with open(note + ".new", "w") as file:
            file.write("%d\n" % os.getpid())
        os.rename(note + ".new", note)
        time.sleep(600)
        os._exit(0)
    os.wait()
    while not os.path.exists(note):
        time.sleep(0.01)


calls = 0
for line in sys.stdin:
    calls += 1
    words = line.split()
    if order == "unsupported" or words[0] == "point-edge":
        say("unsupported\n")
        continue
    if order == "garbage":
        say("hello\n")
        continue
    what = int(float.fromhex(words[1]))
    if what == 1:
        sys.exit(3)
    elif what == 2:
        os.kill(os.getpid(), signal.SIGKILL)
    elif what == 3:
        time.sleep(60)
    elif what == 4:
        say("what?\n")
    elif what == 5:
        say("1 0x1p-1 0x1p-2\n")
    elif what == 6:
        say("0\n0\n")
    elif what == 7:
        say("1" * 100000 + "\n")
    elif what == 8:
        say("0")  # and no line feed
        time.sleep(60)
    elif what == 9:
        say("0")
        sys.exit(0)
    elif what == 10:
        while True:
            say("0\n" * 1000)
    elif what == 11:
        say("1 nan\n")
    elif what == 12:
        say("1\n")
    elif what == 13:
        say("1 %d\r\n" % calls)
    elif what == 14:
        say("1 ")
        time.sleep(0.02)
        say("0x1p")
        time.sleep(0.02)
        say("-3\n")
    elif what == 15:
        sys.stderr.write("a word and another\n" * 20000)
        sys.stderr.write("the last words\n")
        sys.exit(1)
    elif what == 16:
        os.close(1)
        time.sleep(60)
    elif what == 17:
        say("unsupported\n")
    elif what == 18:
        say("1 %d\n" % os.getpid())
    elif what == 19:
        os.close(0)
        say("0\n")
        time.sleep(60)
    elif what == 20:
        say("\n")
    elif what in (21, 22):
        leave_a_daemon(order)
        if what == 22:
            sys.exit(3)
        say("0\n")
    elif what == 23:
        sys.stderr.write("x" * 200000)
        sys.stderr.flush()
        say("0\n")
    else:
        say("0\n")
