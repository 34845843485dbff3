"""Who asks the node for something, over and over: each in a thread of its own, each checking the values that it gets."""
import math
import random
import threading
import time

import h5py
import rospy
from atom_mapping import srv
from geometry_msgs.msg import Point, Vector3
from std_srvs.srv import Trigger

NODE = '/atom_mapping/'
UNKNOWN, FREE, OCCUPIED = 0, 1, 2


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


class Occupancy(Asker):
    name_of_service, kind, period = 'query_occupancy', srv.QueryOccupancy, 0.05

    def request(self):
        return srv.QueryOccupancyRequest(points=[drawPoint(self.draw) for _ in range(200)])

    def check(self, request, response):
        if not len(request.points) == len(response.probability) == len(response.state):
            yield 'arrays of other lengths than the request'
        for state, probability in zip(response.state, response.probability):
            if not (probability == 0.5 if state == UNKNOWN else (probability > 0.5) == (state == OCCUPIED)):
                yield f'state {state} with probability {probability}'


class Collision(Asker):
    name_of_service, kind, period = 'check_collision', srv.CheckCollision, 0.05

    def request(self):
        centers = [drawPoint(self.draw) for _ in range(100)]
        return srv.CheckCollisionRequest(centers=centers * 2, radii=[0.2] * 100 + [0.6] * 100, unknown_is_free=False)

    def check(self, request, response):
        # The map may change between two spheres of a request: what contradicts itself is asked again.
        for center, small, large in zip(request.centers, response.collides[:100], response.collides[100:]):
            if small and not large:
                again = self.service(centers=[center] * 2, radii=[0.2, 0.6], frame_id='', unknown_is_free=False)
                if again.collides[0] and not again.collides[1]:
                    yield 'a sphere collides and a larger one about it does not'


class Rays(Asker):
    name_of_service, kind, period = 'cast_ray', srv.CastRay, 0.05

    def request(self):
        origins = [drawPoint(self.draw) for _ in range(100)]
        directions = [Vector3(*(self.draw.gauss(0, 1) for _ in range(3))) for _ in range(100)]
        return srv.CastRayRequest(origins=origins, directions=directions, max_range=15.0)

    def check(self, request, response):
        for origin, end, result in zip(request.origins, response.ends, response.result):
            length = math.dist((origin.x, origin.y, origin.z), (end.x, end.y, end.z))
            if not length <= 15.001 or (result == 0 and abs(length - 15.0) > 0.01):
                yield f'a ray of result {result} ends after {length} m'


class Surface(Asker):
    name_of_service, kind, period = 'extract_surface', srv.ExtractSurface, 3.0

    def request(self):
        corner = drawPoint(self.draw, 15.0)
        return srv.ExtractSurfaceRequest(min=Point(corner.x - 4, corner.y - 4, -2), max=Point(corner.x + 4, corner.y + 4, 5))

    def mayRefuse(self, message):
        return 'no surface' in message or 'no atom' in message

    def check(self, request, response):
        if len(response.variance) != len(response.mesh.vertices):
            yield 'not one variance a vertex'
        slack = 0.51
        for vertex in response.mesh.vertices:
            if not (request.min.x - slack <= vertex.x <= request.max.x + slack and
                    request.min.y - slack <= vertex.y <= request.max.y + slack):
                yield f'a vertex at {vertex.x} {vertex.y}, outside the box'
                break
        if any(max(t.vertex_indices) >= len(response.mesh.vertices) for t in response.mesh.triangles):
            yield 'a triangle of a vertex that is not there'


class Paths(Asker):
    name_of_service, kind, period = 'plan_path', srv.PlanPath, 1.0

    def request(self):
        request = srv.PlanPathRequest(robot_radius=0.2, timeout=2.0)
        request.start.pose.position, request.goal.pose.position = drawPoint(self.draw, 15.0), drawPoint(self.draw, 15.0)
        request.start.pose.position.z = request.goal.pose.position.z = 1.5
        return request

    def mayRefuse(self, message):
        return True  # most places are unknown, or in a wall

    def check(self, request, response):
        places = [pose.pose.position for pose in response.path.poses]
        steps = sum(math.dist((a.x, a.y, a.z), (b.x, b.y, b.z)) for a, b in zip(places, places[1:]))
        if abs(steps - response.length) > 0.01 * max(1.0, steps):
            yield f'a path of {steps} m that says {response.length} m'
        for wanted, place in ((request.start, places[0]), (request.goal, places[-1])):
            wanted = wanted.pose.position
            if math.dist((wanted.x, wanted.y, wanted.z), (place.x, place.y, place.z)) > 0.01:
                yield 'a path between other places'


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


class Refused(Asker):
    """Asks for what must be refused."""
    name_of_service, kind, period = 'query_occupancy', srv.QueryOccupancy, 0.5

    def __init__(self, output, seed):
        super().__init__(output, seed)
        self.name = 'faulty requests'

    def request(self):
        return self.draw.choice([srv.QueryOccupancyRequest(points=[Point(x=math.nan)]),
                                 srv.QueryOccupancyRequest(frame_id='nowhere', points=[Point()])])

    def mayRefuse(self, message):
        return 'points[0]' in message or 'nowhere' in message

    def check(self, request, response):
        yield 'a faulty request was served'


class Reload:
    """While nothing else changes the map: saves it, loads it, and expects the same answers."""

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


class Pausable:
    """Of what changes the map."""

    def askOnce(self):
        with self.lock:
            super().askOnce()


class PausableClears(Pausable, Clears):
    lock = threading.Lock()


class PausableResets(Pausable, Resets):
    lock = threading.Lock()


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
