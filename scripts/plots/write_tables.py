#!/usr/bin/python3
"""Tables of the figures that scripts/reproduce_paper.sh left: to stdout, or into the marked places of a document.

A place is what lies between the lines `<!-- table NAME -->` and `<!-- end -->`.
"""
import argparse
import pathlib
import re

from figures import NAMES, mapNamed, read

# Paper, Table I: (radius, OctoMap, atoms in occupancy mode, in signed distance mode), MB and ms.
PAPER = {
    'campus': ('CMU', {0.5: ((26.4, 32.3, 24.4), (34.7, 56.2, 28.8)), 1.0: ((18.0, 15.7, 13.9), (10.5, 14.4, 10.1))}),
    'hall': ('LBNL', {0.5: ((20.2, 18.9, 16.8), (13.2, 20.0, 13.0)), 1.0: ((12.1, 12.1, 11.6), (3.6, 5.7, 4.3))}),
}
IN_PAPER = ('octomap', 'atom_occupancy', 'atom_signed_distance')
DRIVES = ('campus', 'hall', 'handheld', 'street', 'vlp16_room', 'vlp16_dual_return')


def table(header, rows):
    lines = [header, ['---'] * len(header), *rows]
    return '\n'.join('| ' + ' | '.join(str(cell) for cell in line) + ' |' for line in lines)


def mean(entry):
    return entry['ms_per_scan']['mean']


def cpu(entry):
    return entry['cpu_ms_per_scan']


def megabytes(entry):
    return entry['bytes'] / 1e6


def share(value):
    return '' if value is None else f'{value:.4f}'


def tableOne(data):
    """Table I, the paper's figures beside ours; in brackets how they stand to OctoMap's."""
    rows = []
    for drive, (dataset, by_radius) in PAPER.items():
        for contest in read(data, f'compare_{drive}'):
            theirs = dict(zip(IN_PAPER, zip(*by_radius[contest['radius']])))
            baseline = mapNamed(contest, 'octomap')
            for entry in contest['maps']:
                ours = [(megabytes, '.3f'), (mean, '.2f'), (cpu, '.2f')]
                cells = [f'{of(entry):{digits}} ({of(entry) / of(baseline):.2f})' for of, digits in ours]
                paper = ['', '']
                if entry['name'] in theirs:
                    paper = [f'{value} ({value / base:.2f})' for value, base in zip(theirs[entry['name']], theirs['octomap'])]
                rows.append([dataset, drive, contest['radius'], NAMES[entry['name']], paper[0], cells[0], paper[1], *cells[1:]])
    return table(['paper\'s data', 'ours', 'r (m)', 'map', 'paper MB', 'ours MB', 'paper ms', 'ours ms', 'ours CPU ms'], rows)


def drives(data):
    rows = []
    for drive in DRIVES:
        for contest in read(data, f'compare_{drive}') + read(data, f'fine_{drive}'):
            baseline, every_return = mapNamed(contest, 'octomap'), mapNamed(contest, 'octomap_every_return')
            for entry in contest['maps']:
                time = entry['ms_per_scan']
                rows.append([
                    drive, contest['scans'], contest['radius'], NAMES[entry['name']], f"{time['mean']:.2f}",
                    f"{time['p95']:.2f}", f'{cpu(entry):.2f}', f'{cpu(entry) / cpu(baseline):.2f}',
                    f'{cpu(entry) / cpu(every_return):.2f}', f"{entry['bytes'] / 1e3:,.0f}",
                    f"{entry['bytes'] / baseline['bytes']:.3f}", f"{entry['bytes'] / every_return['bytes']:.3f}",
                    f"{entry['units']:,}",
                    *(share(entry[key]) for key in ('free', 'false_occupied', 'unknown', 'surface'))])
    return table(['bag', 'scans', 'r (m)', 'map', 'ms', '95 %', 'CPU ms', 'of OctoMap\'s', 'of every return\'s', 'kB', 'of OctoMap\'s',
                  'of every return\'s', 'units', 'free', 'falsely occupied', 'unknown', 'surface'], rows)


def quality(data):
    """Eq. (13) at half a radius and a radius."""
    rows = []
    for scene in ('cube', 'cube_rotated', 'sphere'):
        for noise in ('0', '0.01'):
            for contest in read(data, f'{scene}_{noise}'):
                epsilon = contest['epsilon']
                half, whole = (epsilon.index(min(epsilon, key=lambda e: abs(e - share * contest['radius'])))
                               for share in (0.5, 1.0))
                for entry in contest['maps']:
                    rows.append([scene, noise, NAMES[entry['name']], *(f'{entry[key][i]:.3f}' for key, i in
                                 (('Q', half), ('Q', whole), ('F', half), ('F', whole)))])
    return table(['scene', 'noise (m)', 'map', 'Q at r/2', 'Q at r', 'F at r/2', 'F at r'], rows)


def coverage(data):
    rows = []
    for scene in ('hall', 'campus'):
        for contest in read(data, f'coverage_{scene}'):
            for entry in contest['maps']:
                rows.append([scene, contest['radius'], NAMES[entry['name']], f"{entry['units']:,}",
                             *(share(entry.get(key)) for key in ('free', 'false_occupied', 'unknown', 'surface', 'thin'))])
    return table(['scene', 'r (m)', 'map', 'units', 'free', 'falsely occupied', 'unknown', 'surface', 'thin'], rows)


def ground(data):
    contests = read(data, 'ground')
    names = [entry['name'] for entry in contests[0]['maps']]
    rows = [[NAMES[name], *(f"{mapNamed(contest, name)['ground_kept']:.3f}" for contest in contests)] for name in names]
    return table(['slope', *(f"{contest['slope']:g}°" for contest in contests)], rows)


def growth(data):
    """The copies of the scene at whose ends the map first held so many atoms."""
    rows = []
    for name in IN_PAPER[1:]:
        for contest in read(data, f'growth_{name}'):
            for least in (1e5, 1e6, 1e7):
                step = next((step for step in contest['steps'] if step['atoms'] >= least), None)
                if step:
                    rows.append([NAMES[name], f"{step['atoms']:,}", f"{step['bytes'] / step['atoms']:.1f}",
                                 *(f'{step[key]:.2f}' for key in ('cpu_ms_per_scan', 'cpu_ms_p95', 'cpu_ms_slowest'))])
    return table(['map', 'atoms', 'bytes an atom', 'CPU ms a scan', '95 %', 'slowest'], rows)


def described(data):
    """What was run, and where."""
    return '\n'.join(f'- {line}' for line in (data / 'run.txt').read_text().splitlines())


TABLES = {'run': described, 'paper': tableOne, 'drives': drives, 'quality': quality, 'coverage': coverage, 'ground': ground,
          'growth': growth}


def fill(document, data):
    text = document.read_text()
    for name, make in TABLES.items():
        place = re.compile(rf'(<!-- table {name} -->\n).*?(<!-- end -->)', re.DOTALL)
        text, count = place.subn(lambda found: f'{found.group(1)}\n{make(data)}\n\n{found.group(2)}', text)
        assert count == 1, f'{document} has {count} places for the table {name}'
    document.write_text(text)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument('data', type=pathlib.Path)
    parser.add_argument('--into', type=pathlib.Path, help='document whose tables to replace')
    arguments = parser.parse_args()
    if arguments.into:
        fill(arguments.into, arguments.data)
    else:
        print('\n\n'.join(make(arguments.data) for make in TABLES.values()))


if __name__ == '__main__':
    main()
