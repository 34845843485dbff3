#!/usr/bin/python3
"""Every launch file parses, with each of its options too, and starts only programs that exist; every YAML loads."""
import os
import pathlib
import unittest
import xml.etree.ElementTree

import roslaunch
import roslaunch.rlutil
import rosunit
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
LAUNCH_FILES = sorted((ROOT / 'launch').glob('*.launch'))
YAML_FILES = sorted((ROOT / 'config').rglob('*.yaml')) + sorted((ROOT / 'rviz').glob('*.rviz'))


def argumentsOf(launch_file):
    """Names of the arguments that a caller may set, with their defaults."""
    elements = xml.etree.ElementTree.parse(launch_file).getroot().iter('arg')
    return {element.get('name'): element.get('default') for element in elements if element.get('default') is not None}


def nodesOf(launch_file, **arguments):
    given = [f'{name}:={value}' for name, value in arguments.items()]
    config = roslaunch.config.load_config_default([(str(launch_file), given)], port=11311, verbose=False)
    assert not config.config_errors, config.config_errors
    return {node.name: node for node in config.nodes}


class LaunchTest(unittest.TestCase):

    def testThereIsSomethingToTest(self):
        self.assertTrue(LAUNCH_FILES)
        self.assertTrue(YAML_FILES)

    def testLaunchFilesStartWhatExists(self):
        for launch_file in LAUNCH_FILES:
            with self.subTest(launch_file.name):
                self.assertIsNone(roslaunch.rlutil.check_roslaunch(str(launch_file)))

    def testLaunchFilesParseWithEachSwitchTurned(self):
        opposite = {'true': 'false', 'false': 'true'}
        for launch_file in LAUNCH_FILES:
            for name, default in argumentsOf(launch_file).items():
                with self.subTest(f'{launch_file.name} {name}'):
                    if default in opposite:
                        nodesOf(launch_file, **{name: opposite[default]})

    def testABagIsPlayedOnlyWhenGiven(self):
        launch_file = ROOT / 'launch/atom_mapping.launch'
        self.assertNotIn('rosbag', {node.package for node in nodesOf(launch_file).values()})
        played = [node for node in nodesOf(launch_file, bag='/tmp/some.bag').values() if node.package == 'rosbag']
        self.assertEqual(len(played), 1)
        self.assertIn('--clock', played[0].args)

    def testARelativeMapStartsWhereRoslaunchWasCalled(self):
        def loaded(**arguments):
            given = [f'{name}:={value}' for name, value in arguments.items()]
            launch_file = str(ROOT / 'launch/atom_mapping.launch')
            config = roslaunch.config.load_config_default([(launch_file, given)], port=11311, verbose=False)
            parameter = config.params.get('/atom_mapping/storage/load')
            return parameter and parameter.value
        self.assertEqual(loaded(), '')
        self.assertEqual(loaded(map='/tmp/map.h5'), '/tmp/map.h5')
        self.assertEqual(loaded(map='map.h5'), f'{os.environ["PWD"]}/map.h5')

    def testNodesBearTheNamesOfTheirServices(self):
        nodes = nodesOf(ROOT / 'launch/atom_mapping.launch')
        self.assertEqual(nodes['atom_mapping'].type, 'atom_mapping_node')
        nodes = nodesOf(ROOT / 'launch/compare.launch', bag='/tmp/some.bag', radius='0.5', resolution='0.4')
        self.assertEqual(nodes['atom_mapping'].type, 'atom_mapping_node')
        self.assertEqual(nodes['octomap_baseline'].type, 'octomap_baseline_node')
        self.assertEqual(sorted(nodes), ['atom_mapping', 'octomap_baseline', 'player', 'rviz'])

    def testYamlFilesLoad(self):
        for path in YAML_FILES:
            with self.subTest(path.name):
                self.assertIsInstance(yaml.safe_load(path.read_text()), dict)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'launch', LaunchTest)
