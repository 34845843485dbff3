"""The figures that scripts/reproduce_paper.sh leaves in a folder, and how maps are called and coloured."""
import json

NAMES = {
    'atom_occupancy': 'atoms, occupancy',
    'atom_signed_distance': 'atoms, signed distance',
    'octomap': 'OctoMap',
    'octomap_pruned': 'OctoMap, pruned',
    'octomap_every_return': 'OctoMap, every return',
}
COLORS = {
    'atom_occupancy': '#c0392b',
    'atom_signed_distance': '#e08e0b',
    'octomap': '#2c6fbb',
    'octomap_pruned': '#7fb2e5',
    'octomap_every_return': '#1b3a5c',
}


def read(folder, name):
    """What a program wrote as a list, since of a single radius it is an object alone; empty where there is nothing."""
    path = folder / f'{name}.json'
    if not path.exists():
        return []
    content = json.loads(path.read_text())
    return content if isinstance(content, list) else [content]


def mapNamed(contest, name):
    return next(entry for entry in contest['maps'] if entry['name'] == name)
