#!/usr/bin/python3
"""What a script refuses or explains, it does so before it installs or builds anything."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

import rosunit

ROOT = pathlib.Path(__file__).resolve().parents[2]


def runAlone(script, *arguments):
    """Runs a script without setup.sh beside it, on which whatever goes beyond the arguments fails."""
    with tempfile.TemporaryDirectory() as folder:
        copy = shutil.copy(ROOT / 'scripts' / script, folder)
        return subprocess.run(['bash', copy, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              universal_newlines=True, cwd=folder, timeout=20)


class ScriptsTest(unittest.TestCase):

    def testHelpNeedsNoSetup(self):
        for script in ('demo.sh', 'reproduce_paper.sh'):
            with self.subTest(script):
                finished = runAlone(script, '--help')
                self.assertEqual((finished.returncode, finished.stderr), (0, ''))
                self.assertIn(f'Usage: scripts/{script}', finished.stdout)
                self.assertEqual(runAlone(script, '--no-such-option').returncode, 2)

    def testTheDemoOfABagThatIsNotThereSaysSo(self):
        for bag in ('none.bag', '/no/such/folder/none.bag', '/tmp'):
            with self.subTest(bag):
                finished = runAlone('demo.sh', '--bag', bag)
                self.assertEqual((finished.returncode, finished.stdout), (2, ''))
                self.assertRegex(finished.stderr, f'^demo.sh: there is no file /.*{pathlib.Path(bag).name}; give --bag ')

    def testEveryScriptParses(self):
        for script in sorted((ROOT / 'scripts').glob('*.sh')):
            self.assertEqual(subprocess.run(['bash', '-n', script]).returncode, 0, script)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'scripts', ScriptsTest)
