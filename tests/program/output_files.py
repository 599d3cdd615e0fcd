"""Numbers in the files of a run that are not finite. Imported by hostile_inputs.py."""
import array
import csv
import json
import math
import re


def not_finite(folder):
    """Places, below the folder, of numbers that are not finite, and files that cannot be read; not in what was given."""
    found = []
    for suffix, look in {".json": _json, ".csv": _csv, ".vtu": _vtu, ".h5": _hdf5}.items():
        for path in sorted(folder.rglob(f"*{suffix}")):
            if path.is_file() and not path.is_symlink() and path.name != "case.json":
                found += [f"{path.relative_to(folder)}: {what}" for what in _looked(look, path)]
    return found


def _looked(look, path):
    try:
        return look(path)
    except (OSError, ValueError) as error:
        return [f"cannot be read: {error}"]


def _json(path):
    found = []
    json.loads(path.read_text(encoding="utf-8"), parse_constant=found.append)
    return found


def _csv(path):
    """A station that sees no particle has no means: nan in its columns says so, and is no fault."""
    with open(path, newline="", encoding="utf-8") as file:
        header, *lines = csv.reader(file)
    stations = _stations(path.parent)
    no_means = path.parent.name == "profiles"
    found = []
    for n, line in enumerate(lines, 2):
        for name, cell in zip(header, line, strict=True):
            means = no_means or name.startswith(stations)
            if path.name == "results.csv" and not _is_number(cell):
                continue  # the suite's table has words, too
            if not math.isfinite(float(cell)) and not (means and cell == "nan"):
                found.append(f"line {n}, {name}: {cell}")
    return found


def _is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


def _stations(folder):
    """What the columns of a run's stations begin with."""
    resolved = folder / "resolved.json"
    output = json.loads(resolved.read_text(encoding="utf-8")).get("output", {}) if resolved.is_file() else {}
    return tuple(f"{station['name']}_" for station in output.get("stations", ()))


def _vtu(path):
    """The 64-bit arrays of a frame, which lie behind its text as they do in memory."""
    data = path.read_bytes()
    begin = data.index(b'<AppendedData encoding="raw">')
    start = data.index(b"_", begin) + 1
    found = []
    for tag in re.findall(rb'<DataArray type="Float64"[^>]*>', data[:begin]):
        name, offset = (re.search(member + rb'="([^"]*)"', tag).group(1).decode() for member in (b"Name", b"offset"))
        at = start + int(offset)
        size = int.from_bytes(data[at:at + 8], "little")
        if not all(map(math.isfinite, array.array("d", data[at + 8:at + 8 + size]))):
            found.append(name)
    return found


def _hdf5(path):
    import h5py
    import numpy

    found = []

    def look(name, item):
        for where, value in [(name, item), *((f"{name}@{key}", value) for key, value in item.attrs.items())]:
            if isinstance(value, h5py.Group):
                continue
            values = numpy.asarray(value)
            if values.dtype.kind == "f" and not numpy.isfinite(values).all():
                found.append(where)

    with h5py.File(path) as file:
        file.visititems(look)
    return found
