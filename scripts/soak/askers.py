"""All who ask the node at once: start and stop them."""
import rospy

from asker import NODE
from changes import Pausable, PausableClears, PausableResets, Reload, Saves
from queries import Collision, Occupancy, Paths, Rays, Refused, Surface


class Askers:

    def __init__(self, output):
        kinds = (Occupancy, Collision, Rays, Surface, Paths, Saves, PausableClears, PausableResets, Refused)
        self.threads = [kind(output, seed) for seed, kind in enumerate(kinds)]
        self.reload = Reload(output, [t for t in self.threads if isinstance(t, Pausable)])
        self.all = self.threads + [self.reload]
        for thread in self.threads:
            thread.start()

    def betweenRounds(self, number):
        self.reload.once()

    def stop(self):
        for thread in self.threads:
            thread.stopping.set()
        for thread in self.threads:
            thread.join(60.0)


class LightAskers:
    """One client of 100 queries a second, who listens to the map as well."""

    def __init__(self, output):
        self.all = [Occupancy(output, 0)]
        self.all[0].period = 0.01
        self.listener = rospy.Subscriber(NODE + 'atoms', rospy.AnyMsg, lambda message: None, buff_size=1 << 26)
        self.all[0].start()

    def betweenRounds(self, number):
        pass

    def stop(self):
        self.all[0].stopping.set()
        self.all[0].join(60.0)


def start(output):
    return Askers(output)


def startLight(output):
    return LightAskers(output)
