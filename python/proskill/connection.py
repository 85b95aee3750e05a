"""The connection to `proskill run`: docs/platforms.md of ProSkill."""

from __future__ import annotations

import json
import os
import sys
import threading
import time
from typing import Any, BinaryIO, Iterator

PROTOCOL = 1


class Connection:
    """JSON messages, one per line, in both directions. Sending is thread-safe."""

    def __init__(self, reader: BinaryIO, writer: BinaryIO) -> None:
        self._reader = reader
        self._writer = writer
        self._lock = threading.Lock()
        self.opened = time.monotonic()  # about when `proskill run` started this process

    @classmethod
    def of_this_process(cls) -> Connection:
        """Standard input and output. From now on, print() writes to standard error: a line that is
        not a message would be a fault."""
        reader = os.fdopen(os.dup(0), "rb")
        writer = os.fdopen(os.dup(1), "wb", buffering=0)
        os.dup2(2, 1)
        sys.stdout.flush()
        return cls(reader, writer)

    def send(self, kind: str, **members: Any) -> None:
        line = json.dumps({"type": kind, **members}, ensure_ascii=False, allow_nan=False) + "\n"
        data = memoryview(line.encode("utf-8", "replace"))
        with self._lock:
            try:
                while data:
                    data = data[self._writer.write(data) or 0:]
            except (BrokenPipeError, ConnectionResetError):
                pass  # the end of the input means the same

    def messages(self) -> Iterator[dict[str, Any]]:
        """The messages until the other end is closed."""
        for line in self._reader:
            message = json.loads(line)
            if isinstance(message, dict):
                yield message
