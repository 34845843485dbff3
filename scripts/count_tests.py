#!/usr/bin/python3
"""Counts the JUnit results of build folders and ends with the line `N passed, N failed`, as scripts/test.sh needs it.

A result that a build's expected_test_results.txt announces and that is not there counts as failed; skipped tests are
named. `--failed NAME` adds a check that failed outside of them, `--passed NAME` one that passed.
"""
import argparse
import pathlib
import sys
import xml.etree.ElementTree


def testCases(result):
    """(name, outcome, what the test said) of each test in a result file."""
    for case in xml.etree.ElementTree.parse(result).iter('testcase'):
        name = f"{case.get('classname')}.{case.get('name')}"
        for outcome, tags in (('failed', ('failure', 'error')), ('skipped', ('skipped',))):
            said = [child for child in case if child.tag in tags]
            if said:
                yield name, outcome, (said[0].get('message') or said[0].text or '').strip()
                break
        else:
            yield name, 'passed', ''


def outcomes(build):
    for result in sorted((build / 'test_results').rglob('*.xml')):
        yield from testCases(result)
    for line in (build / 'expected_test_results.txt').read_text().splitlines():
        if not pathlib.Path(line).exists():
            yield pathlib.Path(line).stem, 'failed', 'left no result'


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('builds', nargs='*', type=pathlib.Path)
    parser.add_argument('--passed', action='append', default=[])
    parser.add_argument('--failed', action='append', default=[])
    arguments = parser.parse_args()

    counts = {'passed': len(arguments.passed), 'failed': len(arguments.failed), 'skipped': 0}
    for name in arguments.failed:
        print(f'failed: {name}')
    for build in arguments.builds:
        for name, outcome, said in outcomes(build):
            counts[outcome] += 1
            if outcome != 'passed':
                print(f'{outcome}: {name} ({build.name}): {said}')
    skipped = f", {counts['skipped']} skipped" if counts['skipped'] else ''
    print(f"{counts['passed']} passed, {counts['failed']} failed{skipped}")
    return 1 if counts['failed'] else 0


if __name__ == '__main__':
    sys.exit(main())
