"""The label checksums in README.md and docs/embedded.md: one row a map, one column a way to run.
They stand between two comments; rows of maps that are not here (the optional data set) stay as
they are."""

import re

import emulate

FILES = ("README.md", "docs/embedded.md")
VARIANTS = ("default", "aligned", "paper")
BLOCK = re.compile(r"(?<=<!-- checksums: tests/embedded/run\.py --update -->\n).*?"
                   r"(?=<!-- end of checksums -->)", re.S)
ROW = re.compile(r"^\| (\w+) \|(?: `\w+` \|)+$", re.M)


def row(runs, name):
    """A map's line, None if the map was not run."""
    crcs = [emulate.label_crc(runs[(name, variant)][0]) for variant in VARIANTS
            if (name, variant) in runs]
    return f"| {name} | {' | '.join(f'`{crc}`' for crc in crcs)} |" if crcs else None


def renew(runs, text, name):
    """The text with the checksums of these runs."""
    block = BLOCK.search(text)
    if not block:
        raise emulate.Failure(f"{name} has no table of checksums")
    return text[:block.start()] + ROW.sub(lambda found: row(runs, found[1]) or found[0],
                                          block[0]) + text[block.end():]


def missing(runs, targets, text):
    """Maps and targets that the table of docs/embedded.md must name, and does not."""
    names = {name for name, _ in runs} | {target.name for target in targets}
    return sorted(name for name in names
                  if f"| {name} |" not in text and f"`{name}`" not in text)


def kept(runs, text):
    """Maps of the table that were not run: their checksums cannot be compared or written."""
    names = {name for name, _ in runs}
    return [name for name in ROW.findall(BLOCK.search(text)[0]) if name not in names]


def check(runs, targets, update):
    """Prints what is stale; with update, writes it anew. Returns whether all is well."""
    good = True
    for name in FILES:
        file = emulate.ROOT / name
        text = file.read_text(encoding="utf-8")
        fresh = renew(runs, text, name)
        if fresh != text and update:
            file.write_text(fresh, encoding="utf-8")
            print(f"written    {name}")
        elif fresh != text:
            good = False
            print(f"STALE      {name}: checksums; tests/embedded/run.py --update", flush=True)
    absent = missing(runs, targets, fresh)
    if kept(runs, fresh):
        print(f"not run    {', '.join(kept(runs, fresh))}: no data set (--dataset)", flush=True)
    if absent:
        good = False
        print(f"STALE      {FILES[-1]}: not named: {', '.join(absent)}", flush=True)
    return good
