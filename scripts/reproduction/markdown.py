# SPDX-License-Identifier: AGPL-3.0-or-later
"""Words of Markdown, and numbers as text."""

import re


def table(head, rows):
    """The first column is text, all others are numbers."""
    lines = [head, ["---", *["--:"] * (len(head) - 1)], *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def picture(file, words):
    return f"![{words}](pictures/{file})"


def paragraph(text, width=140):
    """One paragraph, its lines broken at `width` characters."""
    lines = [""]
    for word in text.split():
        if lines[-1] and len(lines[-1]) + 1 + len(word) > width:
            lines.append("")
        lines[-1] += (" " if lines[-1] else "") + word
    return "\n".join(lines)


def page(parts):
    """Parts with an empty line between; those that begin like text are broken into lines."""
    is_text = re.compile(r"(?!```)[\w*`\[(\"]")
    blocks = [paragraph(part) if is_text.match(part) and "\n\n" not in part else part.strip("\n")
              for part in parts if part]
    return "\n\n".join(blocks) + "\n"


def count(number):
    return f"{number:,}"


def ratio(number):
    return f"{number:.2f}"


def per_cent(share):
    return f"{100 * share:.1f} %"


def short(number):
    """Three digits, thousands apart: 382, 23.8, 13,600, 0.00124."""
    if abs(number) >= 1000:
        digits = len(str(int(abs(number)))) - 3
        return f"{round(number, -digits):,.0f}"
    return f"{number:.3g}"


def exact(number):
    """532713.0 is 532,713; below a thousand three digits."""
    return f"{round(number):,}" if number >= 1000 else f"{number:.3g}"


def range_of(numbers, form):
    """ "1.5 to 2.4", or one number where all look the same."""
    low, high = form(min(numbers)), form(max(numbers))
    return low if low == high else f"{low} to {high}"


def mebibytes(size):
    return f"{size / 2**20:,.0f}"
