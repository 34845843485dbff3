#!/usr/bin/python3
"""draw_figures.py DATA OUTPUT: plots of the figures that scripts/reproduce_paper.sh left, as the paper's Fig. 1, 7, 8, 9."""
import math
import pathlib
import sys

import matplotlib

matplotlib.use('Agg')  # needs no screen
import matplotlib.pyplot as plt
from matplotlib.collections import PatchCollection
from matplotlib.patches import Circle, Rectangle
from matplotlib.ticker import FuncFormatter, LogLocator

from figures import COLORS, NAMES, mapNamed, read

MODES = ('atom_occupancy', 'atom_signed_distance', 'octomap')
OCCUPANCY_COLORS = plt.get_cmap('coolwarm')  # blue: free, red: occupied, as in the paper


def probability(log_odds):
    return math.nan if log_odds is None else 1.0 / (1.0 + math.exp(-log_odds))


def save(figure, output, name):
    figure.savefig(output / f'evaluation_{name}.png', dpi=100, bbox_inches='tight')
    plt.close(figure)


def addUnits(axes, units, makePatch, **style):
    """Draws those of the units that makePatch gives a shape."""
    shapes = [(makePatch(*unit), probability(unit[4])) for unit in units]
    shapes = [(patch, value) for patch, value in shapes if patch]
    patches = PatchCollection([patch for patch, _ in shapes], cmap=OCCUPANCY_COLORS, **style)
    patches.set_array([value for _, value in shapes])
    patches.set_clim(0.0, 1.0)
    axes.add_collection(patches)
    return patches


def cutAtom(x, y, z, size, _):
    square = size**2 / 4 - z**2
    return Circle((x, y), math.sqrt(square)) if square > 0.0 else None


def cutVoxel(x, y, z, size, _):
    return Rectangle((x - size / 2, y - size / 2), size, size) if abs(z) <= size / 2 else None


def drawSlice(data, output):
    """Fig. 1: atoms about a curved surface, what lies between them, and the voxels of the same scans."""
    contest = read(data, 'sphere_0')[0]
    atoms, voxels = mapNamed(contest, 'atom_occupancy'), mapNamed(contest, 'octomap')
    figure, panels = plt.subplots(1, 3, figsize=(13.5, 4.6), constrained_layout=True)
    addUnits(panels[0], atoms['unit_list'], cutAtom, edgecolor='k', linewidth=0.4)
    plane = atoms['slice']
    values = [[probability(value) for value in row] for row in plane['rows']]
    left, low = plane['min']
    extent = (left, left + plane['step'] * len(values[0]), low, low + plane['step'] * len(values))
    panels[1].imshow(values, origin='lower', extent=extent, cmap=OCCUPANCY_COLORS, vmin=0.0, vmax=1.0)
    patches = addUnits(panels[2], voxels['unit_list'], cutVoxel, edgecolor='k', linewidth=0.4)
    for axes, title in zip(panels, ('(a) atoms, cut by the plane', '(b) occupancy between them', '(c) OctoMap')):
        axes.add_patch(Circle((0.0, 0.0), 1.0, fill=False, linewidth=1.6))
        axes.set(title=title, xlim=(-1.3, 1.3), ylim=(-1.3, 1.3), aspect='equal', facecolor='#dddddd', xlabel='x (m)')
    figure.colorbar(patches, ax=panels, label='probability of occupancy', shrink=0.9)
    save(figure, output, 'slice')


def drawQuality(data, output):
    """Fig. 7 and 8: Q over the distance from the surface, and F, which the paper leaves out."""
    contests = [contest for noise in ('0', '0.01') for scene in ('cube', 'cube_rotated', 'sphere')
                for contest in read(data, f'{scene}_{noise}')]
    rows = len(contests) // 3
    figure, panels = plt.subplots(rows, 3, figsize=(13.5, 0.6 + 3.6 * rows), sharex=True, sharey=True, squeeze=False,
                                  constrained_layout=True)
    for axes, contest in zip(panels.flat, contests):
        for name in MODES:
            entry = mapNamed(contest, name)
            for key, line in (('Q', '-'), ('F', ':')):
                axes.errorbar(contest['epsilon'], entry[key], yerr=entry[key + '_error'], fmt=line, marker='.',
                              color=COLORS[name], label=f'{NAMES[name]}: {key}')
        axes.set(title=f"{contest['scene']}, r = {contest['radius']:g} m, noise {contest['noise']:g} m", ylim=(0.0, 1.0))
        axes.grid(alpha=0.3)
    for axes in panels[-1]:
        axes.set_xlabel('distance ε from the surface (m)')
    for axes in panels[:, 0]:
        axes.set_ylabel('share called free')
    handles, labels = panels[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, loc='lower center', ncol=6, bbox_to_anchor=(0.5, 1.0))
    save(figure, output, 'quality')


