#!/usr/bin/python3
"""Every launch file parses, with each of its options too, and starts only programs that exist; every YAML loads."""
import os
import pathlib
import shlex
import subprocess
import tempfile
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


def configOf(launch_file, **arguments):
    given = [f'{name}:={value}' for name, value in arguments.items()]
    config = roslaunch.config.load_config_default([(str(launch_file), given)], port=11311, verbose=False)
    assert not config.config_errors, config.config_errors
    return config


def nodesOf(launch_file, **arguments):
    return {node.name: node for node in configOf(launch_file, **arguments).nodes}


def parametersOf(launch_file, **arguments):
    return {name: parameter.value for name, parameter in configOf(launch_file, **arguments).params.items()}


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
        for name in ('atom_mapping', 'compare', 'demo'):
            def loaded(**arguments):
                return parametersOf(ROOT / f'launch/{name}.launch', **arguments)['/atom_mapping/storage/load']
            with self.subTest(name):
                self.assertEqual(loaded(), '')
                self.assertEqual(loaded(map='/tmp/map.h5'), '/tmp/map.h5')
                self.assertEqual(loaded(map='map.h5'), f'{os.environ["PWD"]}/map.h5')

    def testAConfigIsTakenByEveryLaunchFile(self):
        with tempfile.NamedTemporaryFile('w', suffix='.yaml') as config:
            config.write('radius: 0.7\npublish: {color: distance}\n')
            config.flush()
            for name, argument, node in (('atom_mapping', 'config', 'atom_mapping'), ('demo', 'config', 'atom_mapping'),
                                         ('compare', 'config', 'atom_mapping'),
                                         ('compare', 'octomap_config', 'octomap_baseline'),
                                         ('octomap_baseline', 'config', 'octomap_baseline')):
                with self.subTest(f'{name} {argument}'):
                    given = parametersOf(ROOT / f'launch/{name}.launch', **{argument: config.name})
                    self.assertEqual(given[f'/{node}/radius'], 0.7)
                    self.assertEqual(given[f'/{node}/publish/color'], 'distance')

    def testNoNodeInheritsTheParametersOfAnEarlierLaunch(self):
        for launch_file in LAUNCH_FILES:
            for name in {'atom_mapping', 'octomap_baseline'} & set(nodesOf(launch_file)):
                with self.subTest(f'{launch_file.name} {name}'):
                    self.assertIn(f'/{name}/', configOf(launch_file).clear_params)

    def testTheDemoSimulatesItsDriveOnceAndPlaysItWhole(self):
        prefix = shlex.split(nodesOf(ROOT / 'launch/demo.launch', scene='cube', scans='2')['player'].launch_prefix)
        self.assertEqual(prefix[:2], ['bash', '-c'])
        simulator = next(word for word in shlex.split(prefix[2]) if word.endswith('simulate_bag'))
        self.assertTrue(os.access(simulator, os.X_OK), simulator)
        with tempfile.TemporaryDirectory() as folder:
            drive = pathlib.Path(folder, 'drive.bag')
            name = next(word for word in shlex.split(prefix[2]) if word.endswith('_cube_2.bag'))
            command = prefix[2].replace(name, str(drive))

            def play(script):
                return subprocess.run(['bash', '-c', script, 'player', 'test', '-s', drive],
                                      stdout=subprocess.DEVNULL).returncode
            self.assertNotEqual(play(command.replace('&& mv', '&& false && mv')), 0)
            self.assertFalse(drive.exists(), 'an interrupted simulation left a bag to play')
            self.assertEqual(play(command), 0)
            self.assertEqual(play(command.replace(simulator, 'false')), 0, 'it was simulated again')

    def testABagThatIsGivenToTheDemoIsPlayedAsItIs(self):
        for bag, played in (('/tmp/some.bag', '/tmp/some.bag'), ('some.bag', f'{os.environ["PWD"]}/some.bag')):
            player = nodesOf(ROOT / 'launch/demo.launch', bag=bag)['player']
            self.assertFalse(player.launch_prefix)
            self.assertIn(f"'{played}'", player.args)

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
