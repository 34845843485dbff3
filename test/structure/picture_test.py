#!/usr/bin/python3
"""render_map draws without a screen and says what is wrong with its input."""
import os
import pathlib
import struct
import subprocess
import tempfile
import unittest

import roslib.packages
import rosunit

HEADER = '''ply
format ascii 1.0
comment radius 0.25
element vertex {}
property float x
property float y
property float z
property float log_odds
end_header
'''


def render(atoms, *options):
    """Draws atoms, each (x, y, z, log_odds); the finished process and the picture's bytes."""
    with tempfile.TemporaryDirectory() as folder:
        ply, png = pathlib.Path(folder, 'atoms.ply'), pathlib.Path(folder, 'map.png')
        ply.write_text(HEADER.format(len(atoms)) + ''.join('{} {} {} {}\n'.format(*atom) for atom in atoms))
        program = roslib.packages.find_node('atom_mapping', 'render_map')[0]
        environment = {name: value for name, value in os.environ.items() if name != 'DISPLAY'}
        process = subprocess.run([program, ply, '--out', png, '--width', '320', '--height', '200', *options],
                                 env=environment, stderr=subprocess.PIPE, universal_newlines=True, timeout=120)
        return process, png.read_bytes() if png.exists() else b''


class PictureTest(unittest.TestCase):
    FLOOR = [(x / 2, y / 2, 0, 1) for x in range(40) for y in range(40)]

    def testDrawsAtomsWithoutAScreen(self):
        process, png = render(self.FLOOR)
        self.assertEqual((process.returncode, process.stderr), (0, ''))
        self.assertEqual(struct.unpack('>II', png[16:24]), (320, 200))
        background = render([(0, 0, 0, 1), (1e3, 0, 0, 1)])[1]  # atoms so far apart that they cannot be seen
        self.assertGreater(len(png), 5 * len(background))

    def testLeavesOutWhatIsFreeOrCut(self):
        expected = render(self.FLOOR)[1]
        more = self.FLOOR + [(5, 5, 1, -1), (6, 6, 3, 1)]
        self.assertEqual(render(more, '--cut-z', '2')[1], expected)

    def testSaysWhenThereIsNothingToDraw(self):
        process, png = render([(0, 0, 0, -1)])
        self.assertEqual((process.returncode, png), (2, b''))
        self.assertIn('no occupied atom', process.stderr)

    def testDrawsNoPngUnderAnotherName(self):
        with tempfile.TemporaryDirectory() as folder:
            ply, jpg = pathlib.Path(folder, 'atoms.ply'), pathlib.Path(folder, 'map.jpg')
            ply.write_text(HEADER.format(1) + '0 0 0 1\n')
            program = roslib.packages.find_node('atom_mapping', 'render_map')[0]
            process = subprocess.run([program, ply, '--out', jpg], stderr=subprocess.PIPE, universal_newlines=True)
            self.assertEqual((process.returncode, jpg.exists()), (2, False))
            self.assertIn('map.jpg: name a file that ends in .png', process.stderr)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'picture', PictureTest)
