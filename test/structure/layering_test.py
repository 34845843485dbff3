#!/usr/bin/python3
"""A folder under include/atom_mapping and src includes only itself and folders to its left (docs: DESIGN, "The house").

ROS' headers lie in /usr/include, so that the compiler would not notice one in the core.
"""
import pathlib
import re
import unittest

import rosunit

ROOT = pathlib.Path(__file__).resolve().parents[2]

# Folder: its place in the order base < scan < map < query < surface, planning < io < sim, baseline < evaluation < ros < apps,
# and the libraries that it may know beside the standard library. `None`: any, ROS and the generated messages too.
PLACES = {
    'base': (0, 'Eigen/'),
    'scan': (1, 'Eigen/ pcl/'),
    'map': (2, 'Eigen/'),
    'query': (3, 'Eigen/'),
    'surface': (4, 'Eigen/ pcl/ vtk'),
    'planning': (4, 'Eigen/'),
    'io': (5, 'Eigen/ EGL/ hdf5 H5 nlohmann/ pcl/ vtk'),
    'sim': (6, 'Eigen/ nlohmann/'),
    'baseline': (6, 'Eigen/ octomap/'),
    'evaluation': (7, 'Eigen/ nlohmann/'),
    'ros': (8, None),
    'apps': (9, None),
}
TESTS_OF_CORE = 'Eigen/ pcl/ vtk hdf5 H5 nlohmann/ octomap/ gtest/ gmock/ rapidcheck sanitizer/'

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
OURS = re.compile(r'atom_mapping/(?:(\w+)/)?')
STANDARD = re.compile(r'([a-z_0-9]+|(sys/)?[a-z_]+\.h)$')


def sources(folder):
    return sorted(path for suffix in ('*.h', '*.cpp') for path in (ROOT / folder).rglob(suffix))


def faults(path, may_include, libraries):
    """Includes of a file that its place forbids. `may_include` tells it of a folder of ours."""
    for bracket, header in INCLUDE.findall(path.read_text()):
        ours = OURS.match(header)
        if ours:
            if ours.group(1) and not may_include(ours.group(1)):
                yield f'{path.relative_to(ROOT)}: includes {header}, which lies to its right or beside it'
            elif not ours.group(1) and libraries is not None:
                yield f'{path.relative_to(ROOT)}: includes the generated message {header}'
        elif bracket == '"' and (path.parent / header).exists():
            if 'test' not in path.relative_to(ROOT).parts:  # tests share helpers that lie beside them
                yield f'{path.relative_to(ROOT)}: includes {header} without its full path'
        elif libraries is not None and not STANDARD.match(header) and not header.startswith(tuple(libraries.split())):
            yield f'{path.relative_to(ROOT)}: must not know the library of {header}'


class LayeringTest(unittest.TestCase):

    def testEveryFolderHasItsPlace(self):
        for parent in ('include/atom_mapping', 'src'):
            for path in (ROOT / parent).iterdir():
                self.assertIn(path.name, PLACES, f'{path} is in no layer')

    def testFoldersIncludeOnlyWhatLiesToTheirLeft(self):
        found = []
        for folder, (place, libraries) in PLACES.items():
            for path in sources(f'include/atom_mapping/{folder}') + sources(f'src/{folder}'):
                found += faults(path, lambda other: other == folder or PLACES[other][0] < place, libraries)
        self.assertFalse(found, '\n' + '\n'.join(found))

    def testTestsOfTheCoreKnowNoRos(self):
        found = []
        for path in sources('test/core'):
            found += faults(path, lambda other: PLACES[other][0] < PLACES['ros'][0], TESTS_OF_CORE)
        self.assertFalse(found, '\n' + '\n'.join(found))

    def testRosHeadersAreNoticed(self):
        for header in ('ros/ros.h', 'sensor_msgs/PointCloud2.h', 'tf2_ros/buffer.h', 'pcl_conversions/pcl_conversions.h'):
            self.assertFalse(STANDARD.match(header) or header.startswith(tuple(TESTS_OF_CORE.split())), header)


if __name__ == '__main__':
    rosunit.unitrun('atom_mapping', 'layering', LayeringTest)
