"""Damage to HDF5 files, from a seed: bytes, lengths, and the structure that h5py can reach."""
import random
import shutil

import h5py
import numpy as np

NUMBERS = [0, -1, 1, 2**31 - 1, -2**31, 2**62, -2**63, float("nan"), float("inf"), -1e300, 1e300, 1e-300]


def flip(draw, path):
    with open(path, "r+b") as file:
        data = bytearray(file.read())
        for _ in range(draw.choice([1, 2, 5, 20, 200])):
            at = draw.randrange(len(data))
            data[at] = draw.choice([data[at] ^ (1 << draw.randrange(8)), draw.randrange(256), 0, 255])
        file.seek(0)
        file.write(data)


def cut(draw, path):
    with open(path, "r+b") as file:
        size = file.seek(0, 2)
        file.truncate(draw.choice([draw.randrange(size), size - 1, draw.randrange(min(size, 4096))]))


def objects(file):
    names = []
    file.visit(names.append)
    return names


def wild_number(draw, dtype):
    number = draw.choice(NUMBERS)
    if dtype.kind in "iu":
        if not np.isfinite(number):
            number = -7
        info = np.iinfo(dtype)
        number = int(max(info.min, min(info.max, number)))
    return number


def put_numbers(draw, dataset):
    data = dataset[()]
    if not isinstance(data, np.ndarray) or data.size == 0:
        if np.ndim(data) == 0 and dataset.dtype.names:
            data = np.array(data)
        else:
            return
    flat = data.reshape(-1)
    at = draw.randrange(flat.size)
    if dataset.dtype.names:
        name = draw.choice(dataset.dtype.names)
        kind = dataset.dtype[name]
        text = draw.choice([b"", b"\xff" * 300, b"a\x1b[2Jb", b"<b>&"])
        flat[name][at] = wild_number(draw, kind) if kind.kind in "iuf" else text
    elif dataset.dtype.kind in "iuf":
        flat[at] = wild_number(draw, dataset.dtype)
    dataset[...] = data


def reshape(draw, file, name):
    old = file[name]
    attributes = dict(old.attrs)
    shape = [draw.choice([0, 1, 2, n, n + 1, 2 * n]) for n in old.shape]
    if draw.random() < 0.3:
        shape = shape[:-1] if draw.random() < 0.5 else shape + [draw.choice([0, 1, 3])]
    others = ["f8", "i4", "S5", "i1", h5py.string_dtype(), "u8", "c16"]
    dtype = old.dtype if draw.random() < 0.6 else draw.choice(others)
    del file[name]
    new = file.create_dataset(name, tuple(shape), dtype)
    for key, value in attributes.items():
        if draw.random() < 0.95:
            new.attrs[key] = value


def change_attribute(draw, item):
    if not item.attrs:
        return
    name = draw.choice(sorted(item.attrs))
    dice = draw.random()
    if dice < 0.3:
        del item.attrs[name]
    elif dice < 0.6:
        item.attrs[name] = draw.choice(["", "x", 0, -1, 2**40, 1.5, "frames", "contacts", np.zeros((2, 3)),
                                        [b"a", b"b"]])
    else:
        item.attrs[name] = np.bytes_(b"\xff\x00\x1b[2J" + b"x" * draw.randrange(50))


def restructure(draw, path):
    with h5py.File(path, "r+") as file:
        for _ in range(draw.choice([1, 1, 1, 2, 4])):
            names = objects(file)
            if not names:
                return
            name = draw.choice(names)
            item = file[name]
            dice = draw.random()
            if dice < 0.15:
                del file[name]
            elif dice < 0.3:
                change_attribute(draw, draw.choice([item, file]))
            elif dice < 0.35:
                other = draw.choice(names)
                del file[name]
                if other in file:
                    file[name] = file[other]
                else:
                    file[name] = h5py.SoftLink("/" + draw.choice([name, "nowhere"]))
            elif isinstance(item, h5py.Dataset) and dice < 0.6:
                reshape(draw, file, name)
            elif isinstance(item, h5py.Dataset):
                put_numbers(draw, item)


def resize(draw, old):
    """Another shape and type for a data set."""
    ways = {"empty": lambda n: 0, "short": lambda n: max(0, n - 1), "long": lambda n: n + 1}
    way = ways[draw.choice(sorted(ways))]
    at = draw.randrange(len(old.shape)) if old.shape else 0
    return tuple(way(n) if place == at else n for place, n in enumerate(old.shape)), old.dtype


def one_set(draw, file, name):
    """Damages one data set: no width, removed, one row less or more, another type, huge, a group or a link instead."""
    old, way = file[name], draw.choice(["width", "width", "gone", "type", "huge", "group", "scalar", "loop"])
    shape, dtype = resize(draw, old)
    attributes = dict(old.attrs)
    del file[name]
    if way == "gone":
        return
    if way == "group":
        new = file.create_group(name)
    elif way == "loop":
        file[name] = h5py.SoftLink("/" + name)
        return
    elif way == "huge":
        new = file.create_dataset(name, (2**40, *old.shape[1:]), dtype, chunks=(1024, *[max(1, n) for n in old.shape[1:]]))
    elif way == "scalar":
        new = file.create_dataset(name, (), dtype)
    elif way == "type":
        new = file.create_dataset(name, old.shape, draw.choice(["f8", "i4", "S5", h5py.string_dtype(), "c16", "u1"]))
    else:
        new = file.create_dataset(name, shape, dtype, maxshape=(None, *shape[1:]) if shape and draw.random() < 0.5 else None)
    for key, value in attributes.items():
        new.attrs[key] = value


def one_of_structure(draw, path):
    with h5py.File(path, "r+") as file:
        sets = [name for name in objects(file) if isinstance(file[name], h5py.Dataset)]
        if sets:
            one_set(draw, file, draw.choice(sets))


def damaged(seed, base, path):
    """The bytes of the file `base` after damage, which is done at `path`."""
    draw = random.Random(seed)
    shutil.copy(base, path)
    way = draw.choice([flip, flip, cut, restructure, restructure, one_of_structure, one_of_structure, one_of_structure])
    try:
        way(draw, path)
    except (OSError, KeyError, ValueError, TypeError, RuntimeError, OverflowError):
        pass  # h5py fails here; the damage so far is enough
    with open(path, "rb") as file:
        return file.read()
