"""Labels of several runs: the scenario's name, and what tells runs of one scenario apart."""
import os
import re
from typing import Any, Dict, Iterator, List, Tuple

from train_viz.resolved_scenario import read_value

MOST_KEYS = 2      # chosen: more values make a label nobody reads
LONGEST_VALUE = 16  # chosen: letters; a table or a description is no label

Source = Tuple[str, str, str]  # scenario's name, its resolved text, bag


def labels_of(sources: List[Source]) -> List[str]:
    """One for each run, all different: of runs of one scenario with the values that differ, as those of a sweep; if these are many,
    with the bag's or the folder's name; if need be a number is added."""
    names = [scenario or 'unnamed' for scenario, _, _ in sources]
    groups = {name: [source for source, other in zip(sources, names) if other == name] for name in names}
    apart = {name: iter(_values([text for _, text, _ in group]) or _paths([path for _, _, path in group]))
             for name, group in groups.items()}
    return [f'{name} ({next(apart[name])})' if len(groups[name]) > 1 else name for name in names]


def file_name(label: str) -> str:
    return re.sub(r'[^A-Za-z0-9.-]+', '_', label).strip('_')


def _values(texts: List[str]) -> List[str]:
    """The values that differ among scenarios with their keys, shortened; none if they do not tell the runs apart."""
    if len(set(texts)) < len(texts):
        return []
    flat = [dict(_leaves(read_value(text))) for text in texts]
    keys = [key for key in {key: None for values in flat for key in values}
            if key != ('description',) and len({values.get(key, '-') for values in flat}) > 1]
    values = [[those.get(key, '-') for key in keys] for those in flat]
    if not 1 <= len(keys) <= MOST_KEYS or max(len(value) for those in values for value in those) > LONGEST_VALUE:
        return []
    words = _short(keys)
    labels = [', '.join(f'{words[key]} {value}' for key, value in zip(keys, those)) for those in values]
    return labels if len(set(labels)) == len(labels) else []


def _leaves(node: Any, path: Tuple[str, ...] = ()) -> Iterator[Tuple[Tuple[str, ...], str]]:
    """Path and text of every value that is no map and no list."""
    if isinstance(node, (dict, list)):
        for key, value in node.items() if isinstance(node, dict) else enumerate(node):
            yield from _leaves(value, (*path, str(key)))
    else:
        yield path, str(node)


def _short(keys: List[Tuple[str, ...]]) -> Dict[Tuple[str, ...], str]:
    """The last names of paths, as many as tell them apart."""
    for count in range(1, max(map(len, keys)) + 1):
        words = {key: '.'.join(key[-count:]) for key in keys}
        if len(set(words.values())) == len(keys):
            break
    return words


def _paths(paths: List[str]) -> List[str]:
    """What tells bags apart: their names, or the folders', or both, or a number."""
    paths = [os.path.abspath(path) for path in paths]
    stems = [os.path.basename(path).rsplit('.bag', 1)[0] for path in paths]
    folders = [os.path.basename(os.path.dirname(path)) for path in paths]
    both = [f'{folder}/{stem}' for folder, stem in zip(folders, stems)]
    for names in (stems, folders, both):
        if len(set(names)) == len(names):
            return names
    return [f'{name} #{i}' for i, name in enumerate(both, start=1)]
