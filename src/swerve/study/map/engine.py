"""Who runs the tasks: dask.distributed, with workers on this machine or behind the address of a scheduler.

Workers are processes of one thread each. They get a task with all that it needs and give its records back; only the
process that asked writes. A worker that dies is started anew and its task given to another one, three times over; with
no worker left, or no scheduler, the map ends with one message, and what was stored stays.
"""

import asyncio
import logging
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from multiprocessing import resource_tracker
from typing import TYPE_CHECKING, Any, Final

from swerve import __version__
from swerve.errors import InputError, SwerveError, one_line

if TYPE_CHECKING:
    from distributed import Client, Future

PATIENCE: Final = 5.0  # [s] until a scheduler counts as unreachable, and one without a worker as idle
CURE: Final = "start one with `dask scheduler`, and `dask worker ADDRESS` beside it, or leave --scheduler out"
CONFIG: Final = {
    "distributed.scheduler.worker-ttl": None,  # a compiled solver may keep a worker from answering for minutes
    "distributed.worker.daemon": True,  # so that workers end with this process, however it ends
    "distributed.admin.tick.limit": "1h",  # and of that nothing is to be said
}


SILENCE: Final = logging.CRITICAL + 1  # what goes wrong is told by what is raised
LOCAL: Final[dict[str, Any]] = {
    "threads_per_worker": 1,
    "host": "127.0.0.1",
    "dashboard_address": "127.0.0.1:0",  # its server listens in any case; here at a port that is free
    "scheduler_kwargs": {"dashboard": False},
    "memory_limit": 0,
}


class EngineLostError(SwerveError):
    """A task that nobody could bring to its end."""


@contextmanager
def engine(n_workers: int, scheduler: str | None) -> Iterator["Client"]:
    """What takes tasks.

    Args:
        n_workers: processes on this machine.
        scheduler: address of one that runs already, with its own workers; then none are started here.

    Raises:
        InputError: dask.distributed is not installed; the scheduler cannot be reached, has no worker, or its workers
            have another version of swerve.
    """
    try:
        import dask
        from distributed import Client, LocalCluster
    except ImportError as error:
        cure = "install it with: pip install 'swerve[map]'"
        raise InputError(f"map needs dask.distributed, which is not installed; {cure}") from error
    logging.getLogger("distributed").setLevel(SILENCE)
    with dask.config.set(CONFIG):
        if scheduler is not None:
            _check_reachable(scheduler)
            with Client(scheduler, timeout=PATIENCE, set_as_default=False) as client:
                _check_workers(client, scheduler)
                yield client
            return
        with _deaf():
            local = LocalCluster(n_workers=n_workers, silence_logs=SILENCE, **LOCAL)
            client = Client(local, set_as_default=False)
        try:
            yield client
        finally:
            with _deaf():
                client.close()
                local.close()


@contextmanager
def _deaf() -> Iterator[None]:
    """Hold Ctrl-C back meanwhile; threads and processes that are begun here never hear it, only this one will."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # at its start it would let signals through again, in whatever thread that is
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def is_deserted(client: "Client") -> bool:
    """Whether nobody is there who could end a task."""
    return client.status != "running" or not client.scheduler_info(n_workers=1).get("workers")


def result_of(future: "Future[Any]") -> Any:
    """What a task gave, or its own error; EngineLostError where it came to no end."""
    from distributed import CancelledError
    from distributed.scheduler import KilledWorker

    try:
        return future.result()
    except CancelledError as error:
        raise EngineLostError("the scheduler is gone") from error
    except KilledWorker as error:
        raise EngineLostError("workers died again and again over the same task; they may lack memory") from error


def _check_reachable(address: str) -> None:
    """Ask who is there; a client that fails while it connects would go on complaining until the process ends."""
    try:
        found = asyncio.run(asyncio.wait_for(_identity(address), PATIENCE))
    except (OSError, ValueError, TypeError, TimeoutError) as error:
        raise InputError(f"--scheduler {one_line(address)}: cannot be reached; {CURE}") from error
    if found != "Scheduler":
        raise InputError(f"--scheduler {one_line(address)}: is a {one_line(str(found))}, no scheduler; {CURE}")


async def _identity(address: str) -> object:
    from distributed.core import rpc

    async with rpc(address) as there:
        return (await there.identity()).get("type")


def _check_workers(client: "Client", address: str) -> None:
    try:
        client.wait_for_workers(1, timeout=PATIENCE)
    except TimeoutError as error:
        cure = "start one with `dask worker ADDRESS`"
        raise InputError(f"--scheduler {one_line(address)}: has no worker; {cure}") from error
    try:
        versions = client.run(_version)
    except ModuleNotFoundError as error:
        raise InputError(f"--scheduler {one_line(address)}: its workers have no swerve; install it there") from error
    for worker, version in versions.items():
        if version != __version__:
            fault = f"its worker {worker} has swerve {version}, this is {__version__}"
            raise InputError(f"--scheduler {one_line(address)}: {fault}; install the same")


def _version() -> str:
    return __version__
