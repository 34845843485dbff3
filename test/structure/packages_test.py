#!/usr/bin/python3
"""scripts/apt_packages.txt, the one list of apt packages, agrees with package.xml."""
import pathlib
import re
import unittest
import xml.etree.ElementTree

import rosunit

ROOT = pathlib.Path(__file__).resolve().parents[2]


def rows():
    """(key in package.xml, Debian's name, Noetic's name); the key is '-' for a tool."""
    lines = (ROOT / 'scripts/apt_packages.txt').read_text().splitlines()
    return [line.split() for line in lines if line and not line.startswith('#')]


def keysOfPackageXml():
    package = xml.etree.ElementTree.parse(ROOT / 'package.xml').getroot()
    return {element.text for element in package if element.tag.endswith('depend')}


class PackagesTest(unittest.TestCase):

    def testEveryRowIsWhole(self):
        for row in rows():
            self.assertEqual(len(row), 3, row)
            self.assertRegex(row[1], r'^[a-z0-9][a-z0-9.+-]+$')

    def testNoPackageIsListedTwice(self):
        names = [row[1] for row in rows()]
        self.assertEqual(len(names), len(set(names)))

    def testListAndPackageXmlNameTheSame(self):
        listed = {row[0] for row in rows()} - {'-'}
        self.assertEqual(listed, keysOfPackageXml())

    def testEveryKeyHasAPackageOnNoetic(self):
        named = {row[0] for row in rows() if row[2] != '-'}
        self.assertEqual(named - {'-'}, keysOfPackageXml())

    def testPythonModulesOfTheTestsAreListed(self):
        names = {row[1] for row in rows()}
        for path in (ROOT / 'test').rglob('*.py'):
            modules = re.findall(r'^(?:import|from) (yaml|ros\w+)', path.read_text(), re.MULTILINE)
            for module in modules:
                self.assertIn(f'python3-{module}', names, path)

    def testCommandsOfTheReadmeAreListed(self):
        commands = set(re.findall(r'^(ros\w+) ', (ROOT / 'README.md').read_text(), re.MULTILINE))
        self.assertIn('rosrun', commands)
        names = {row[1] for row in rows()}
        for command in commands:
            self.assertIn('rosbash' if command == 'rosrun' else f'python3-{command}', names)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'packages', PackagesTest)
