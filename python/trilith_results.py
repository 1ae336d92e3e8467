"""Results of Trilith as pandas data frames.

    import trilith_results as tr
    run = tr.open("out/wall.h5")
    run.histories["base shear"].plot()
    run.events.query("type == 'bond.broken'")

Needs h5py and pandas; pictures need matplotlib. Units are SI and are in `DataFrame.attrs["units"]`.
"""
import os
import subprocess
from pathlib import Path

import h5py
import numpy as np
import pandas as pd

__all__ = ["open", "run", "study", "Results", "TrilithError"]

BEARING_STATES = ["intact", "yielded", "failed", "changed", "waiting", "absent"]
VERDICT_EVENTS = ("body.passed", "stage.diverged", "stage.unsettled")


class TrilithError(RuntimeError):
    """A file that is not from Trilith, or a run of the program that failed."""


def _text(value):
    return value.decode("utf8", "replace") if isinstance(value, bytes) else str(value)


def _table(dataset, rows=None):
    """A compound data set as a data frame; texts are str."""
    values = dataset[:rows] if rows is not None else dataset[()]
    frame = pd.DataFrame({name: [_text(v) for v in values[name]] if values.dtype[name].kind in "SO" else
                          np.ascontiguousarray(values[name]) for name in values.dtype.names})
    frame.attrs["units"] = dict(zip(values.dtype.names, (_text(u) for u in dataset.attrs.get("units", []))))
    return frame


def _rotation_matrices(quaternions):
    """[n, 4] (w, x, y, z) to [n, 3, 3]."""
    w, x, y, z = np.moveaxis(np.asarray(quaternions, float), -1, 0)
    return np.stack([
        np.stack([1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)], -1),
        np.stack([2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)], -1),
        np.stack([2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)], -1)], -2)


def open(path):  # pylint: disable=redefined-builtin
    """The results of a run. Where only PATH.part exists, the run continues or was killed; its safe rows are read."""
    return Results(path)


def run(script, program="trilith", results=None, quiet=True, **parameters):
    """Runs a script with the given parameters and returns its results.

    `results` is the file of m:results{}, relative to the current folder; without it, the file that the run names.
    Raises TrilithError with the program's message if the run fails. Exit code 3, a run that is not reliable, is not a
    failure: see Results.verdict.
    """
    words = [program, "run", str(script)] + [f"{name}={value}" for name, value in parameters.items()]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    if not quiet:
        print(done.stdout, end="")
    if done.returncode not in (0, 3):
        message = done.stderr.strip().splitlines() or done.stdout.strip().splitlines() or ["no message"]
        raise TrilithError(f"{' '.join(words)}: exit code {done.returncode}: {message[-1]}")
    if results is None:
        for line in (done.stdout + done.stderr).splitlines():
            before, mark, after = line.partition("note: results are in ")
            if mark and not before:
                results = after.split(";")[0].strip()
    if results is None:
        raise TrilithError(f"{' '.join(words)}: the run names no results file; pass results=")
    return Results(results)


def study(path):
    """The table of `trilith study`: a row for each case, NaN where a case has no value."""
    with h5py.File(path, "r") as file:
        if _text(file.attrs.get("format", b"")) != "trilith study":
            raise TrilithError(f"{path} is not the table of a study")
        return _table(file["cases"]).set_index("case")


