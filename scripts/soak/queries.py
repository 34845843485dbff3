"""Askers that leave the map as it is."""
import math

from atom_mapping import srv
from geometry_msgs.msg import Point, Vector3

from asker import Asker, drawPoint

UNKNOWN, FREE, OCCUPIED = 0, 1, 2


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
