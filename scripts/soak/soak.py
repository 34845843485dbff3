#!/usr/bin/python3
"""Plays a bag into a running node, again and again at the rate of its stamps, and asks everything of it meanwhile. See scripts/soak.sh."""
import argparse
import pathlib
import sys
import threading
import time

import rosbag
import rospy
from atom_mapping.msg import ScanReport
from rosgraph_msgs.msg import Clock

sys.dont_write_bytecode = True
import askers  # noqa: E402

PATIENCE = 30.0  # s of wall time that a scan may take before it counts as lost


class Player:
    """Plays the bag as `rosbag play --clock` does; knows which scans were answered, and how late."""

    def __init__(self, bag):
        self.messages = list(rosbag.Bag(bag).read_messages())
        self.clock = rospy.Publisher('/clock', Clock, queue_size=10)
        kinds = {topic: type(message) for topic, message, _ in self.messages}
        self.publishers = {topic: rospy.Publisher(topic, kind, queue_size=100, latch=topic == '/tf_static') for topic, kind in kinds.items()}
        self.sent = {}  # stamp: moment, of the scans without a report
        self.delays = []
        self.lost = 0
        self.scans = 0
        self.lock = threading.Condition()
        self.reports = rospy.Subscriber('/atom_mapping/scan_report', ScanReport, self.note, queue_size=100)

    def note(self, report):
        with self.lock:
            sent = self.sent.pop(report.header.stamp.to_nsec(), None)
            if sent is not None:
                self.delays.append(time.monotonic() - sent)
            self.lock.notify_all()

    def waitForNode(self):
        while any(link.get_num_connections() == 0 for link in [*self.publishers.values(), self.reports]):
            time.sleep(0.05)

    def play(self, deadline):
        """Once through. Then waits for the reports, so that no scan is under way when time jumps back."""
        began, first = time.monotonic(), self.messages[0][2].to_sec()
        for topic, message, stamp in self.messages:
            if time.monotonic() > deadline:
                break
            time.sleep(max(0.0, stamp.to_sec() - first - (time.monotonic() - began)))
            self.clock.publish(Clock(clock=stamp))
            if hasattr(message, 'header'):
                self.scans += 1
                with self.lock:
                    self.sent[message.header.stamp.to_nsec()] = time.monotonic()
            self.publishers[topic].publish(message)
        with self.lock:
            self.lock.wait_for(lambda: not self.sent, timeout=PATIENCE)
            self.lost += len(self.sent)
            self.sent.clear()


def residentMegabytes(pid):
    for line in pathlib.Path(f'/proc/{pid}/status').read_text().splitlines():
        if line.startswith('VmRSS:'):
            return int(line.split()[1]) / 1024
    raise RuntimeError('the node has died')


class Memory(threading.Thread):
    """What the node holds, every five seconds."""

    def __init__(self, pid, file):
        super().__init__(daemon=True)
        self.pid, self.file, self.samples, self.alive = pid, file, [], True

    def run(self):
        began = time.monotonic()
        with open(self.file, 'w') as out:
            out.write('seconds,megabytes\n')
            while self.alive:
                try:
                    self.samples.append((time.monotonic() - began, residentMegabytes(self.pid)))
                except (OSError, RuntimeError):
                    self.alive = False
                    return
                out.write('%.0f,%.1f\n' % self.samples[-1])
                out.flush()
                time.sleep(5.0)

    def peak(self, begin, end):
        """Over a part of the time, both as shares of all of it."""
        number = len(self.samples)
        return max((megabytes for _, megabytes in self.samples[int(begin * number):max(1, int(end * number))]), default=0.0)


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))] if values else float('nan')


def judge(player, memory, asked, seconds):
    """Prints the figures; what speaks against the node, which was asked for so long."""
    delays = player.delays
    print(f'scans: {player.scans} sent, {player.lost} lost; from sent to mapped: median {percentile(delays, 0.5) * 1e3:.0f} ms,'
          f' 95 % {percentile(delays, 0.95) * 1e3:.0f} ms, 99 % {percentile(delays, 0.99) * 1e3:.0f} ms, worst {max(delays, default=0) * 1e3:.0f} ms')
    for asker in asked:
        print(f'{asker.name}: {asker.answers} answers, {asker.refusals} refused, worst {asker.worst * 1e3:.0f} ms')
    thirds = [memory.peak(i / 3, (i + 1) / 3) for i in range(3)]
    print('memory, peak of each third of the time: ' + ', '.join(f'{peak:.0f} MB' for peak in thirds))
    faults = [fault for asker in asked for fault in asker.faults]
    faults += [f'{asker.name} was never answered' for asker in asked if asker.answers == 0 and asker.period < seconds]
    if not memory.alive:
        faults.append('the node has died')
    if player.lost:
        faults.append(f'{player.lost} scans were lost')
    if thirds[2] > 1.1 * max(thirds[:2]) + 10.0:
        faults.append('memory grows')
    return faults


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('--bag', required=True)
    parser.add_argument('--minutes', type=float, required=True)
    parser.add_argument('--node', type=int, required=True, help="the node's process")
    parser.add_argument('--output', type=pathlib.Path, required=True)
    parser.add_argument('--light', action='store_true', help='ask for occupancy only, and listen to ~atoms')
    options = parser.parse_args()
    rospy.init_node('soak', anonymous=True, disable_signals=True)
    player = Player(options.bag)
    player.waitForNode()
    memory = Memory(options.node, options.output / 'memory.csv')
    memory.start()
    asked = askers.startLight(options.output) if options.light else askers.start(options.output)
    deadline = time.monotonic() + 60 * options.minutes
    rounds = 0
    while time.monotonic() < deadline and memory.alive:
        player.play(deadline)
        rounds += 1
        asked.betweenRounds(rounds)
    asked.stop()
    print(f'{rounds} rounds of the bag, time jumped back {rounds - 1} times')
    faults = judge(player, memory, asked.all, 60 * options.minutes)
    for fault in faults[:20]:
        print('FAULT:', fault)
    print('verdict: ' + (f'failed, {len(faults)} faults' if faults else 'passed'))
    return 1 if faults else 0


if __name__ == '__main__':
    sys.exit(main())
