"""Template of a self-contained HTML page: sections of text, tables and pictures; opens offline, loads nothing.

Knows nothing of trains. Text given to it is escaped; pieces that the functions here return are HTML.
"""
import base64
import dataclasses
import html
from typing import List, Sequence

STYLE = '''
body { font: 16px/1.5 "DejaVu Sans", Verdana, sans-serif; color: #1a1a1a; background: #fff; margin: 0 auto; padding: 1.5rem;
       max-width: 74rem; }
h1 { font-size: 1.7rem; line-height: 1.25; margin: 0.5rem 0; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 0.6rem; border-bottom: 2px solid #0072B2; padding-bottom: 0.2rem; }
p, ul { max-width: 52rem; margin: 0.6rem 0; }
nav { font-size: 0.92rem; margin: 0.8rem 0; }
nav a { margin-right: 1.2rem; white-space: nowrap; }
a { color: #0072B2; }
.scroll { overflow-x: auto; background: linear-gradient(to right, #fff 30%, transparent) 0 / 3rem 100% local no-repeat,
          linear-gradient(to left, #fff 30%, transparent) 100% / 3rem 100% local no-repeat,
          linear-gradient(to right, #0004, transparent) 0 / 0.8rem 100% scroll no-repeat,
          linear-gradient(to left, #0004, transparent) 100% / 0.8rem 100% scroll no-repeat; }
table { border-collapse: collapse; font-size: 0.92rem; margin: 0.8rem 0; }
th, td { padding: 0.28rem 0.7rem; border-bottom: 1px solid #ddd; text-align: right; vertical-align: top; }
th { border-top: 2px solid #0072B2; vertical-align: bottom; }
th.text, td.text { text-align: left; }
td { font-variant-numeric: tabular-nums; white-space: nowrap; }
td.text { white-space: normal; }
table.even td:nth-child(1) { white-space: nowrap; }
tbody tr:hover { background: #f7f7f2; }
table.even { width: 100%; table-layout: fixed; min-width: 59rem; }
table.even th:nth-child(1) { width: 19%; }
table.even th:nth-child(2) { width: 14%; }
table.even th:nth-child(3) { width: 6.5%; }
table.even th:nth-child(4) { width: 7.5%; }
table.even th:nth-child(5) { width: 12.5%; }
table.even th:nth-child(6) { width: 12%; }
table.even th:nth-child(7) { width: 10.5%; }
table.even th:nth-child(8) { width: 18%; }
.badge { display: inline-block; border-radius: 0.7em; padding: 0 0.6em; white-space: nowrap; background: #e4e4e4;
         border: 1px solid #e4e4e4; }
.badge.outlined { background: #fff; border-color: #777; }
.notice { border-left: 5px solid #E69F00; background: #fdf6e3; padding: 0.6rem 1rem; max-width: 52rem; margin: 0.8rem 0; }
figure { margin: 1.2rem 0 2rem; }
figure img { max-width: 100%; height: auto; }
figcaption { font-size: 0.92rem; color: #444; max-width: 52rem; }
pre { background: #f5f5f5; padding: 0.7rem; overflow-x: auto; font-size: 0.85rem; line-height: 1.35; }
details { margin: 0.4rem 0; }
summary { cursor: pointer; color: #0072B2; }
footer { margin-top: 3rem; font-size: 0.85rem; color: #555; border-top: 1px solid #ddd; padding-top: 0.6rem; }
@media (max-width: 64rem) {
  body { padding: 1rem; }
  table { font-size: 0.82rem; }
  th, td { padding: 0.25rem 0.4rem; }
  table.even { table-layout: auto; min-width: 0; }
  table.even td { white-space: normal; }
  table.even td:nth-child(1) { white-space: normal; }
  table.even th:nth-child(n) { width: auto; }
}
@media print { body { max-width: none; } details { display: none; } }
'''


@dataclasses.dataclass(frozen=True)
class Section:
    """A heading and its HTML."""
    title: str
    pieces: Sequence[str]


def make_page(title: str, lead: Sequence[str], sections: List[Section], footer: str) -> str:
    """@param lead HTML between title and contents"""
    links = ' '.join(f'<a href="#s{i}">{html.escape(section.title)}</a>' for i, section in enumerate(sections, start=1))
    bodies = '\n'.join(f'<section id="s{i}">\n<h2>{html.escape(section.title)}</h2>\n' + '\n'.join(section.pieces) +
                       '\n</section>' for i, section in enumerate(sections, start=1))
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f'<meta name="viewport" content="width=device-width, initial-scale=1">\n<title>{html.escape(title)}</title>\n'
            f'<style>{STYLE}</style>\n</head>\n<body>\n<h1>{html.escape(title)}</h1>\n' + '\n'.join(lead) +
            f'\n<nav>{links}</nav>\n{bodies}\n<footer>{html.escape(footer)}</footer>\n</body>\n</html>\n')


def paragraph(text: str) -> str:
    return f'<p>{html.escape(text)}</p>'


def bullets(texts: Sequence[str]) -> str:
    return '<ul>' + ''.join(f'<li>{html.escape(text)}</li>' for text in texts) + '</ul>'


def notice(text: str) -> str:
    """What the reader must not miss."""
    return f'<div class="notice">{html.escape(text)}</div>'


def code(text: str) -> str:
    return f'<pre>{html.escape(text)}</pre>'


def folded(title: str, text: str) -> str:
    """Long text that opens on a click."""
    return f'<details><summary>{html.escape(title)}</summary>{code(text)}</details>'


@dataclasses.dataclass(frozen=True)
class Badge:
    """A table cell that names a kind, filled or `outlined`; neither is better."""
    text: str
    outlined: bool = False


def table(header: Sequence[str], rows: Sequence[Sequence], text_columns: Sequence[int] = (0,), style: str = '') -> str:
    """Cells are texts or Badges; numbers to the right, columns of text to the left.

    @param style a class of STYLE; `even`: as wide as the page, so that tables below each other line up
    """
    def line(cells: Sequence, tag: str) -> str:
        kinds = [' class="text"' if i in text_columns else '' for i in range(len(cells))]
        return '<tr>' + ''.join(f'<{tag}{kind}>{_cell(cell)}</{tag}>' for kind, cell in zip(kinds, cells)) + '</tr>'

    for row in rows:
        assert len(row) == len(header), row
    body = '\n'.join(line(row, 'td') for row in rows)
    head = line(header, 'th')
    return (f'<div class="scroll"><table class="{style}">\n<thead>{head}</thead>\n<tbody>\n{body}\n</tbody>\n'
            '</table></div>')


def _cell(cell) -> str:
    if isinstance(cell, Badge):
        return f'<span class="badge{" outlined" if cell.outlined else ""}">{html.escape(cell.text)}</span>'
    return html.escape(cell)


def picture(path: str, alternative: str, caption: str = '') -> str:
    """Embeds a PNG file; 0.6 points a pixel, so that its text is as large as the page's."""
    with open(path, 'rb') as file:
        data = file.read()
    width = int.from_bytes(data[16:20], 'big')  # of the PNG's header
    text = f'<figcaption>{html.escape(caption)}</figcaption>' if caption else ''
    return (f'<figure><img alt="{html.escape(alternative)}" style="width: {width * 0.6:.0f}px" src="data:image/png;base64,'
            f'{base64.b64encode(data).decode()}">{text}</figure>')
