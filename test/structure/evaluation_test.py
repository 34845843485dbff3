#!/usr/bin/python3
"""docs/evaluation.md has a place for each table that scripts/reproduce_paper.sh makes, and its pictures exist."""
import json
import pathlib
import re
import shutil
import sys
import tempfile
import unittest

import rosunit

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / 'docs/evaluation.md'
sys.path.insert(0, str(ROOT / 'scripts/plots'))
sys.dont_write_bytecode = True
import write_tables  # noqa: E402


def figuresOf(name, milliseconds, size):
    shares = {key: 0.5 for key in ('free', 'false_occupied', 'unknown', 'surface')}
    return {'name': name, 'ms_per_scan': {'mean': milliseconds, 'p95': 9.0},
            'cpu_ms_per_scan': milliseconds, 'bytes': size, 'units': 7, **shares}


def write(folder):
    """Figures of one drive, of one slope, and what was run."""
    maps = [figuresOf('atom_occupancy', 2.0, 3e6), figuresOf('octomap', 8.0, 30e6),
            figuresOf('octomap_every_return', 20.0, 60e6)]
    (folder / 'compare_hall.json').write_text(json.dumps({'radius': 0.5, 'scans': 3, 'maps': maps}))
    (folder / 'ground.json').write_text(json.dumps({'slope': 10.0, 'maps': [{'name': 'octomap', 'ground_kept': 0.25}]}))
    (folder / 'run.txt').write_text('command: none\n')


class EvaluationTest(unittest.TestCase):

    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.addCleanup(shutil.rmtree, self.folder)

    def testItsPicturesExist(self):
        pictures = re.findall(r'!\[[^]]*\]\(([^)]+)\)', DOCUMENT.read_text())
        self.assertTrue(pictures)
        for picture in pictures:
            self.assertTrue((DOCUMENT.parent / picture).exists(), picture)

    def testTablesTakeTheirPlaces(self):
        write(self.folder)
        document = self.folder / 'evaluation.md'
        shutil.copy(DOCUMENT, document)
        for _ in range(2):  # the second time in the place of the first
            write_tables.fill(document, self.folder)
        text = document.read_text()
        self.assertEqual(text.count('- command: none\n'), 1)
        row = '| LBNL | hall | 0.5 | atoms, occupancy | 18.9 (0.94) | 3.000 (0.10) | 20.0 (1.52) | 2.00 (0.25) | 2.00 (0.25) |'
        self.assertEqual(text.count(row), 1)
        shares = '| hall | 3 | 0.5 | atoms, occupancy | 2.00 | 9.00 | 2.00 | 0.25 | 0.10 | 3,000 | 0.100 | 0.050 | 7 |'
        self.assertEqual(text.count(shares), 1)
        self.assertIn('| OctoMap | 0.250 |', text)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'evaluation', EvaluationTest)
