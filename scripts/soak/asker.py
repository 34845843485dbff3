"""Who asks the node for something, over and over, in a thread of its own, checking the values that it gets."""
import random
import threading
import time

import rospy
from geometry_msgs.msg import Point

NODE = '/atom_mapping/'


def drawPoint(draw, reach=25.0):
    return Point(draw.uniform(-reach, reach), draw.uniform(-reach, reach), draw.uniform(-1.0, 6.0))


class Asker(threading.Thread):
    """Calls `ask` until it is stopped. A refusal that `mayRefuse` does not know, and what `check` says, are faults."""
    name_of_service = ''
    kind = None
    period = 0.0  # s

    def __init__(self, output, seed):
        super().__init__(daemon=True, name=self.name_of_service)
        self.output = output
        self.draw = random.Random(seed)
        self.answers = self.refusals = 0
        self.worst = 0.0
        self.faults = []
        self.stopping = threading.Event()
        self.service = rospy.ServiceProxy(NODE + self.name_of_service, self.kind)

    def run(self):
        self.service.wait_for_service()
        while not self.stopping.wait(self.period):
            self.askOnce()

    def askOnce(self):
        request = self.request()
        began = time.monotonic()
        try:
            response = self.service(request)
        except (rospy.ServiceException, rospy.ROSException, OSError) as error:
            self.faults.append(f'{self.name}: {error}')
            return
        self.worst = max(self.worst, time.monotonic() - began)
        self.answers += 1
        if response.success:
            self.faults += [f'{self.name}: {fault}' for fault in self.check(request, response)]
        elif self.mayRefuse(response.message):
            self.refusals += 1
        else:
            self.faults.append(f'{self.name}: {response.message}')

    def mayRefuse(self, message):
        return False

    def check(self, request, response):
        return []
