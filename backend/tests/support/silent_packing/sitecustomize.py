"""Python starts with this on its path: a worker that packs says nothing and never ends by itself."""

import sys
import threading

if sys.orig_argv[1:4] == ["-m", "epf_gcs.flights", "pack"]:
    from epf_gcs.flights import pack

    pack.run = lambda *_: {"ended": threading.Event().wait()}
