"""Askers that write the map to files, and that change it."""
import random
import threading
import time

import h5py
import rospy
from atom_mapping import srv
from geometry_msgs.msg import Point
from std_srvs.srv import Trigger

from asker import NODE, Asker, drawPoint


class Saves(Asker):
    name_of_service, kind, period = 'save_map', srv.MapFile, 1.0

    def request(self):
        return srv.MapFileRequest(file=str(self.output / 'saved.h5'))

    def check(self, request, response):
        with h5py.File(request.file, 'r') as file:
            if not response.atoms == file.attrs['atoms'] == len(file['centers'][:]) == len(file['log_odds'][:]):
                yield 'a file of another number of atoms than the answer tells'


class Clears(Asker):
    name_of_service, kind, period = 'clear_region', srv.ClearRegion, 7.0

    def request(self):
        corner = drawPoint(self.draw)
        return srv.ClearRegionRequest(min=corner, max=Point(corner.x + 3, corner.y + 3, corner.z + 3))


class Resets(Asker):
    name_of_service, kind, period = 'reset', Trigger, 97.0

    def request(self):
        return Trigger._request_class()


class Pausable:
    """Of what changes the map."""

    def askOnce(self):
        with self.lock:
            super().askOnce()


class PausableClears(Pausable, Clears):
    lock = threading.Lock()


class PausableResets(Pausable, Resets):
    lock = threading.Lock()


class Reload:
    """While nothing else changes the map: saves it, loads it, and expects the same answers."""
    period = 0.0  # s: at the end of every round of the bag

    def __init__(self, output, pausing):
        self.file = str(output / 'reloaded.h5')
        self.pausing = pausing  # askers that change the map
        self.name = 'save, load, ask'
        self.answers = self.refusals = 0
        self.worst = 0.0
        self.faults = []
        draw = random.Random(1)
        self.points = [drawPoint(draw) for _ in range(2000)]
        self.call = {name: rospy.ServiceProxy(NODE + name, kind) for name, kind in
                     (('save_map', srv.MapFile), ('load_map', srv.MapFile), ('query_occupancy', srv.QueryOccupancy))}

    def ask(self):
        response = self.call['query_occupancy'](frame_id='', points=self.points)
        return response.state, response.probability

    def once(self):
        for asker in self.pausing:
            asker.lock.acquire()
        try:
            began = time.monotonic()
            saved = self.call['save_map'](self.file)
            before = self.ask()
            loaded = self.call['load_map'](self.file)
            self.worst = max(self.worst, time.monotonic() - began)
            self.answers += 1
            if not (saved.success and loaded.success and saved.atoms == loaded.atoms):
                self.faults.append(f'{saved.message}; {loaded.message}')
            elif self.ask() != before:
                self.faults.append('a map that was saved and loaded answers otherwise')
        finally:
            for asker in self.pausing:
                asker.lock.release()