class Results:
    """A results file. Tables are read at their first use; `refresh` reads the new rows of a running run."""

    def __init__(self, path):
        path = Path(path)
        part = Path(str(path) + ".part")
        self.path = path if path.exists() or not part.exists() else part
        if not self.path.exists():
            raise FileNotFoundError(f"there is no results file '{path}'")
        try:
            live = self.path.suffix == ".part"
            self.file = h5py.File(self.path, "r", libver="latest", swmr=True) if live else h5py.File(self.path, "r")
        except OSError as error:
            raise TrilithError(f"'{self.path}' is not an HDF5 file, or cannot be read: {error}") from error
        if _text(self.file.attrs.get("format", b"")) != "trilith":
            raise TrilithError(f"'{self.path}' is not a results file of Trilith")
        self._kept = {}

    def close(self):
        self.file.close()

    def __enter__(self):
        return self

    def __exit__(self, *reason):
        self.close()

    def refresh(self):
        """Opens the file again, to read the rows that a running run has added."""
        self.file.close()
        self.__init__(self.path)
        return self

    def _rows(self, dataset):
        """Number of safe rows of a growing data set."""
        counter = _text(dataset.attrs.get("rows", b""))
        committed = self.file["committed"]
        if counter and counter in (committed.dtype.names or ()):
            return int(np.ravel(committed[counter])[0])
        return None

    def _get(self, name, read):
        if name not in self._kept:
            self._kept[name] = read()
        return self._kept[name]

    def table(self, name):
        """Any table of the file as a data frame, such as "model/bodies"."""
        dataset = self.file[name]
        return self._get(name, lambda: _table(dataset, self._rows(dataset)))

    def _columns(self, group, index="time"):
        def read():
            values = {name: d[:self._rows(d)] for name, d in self.file[group].items()}
            units = {name: _text(d.attrs["units"]) for name, d in self.file[group].items()}
            rows = min((len(v) for v in values.values()), default=0)
            frame = pd.DataFrame({name: v[:rows] for name, v in values.items()}).set_index(index)
            frame.attrs["units"] = units
            return frame
        return self._get(group, read)

    # --- about the run
    @property
    def finished(self):
        """True if the run is complete."""
        return bool(self.file.attrs["finished"])

    @property
    def dim(self):
        """2 for a model in the plane, 3 in space."""
        return int(self.file.attrs["dim"])

    @property
    def title(self):
        """Name of the model, or of the file."""
        return _text(self.file["provenance"].attrs.get("model", b"")) or self.path.stem

    @property
    def script(self):
        """The script as it was run."""
        return self.file["provenance/script"].asstr()[()]

    @property
    def parameters(self):
        """Parameters of the script in this run."""
        return self.table("provenance/parameters").set_index("name")

    @property
    def notes(self):
        return self.table("provenance/notes")

    @property
    def verdict(self):
        """"" for a reliable run, otherwise the first event that makes it invalid."""
        invalid = self.events[self.events.type.isin(VERDICT_EVENTS)]
        return "" if invalid.empty else f"{invalid.type.iloc[0]} at {invalid.time.iloc[0]:g} s: {invalid.text.iloc[0]}"

    # --- tables
    @property
    def histories(self):
        """Recorded quantities over time; NaN while the owner is not in the model."""
        return self._columns("histories")

    @property
    def energy(self):
        """Terms of the energy balance over time [J]."""
        return self._columns("energy")

    @property
    def events(self):
        return self.table("events")

    @property
    def stages(self):
        return self.table("stages")

    @property
    def bodies(self):
        return self.table("model/bodies")

    @property
    def bearings(self):
        return self.table("model/bearings")

    @property
    def joints(self):
        return self.table("model/joints") if "model/joints" in self.file else pd.DataFrame()

    @property
    def modes(self):
        return self.table("modes/list") if "modes/list" in self.file else pd.DataFrame()

    # --- frames
    @property
    def times(self):
        """Times of the frames [s]."""
        d = self.file["frames/time"]
        return self._get("times", lambda: d[:self._rows(d)])

    def frame(self, time):
        """Number of the frame nearest to a time [s]; None is the last frame."""
        if len(self.times) == 0:
            raise TrilithError(f"'{self.path}' has no frames")
        return len(self.times) - 1 if time is None else int(np.argmin(np.abs(self.times - time)))

    def nodes(self, time=None):
        """Positions [N, dim] and rotation matrices [N, dim, dim] of the nodes in the frame nearest to `time`."""
        i = self.frame(time)
        position = self.file["frames/position"][i]
        if self.dim == 3:
            return position, _rotation_matrices(self.file["frames/quaternion"][i])
        angle = self.file["frames/angle"][i]
        c, s = np.cos(angle), np.sin(angle)
        return position, np.stack([np.stack([c, -s], -1), np.stack([s, c], -1)], -2)

    def bodies_at(self, time=None):
        """A row for each body in the frame nearest to `time`: place of its first node, displacement from the start."""
        axes = list("xyz")[:self.dim]
        first = self.bodies.first_node.to_numpy()
        position, turn = self.nodes(time)
        start = self.file["model/node_position"][()]
        frame = self.bodies[["name", "kind", "material", "groups", "support"]].copy()
        for k, axis in enumerate(axes):
            frame[axis] = position[first, k]
        for k, axis in enumerate(axes):
            frame["u" + axis] = position[first, k] - start[first, k]
        if self.dim == 2:
            frame["rotation"] = self.file["frames/angle"][self.frame(time)][first] - self.file["model/node_angle"][()][first]
        else:
            frame["rotation"] = np.arccos(np.clip((np.trace(turn[first], axis1=1, axis2=2) - 1) / 2, -1, 1))
        frame.attrs["time"] = float(self.times[self.frame(time)])
        frame.attrs["units"] = {**{a: "m" for a in axes}, **{"u" + a: "m" for a in axes}, "rotation": "rad"}
        return frame.set_index("name")

    def bearings_at(self, time=None):
        """A row for each bearing: state, force on body b [N], displacement [m]."""
        frame = self.bearings[["name", "law"]].copy()
        if frame.empty:
            return frame.set_index("name")
        i = self.frame(time)
        frame["state"] = [BEARING_STATES[s] for s in self.file["frames/bearing_state"][i]]
        for k, axis in enumerate("xyz"[:self.dim]):
            frame["f" + axis] = self.file["frames/bearing_force"][i][:, k]
        for k, axis in enumerate(["along", "axial"] if self.dim == 2 else ["along", "across", "axial"]):
            frame[axis] = self.file["frames/bearing_displacement"][i][:, k]
        return frame.set_index("name")

    def contacts_at(self, time=None):
        """Contact forces in the frame nearest to `time`: point, force on body a [N], names of the bodies."""
        i = self.frame(time)
        first, count = (int(self.file["frames/contact_" + n][i]) for n in ("first", "count"))
        values = self.file["frames/contacts"][first:first + count]
        frame = pd.DataFrame({n: values[n] for n in values.dtype.names})
        names = self.bodies.name.to_numpy()
        for side in ("body_a", "body_b"):
            frame[side] = names[frame[side].to_numpy(int)] if len(frame) else []
        return frame

    def outlines(self, time=None):
        """Outline of each body in the plane in the frame nearest to `time`: {name: [points, 2]} [m]."""
        if self.dim != 2:
            raise TrilithError("outlines are of models in the plane; use vertices() in space")
        return self.vertices(time)

    def vertices(self, time=None):
        """Outline points, or corners in space, of each body: {name: [points, dim]} [m]."""
        position, turn = self.nodes(time)
        node = self.file["model/vertex_node"][()]
        local = self.file["model/vertices"][()]
        world = position[node] + np.einsum("nij,nj->ni", turn[node], local)
        return {b["name"]: world[b.first_vertex:b.first_vertex + b.vertex_count] for _, b in self.bodies.iterrows()}

    # --- pictures
    def plot(self, *names, against=None, ax=None):
        """Histories over time, or over the history `against`, with units. Returns the matplotlib axes."""
        import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel
        ax = ax or plt.figure().add_subplot()
        unit = self.histories.attrs["units"]
        names = names or [n for n in self.histories.columns if n != against]
        unknown = [n for n in [*names, *([against] if against else [])] if n not in self.histories.columns]
        if unknown:
            raise KeyError(f"there is no history {unknown[0]!r}; known: {', '.join(self.histories.columns)}")
        across = self.histories[against] if against else self.histories.index
        for name in names:
            ax.plot(across, self.histories[name], label=name)
        ax.set_xlabel(f"{against} [{unit[against]}]" if against else "time [s]")
        ax.set_ylabel(", ".join(dict.fromkeys(f"{names[0] if len(names) == 1 else ''} [{unit[n]}]".strip()
                                              for n in names)))
        if len(names) > 1:
            ax.legend()
        return ax

    def draw(self, time=None, ax=None):
        """The structure in the plane in the frame nearest to `time`. Returns the matplotlib axes."""
        import matplotlib.pyplot as plt  # pylint: disable=import-outside-toplevel
        from matplotlib.collections import PolyCollection  # pylint: disable=import-outside-toplevel
        ax = ax or plt.figure().add_subplot()
        outlines = self.outlines(time)
        held = {b["name"] for _, b in self.bodies.iterrows() if "free" not in b.support}
        ax.add_collection(PolyCollection(list(outlines.values()), edgecolors="black", linewidths=0.4,
                                         facecolors=["0.75" if n in held else "#c9a27a" for n in outlines]))
        free = [o for n, o in outlines.items() if n not in held] or list(outlines.values())
        low, high = np.min([o.min(0) for o in free], 0), np.max([o.max(0) for o in free], 0)
        margin = 0.05 * float(max(high - low))
        ax.set(xlim=(low[0] - margin, high[0] + margin), ylim=(low[1] - margin, high[1] + margin), aspect="equal",
               xlabel="x [m]", ylabel="y [m]", title=f"{self.title}, t = {self.times[self.frame(time)]:.2f} s")
        return ax

    # --- notebooks
    def summary(self):
        """Figures of the run as a series."""
        end = float(self.times[-1]) if len(self.times) else float("nan")
        return pd.Series({"model": self.title, "file": os.fspath(self.path), "finished": self.finished, "dim": self.dim,
                          "bodies": len(self.bodies), "bearings": len(self.bearings), "frames": len(self.times),
                          "end [s]": end, "histories": ", ".join(self.histories.columns), "events": len(self.events),
                          "verdict": self.verdict or "reliable"})

    def __repr__(self):
        return f"<Trilith results '{self.path}': {len(self.bodies)} bodies, {len(self.times)} frames, " \
               f"{len(self.events)} events, {'finished' if self.finished else 'unfinished'}>"

    def _repr_html_(self):
        stages = self.stages[["name", "kind", "begin", "end", "why"]].to_html(index=False)
        return f"{self.summary().to_frame('').to_html(header=False)}{stages}"
