"""Numbers and tables in Markdown."""

# Title and name in JSON of the figures that the tables show.
COLUMNS = (("V", "v"), ("C", "completeness"), ("H", "homogeneity"), ("recall", "recall"),
           ("precision", "precision"), ("IoU", "iou"), ("ARI", "ari"),
           ("strict V", "strict_v"))


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def percent(share, digits=2):
    return "%.*f" % (digits, 100.0 * share)


def setting(config):
    """The options of `roomseg bench` that make a configuration."""
    return " ".join("`%s=%d`" % item for item in config.items())


def verdict(met):
    return "met" if met else "**missed**"


def table(header, rows, text_columns=1):
    """The first columns hold text, the others numbers."""
    lines = ["| " + " | ".join(header) + " |",
             "|" + "---|" * text_columns + "---:|" * (len(header) - text_columns)]
    lines += ["| " + " | ".join(row) + " |" for row in rows]
    return "\n".join(lines) + "\n"