def drawGround(data, output):
    """Fig. 9: the ground from above, and how much of it maps keep."""
    slopes = read(data, 'ground')
    contest = next(each for each in slopes if each['slope'] == 10.0)
    figure, panels = plt.subplots(1, 3, figsize=(13.5, 4.4), constrained_layout=True)
    for axes, name in zip(panels, ('octomap', 'atom_occupancy')):
        units = [unit for unit in mapNamed(contest, name)['unit_list'] if unit[4] > 0.0]
        size = units[0][3]
        shapes = [Rectangle((x - size / 2, y - size / 2), size, size) if name == 'octomap' else Circle((x, y), size / 2)
                  for x, y, *_ in units]
        axes.add_collection(PatchCollection(shapes, facecolor=COLORS[name], edgecolor='k', linewidth=0.2))
        kind = f'{size:.2f} m voxels' if name == 'octomap' else f'r = {size / 2:g} m'
        axes.set(title=f"{NAMES[name]} ({kind}), {contest['slope']:g}° slope", xlim=(-8.0, 12.0), ylim=(-10.0, 10.0),
                 aspect='equal', xlabel='x, uphill (m)')
    for name in MODES:
        panels[2].plot([each['slope'] for each in slopes], [mapNamed(each, name)['ground_kept'] for each in slopes],
                       marker='.', color=COLORS[name], label=NAMES[name])
    panels[2].set(title='share of the observed ground that is kept', xlabel='slope (°)', ylim=(0.0, 1.02))
    panels[2].grid(alpha=0.3)
    panels[2].legend()
    save(figure, output, 'ground')


def drawTradeoff(data, output):
    """What the paper lacks: how true a map is next to surfaces for its time and its memory, over radii."""
    contests = read(data, 'tradeoff')
    epsilon = contests[0]['epsilon']
    costs = (('CPU time a scan (ms)', lambda entry: entry['cpu_ms_per_scan']), ('bytes', lambda entry: entry['bytes']))
    figure, panels = plt.subplots(2, 2, figsize=(13.5, 8.4), sharey='row', sharex='col', constrained_layout=True)
    for row, distance in zip(panels, (0.1, 0.25)):
        i = epsilon.index(distance)
        for axes, (label, cost) in zip(row, costs):
            for name in NAMES:
                entries = [mapNamed(contest, name) for contest in contests]
                truth = [0.5 * (entry['near_free'][i] + 1.0 - entry['near_false_free'][i]) for entry in entries]
                axes.plot([cost(entry) for entry in entries], truth, marker='o', color=COLORS[name], label=NAMES[name])
                for contest, entry, value in zip(contests, entries, truth):
                    size = contest['radius'] if name.startswith('atom') else contest['voxel']
                    if name != 'octomap_pruned':
                        axes.annotate(f'{size:.2g}', (cost(entry), value), textcoords='offset points', xytext=(4, 5),
                                      fontsize=8, color=COLORS[name])
            axes.set(xscale='log', title=f'within {distance:g} m of a surface')
            axes.margins(0.08, 0.1)
            axes.grid(alpha=0.3, which='both')
        row[0].set_ylabel('told rightly, mean of both sides')
    for axes, (label, _) in zip(panels[1], costs):
        axes.set_xlabel(label)
        axes.xaxis.set_major_locator(LogLocator(subs=(1.0, 3.0)))
        axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f'{value:,.0f}'))
    panels[1][0].legend()
    save(figure, output, 'tradeoff')


def drawGrowth(data, output):
    """What a scan costs as the map grows, which the paper does not show."""
    figure, axes = plt.subplots(figsize=(9.0, 3.6), constrained_layout=True)
    for name in ('atom_occupancy', 'atom_signed_distance'):
        for contest in read(data, f'growth_{name}'):
            steps = contest['steps']
            atoms = [step['atoms'] for step in steps]
            axes.plot(atoms, [step['cpu_ms_per_scan'] for step in steps], color=COLORS[name], label=f'{NAMES[name]}: mean')
            axes.plot(atoms, [step['cpu_ms_slowest'] for step in steps], ':', color=COLORS[name],
                      label=f'{NAMES[name]}: slowest of {contest["scans"]}')
    axes.set(xscale='log', xlabel='atoms in the map', ylabel='CPU time a scan (ms)')
    axes.set_ylim(bottom=0.0)
    axes.grid(alpha=0.3, which='both')
    axes.legend()
    save(figure, output, 'growth')


def main():
    data, output = (pathlib.Path(argument) for argument in sys.argv[1:])
    for draw in (drawSlice, drawQuality, drawGround, drawTradeoff, drawGrowth):
        draw(data, output)


if __name__ == '__main__':
    main()
