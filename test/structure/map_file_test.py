#!/usr/bin/python3
"""The README's Python reads a map file, and map_info says what is in one."""
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

import roslib.packages
import rosunit

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(program, *arguments):
    path = roslib.packages.find_node('atom_mapping', program)[0]
    return subprocess.run([path, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, universal_newlines=True,
                          timeout=120)


class MapFileTest(unittest.TestCase):

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.before = os.getcwd()
        os.chdir(cls.folder.name)
        assert run('simulate_bag', '--scene', 'cube', '--scans', '3', '--out', 'cube.bag').returncode == 0
        mapped = run('atom_mapping_offline', '--bag', 'cube.bag', '--save', 'map.h5', '--export', 'atoms.csv')
        assert mapped.returncode == 0, mapped.stderr
        rows = pathlib.Path('atoms.csv').read_text().splitlines()[1:]
        cls.atoms = [[float(word) for word in row.split(',')] for row in rows]

    @classmethod
    def tearDownClass(cls):
        os.chdir(cls.before)
        cls.folder.cleanup()

    def testTheReadmesPythonReadsIt(self):
        code = re.search(r'```python\n(import h5py.*?)```', (ROOT / 'README.md').read_text(), re.DOTALL).group(1)
        names = {}
        exec(code, names)
        self.assertEqual(names['radius'], 0.25)
        self.assertEqual(len(names['centers']), len(self.atoms))
        for center, (x, y, z, *_) in zip(names['centers'].tolist(), self.atoms):
            for mine, exported in zip(center, (x, y, z)):
                self.assertAlmostEqual(mine, exported, delta=1e-4)
        self.assertEqual(len(names['occupied']), sum(atom[4] > 0 for atom in self.atoms))

    def testMapInfoTellsWhatItHolds(self):
        info = run('map_info', 'map.h5')
        self.assertEqual((info.returncode, info.stderr), (0, ''))
        told = dict(re.findall(r'^ *(\S+) +(.*)$', info.stdout, re.MULTILINE))
        self.assertEqual(told['atoms'], str(len(self.atoms)))
        self.assertEqual(told['occupied'], str(sum(atom[4] > 0 for atom in self.atoms)))
        self.assertEqual(told['scans'], '3')
        self.assertEqual((told['radius'], told['mode'], told['map_frame']), ('0.25', 'occupancy', 'map'))

    def testMapInfoRefusesADamagedFile(self):
        damaged = bytearray(pathlib.Path('map.h5').read_bytes())
        damaged[3000] ^= 1
        pathlib.Path('damaged.h5').write_bytes(damaged)
        info = run('map_info', 'damaged.h5')
        self.assertEqual((info.returncode, info.stdout), (2, ''))
        self.assertIn('cannot load damaged.h5: it is damaged', info.stderr)

    def testAMapIsMergedWithItselfHereAndElsewhere(self):
        merged = run('merge_maps', 'map.h5', 'map.h5', '--out', 'merged.h5')
        self.assertEqual((merged.returncode, merged.stderr), (0, ''))
        self.assertIn(f'merged.h5: {len(self.atoms)} atoms, 0 of them from map.h5', merged.stdout)
        far = run('merge_maps', 'map.h5', 'map.h5', '--transform', '1000', '0', '0', '0', '0', '90', '--out', 'far.h5')
        self.assertIn(f'far.h5: {2 * len(self.atoms)} atoms', far.stdout)
        self.assertIn(f'atoms {2 * len(self.atoms)}', re.sub(' +', ' ', run('map_info', 'far.h5').stdout))

    def testMapsOfDistancesAreMergedTooButOnlyWithTheirLike(self):
        mapped = run('atom_mapping_offline', '--bag', 'cube.bag', '--mode', 'signed_distance', '--save', 'distances.h5')
        self.assertEqual(mapped.returncode, 0, mapped.stderr)
        merged = run('merge_maps', 'distances.h5', 'distances.h5', '--out', 'merged.h5')
        self.assertEqual((merged.returncode, merged.stderr), (0, ''))
        self.assertIn(' atoms, 0 of them from distances.h5, ', merged.stdout)
        self.assertIn('signed_distance', run('map_info', 'merged.h5').stdout)
        refused = run('merge_maps', 'map.h5', 'distances.h5', '--out', 'no.h5')
        self.assertEqual((refused.returncode, pathlib.Path('no.h5').exists()), (2, False))
        self.assertIn('name two of one mode', refused.stderr)

    def testAMergedMapKeepsWithinTheLimitsOfTheFirst(self):
        for policy in ('refuse', 'forget_farthest'):
            pathlib.Path('limits.yaml').write_text(f'limits: {{max_atoms: {len(self.atoms)}, policy: {policy}}}')
            mapped = run('atom_mapping_offline', '--bag', 'cube.bag', '--config', 'limits.yaml', '--save', f'{policy}.h5')
            self.assertEqual(mapped.returncode, 0, mapped.stderr)
        apart = ('--transform', '1000', '0', '0', '0', '0', '0', '--out', 'limited.h5')
        refused = run('merge_maps', 'refuse.h5', 'map.h5', *apart)
        self.assertEqual((refused.returncode, pathlib.Path('limited.h5').exists()), (2, False))
        self.assertIn(f'its {2 * len(self.atoms)} atoms (', refused.stderr)
        self.assertIn(f'are more than limits/max_atoms {len(self.atoms)} ', refused.stderr)
        cut = run('merge_maps', 'forget_farthest.h5', 'map.h5', *apart)
        self.assertEqual(cut.returncode, 0, cut.stderr)
        atoms, forgotten = map(int, re.search(r': (\d+) atoms, .* left no room for (\d+)$', cut.stdout.strip()).groups())
        self.assertLessEqual(atoms, len(self.atoms))
        self.assertEqual(atoms + forgotten, 2 * len(self.atoms))

    def testMapsAreSavedUnderTheirEndingOnly(self):
        for arguments in (('atom_mapping_offline', '--bag', 'cube.bag', '--save', 'map.ply'),
                          ('merge_maps', 'map.h5', 'map.h5', '--out', 'map.ply'), ('grow_map', '--save', 'map.ply')):
            refused = run(*arguments)
            self.assertEqual((refused.returncode, refused.stdout, pathlib.Path('map.ply').exists()), (2, '', False))
            self.assertIn('cannot write map.ply: name a file that ends in .h5', refused.stderr)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'map_file', MapFileTest)
