#!/usr/bin/env python3
"""Writes the body meshes of the built-in vehicles: NAME/meshes/NAME.obj and .mtl.

Run it from anywhere, without arguments, after changing a shape; the meshes are kept beside it.
Needs only Python's standard library. Frame: origin on the ground below the rear axle, x forward,
y left, z up, metres. Wheels and implement are not in the mesh: they move, so the renderer draws
them from their sizes.
"""
import math
import pathlib

COLOURS = {
    "paint": (0.13, 0.42, 0.20),
    "paint_light": (0.86, 0.45, 0.10),
    "chassis": (0.16, 0.17, 0.18),
    "steel": (0.52, 0.54, 0.56),
    "roof": (0.90, 0.90, 0.87),
    "seat": (0.09, 0.09, 0.10),
    "lamp": (0.98, 0.93, 0.70),
    "battery": (0.20, 0.32, 0.48),
    "tray": (0.10, 0.11, 0.11),
    "seedling": (0.30, 0.65, 0.18),
}


class Mesh:
    """Faces by material; vertices and normals are written once each."""

    def __init__(self):
        self.vertices, self.normals, self.faces = {}, {}, {}

    def face(self, material, points, normals=None):
        """A planar convex polygon, counter-clockwise seen from outside; flat unless normals are given."""
        if normals is None:
            normals = [unit(cross(sub(points[1], points[0]), sub(points[2], points[0])))] * len(points)
        corners = [(self._index(self.vertices, p), self._index(self.normals, n))
                   for p, n in zip(points, normals)]
        for k in range(1, len(corners) - 1):
            self.faces.setdefault(material, []).append((corners[0], corners[k], corners[k + 1]))

    @staticmethod
    def _index(table, triple):
        key = tuple(round(value, 4) + 0.0 for value in triple)
        return table.setdefault(key, len(table) + 1)

    def loft(self, material, sections):
        """Solid through sections: polygons of as many points, counter-clockwise seen from the last."""
        self.face(material, sections[0][::-1])
        self.face(material, sections[-1])
        for low, high in zip(sections, sections[1:]):
            for k in range(len(low)):
                j = (k + 1) % len(low)
                self.face(material, [low[k], low[j], high[j], high[k]])

    def box(self, material, x, y, z):
        base = [(x[0], y[0]), (x[1], y[0]), (x[1], y[1]), (x[0], y[1])]
        self.loft(material, [[(a, b, h) for a, b in base] for h in z])

    def both_sides(self, material, x, y, z):
        self.box(material, x, y, z)
        self.box(material, x, (-y[1], -y[0]), z)

    def bar(self, material, start, end, radius, sides=8):
        """Round bar from start to end, smooth along its side."""
        axis = unit(sub(end, start))
        across = unit(cross(axis, (0, 0, 1) if abs(axis[2]) < 0.9 else (1, 0, 0)))
        up = cross(axis, across)
        spokes = []
        for k in range(sides):
            angle = 2 * math.pi * k / sides
            spokes.append(add(scale(across, math.cos(angle)), scale(up, math.sin(angle))))
        rims = [[add(centre, scale(s, radius)) for s in spokes] for centre in (start, end)]
        self.face(material, rims[0][::-1])
        self.face(material, rims[1])
        for k in range(sides):
            j = (k + 1) % sides
            self.face(material, [rims[0][k], rims[0][j], rims[1][j], rims[1][k]],
                      [spokes[k], spokes[j], spokes[j], spokes[k]])

    def fender(self, material, x, z, radius, y, from_deg, to_deg, thickness=0.03, steps=8):
        """Arc of sheet over a wheel; angles from +x upwards."""
        angles = [math.radians(from_deg + (to_deg - from_deg) * k / steps) for k in range(steps + 1)]
        sections = []
        for angle in angles:
            inner = (x + radius * math.cos(angle), z + radius * math.sin(angle))
            outer = (x + (radius + thickness) * math.cos(angle), z + (radius + thickness) * math.sin(angle))
            sections.append([(inner[0], y[0], inner[1]), (inner[0], y[1], inner[1]),
                             (outer[0], y[1], outer[1]), (outer[0], y[0], outer[1])])
        self.loft(material, sections)

    def pyramid(self, material, x, y, z, half, height):
        base = [(x - half, y - half, z), (x + half, y - half, z), (x + half, y + half, z), (x - half, y + half, z)]
        for k in range(4):
            self.face(material, [base[k], base[(k + 1) % 4], (x, y, z + height)])

    def write(self, name):
        folder = pathlib.Path(__file__).resolve().parent / name / "meshes"
        folder.mkdir(exist_ok=True)
        lines = ["# Body of the %s, frame B, metres; written by make_meshes.py" % name,
                 "mtllib %s.mtl" % name, "o %s" % name]
        lines += ["v %g %g %g" % key for key in self.vertices]
        lines += ["vn %g %g %g" % key for key in self.normals]
        for material in sorted(self.faces):
            lines.append("usemtl " + material)
            lines += ["f " + " ".join("%d//%d" % corner for corner in face) for face in self.faces[material]]
        (folder / (name + ".obj")).write_text("\n".join(lines) + "\n")
        paints = ["# Written by make_meshes.py"]
        for material in sorted(self.faces):
            paints.append("newmtl %s\nKd %g %g %g\nKs 0.1 0.1 0.1\nNs 20" % ((material,) + COLOURS[material]))
        (folder / (name + ".mtl")).write_text("\n".join(paints) + "\n")
        print("%s: %d vertices, %d triangles" % (name, len(self.vertices), sum(map(len, self.faces.values()))))


def add(a, b): return tuple(p + q for p, q in zip(a, b))
def sub(a, b): return tuple(p - q for p, q in zip(a, b))
def scale(a, k): return tuple(p * k for p in a)
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def unit(a): return scale(a, 1.0 / math.sqrt(sum(p * p for p in a)))


def bonnet_section(x, half, bottom, shoulder, top):
    """Hexagon across the vehicle with bevelled upper edges."""
    bevel = 0.75 * half
    return [(x, -half, bottom), (x, half, bottom), (x, half, shoulder),
            (x, bevel, top), (x, -bevel, top), (x, -half, shoulder)]


def steering_wheel(mesh, hub, radius):
    mesh.bar("chassis", (hub[0] + 0.28, hub[1], hub[2] - 0.30), hub, 0.025, 6)
    ring = []
    for k in range(10):
        angle = 2 * math.pi * k / 10
        ring.append((hub[0] - 0.5 * radius * math.cos(angle), hub[1] + radius * math.sin(angle),
                     hub[2] + 0.4 * radius * math.cos(angle)))
    for k in range(10):
        mesh.bar("seat", ring[k], ring[(k + 1) % 10], 0.018, 4)


def seat(mesh, x, z, half):
    mesh.box("seat", (x, x + 0.48), (-half, half), (z, z + 0.12))
    mesh.loft("seat", [[(x - 0.02, -half, z + 0.1), (x + 0.1, -half, z + 0.1), (x + 0.1, half, z + 0.1), (x - 0.02, half, z + 0.1)],
                       [(x - 0.14, -0.9 * half, z + 0.6), (x - 0.04, -0.9 * half, z + 0.6), (x - 0.04, 0.9 * half, z + 0.6), (x - 0.14, 0.9 * half, z + 0.6)]])


def utility_tractor():
    mesh = Mesh()
    mesh.box("chassis", (-0.35, 2.85), (-0.26, 0.26), (0.52, 0.98))
    mesh.box("chassis", (-0.22, 0.22), (-0.54, 0.54), (0.54, 0.82))  # rear axle
    mesh.box("chassis", (2.2, 2.4), (-0.58, 0.58), (0.45, 0.58))  # front axle
    mesh.loft("paint", [bonnet_section(1.18, 0.44, 0.92, 1.50, 1.66), bonnet_section(2.60, 0.41, 0.92, 1.38, 1.53),
                        bonnet_section(3.02, 0.38, 0.92, 1.24, 1.40), bonnet_section(3.12, 0.34, 0.98, 1.14, 1.24)])
    mesh.loft("chassis", [bonnet_section(3.12, 0.27, 1.0, 1.12, 1.18), bonnet_section(3.14, 0.27, 1.0, 1.12, 1.18)])  # grille
    mesh.both_sides("lamp", (3.02, 3.13), (0.27, 0.37), (1.06, 1.15))
    mesh.box("steel", (2.85, 3.20), (-0.38, 0.38), (0.58, 0.90))  # front ballast
    mesh.both_sides("battery", (0.95, 1.85), (0.27, 0.60), (0.55, 0.95))  # battery boxes, also the steps
    mesh.box("chassis", (-0.35, 1.20), (-0.52, 0.52), (0.98, 1.06))  # cab floor
    mesh.box("paint", (1.02, 1.20), (-0.42, 0.42), (1.06, 1.60))  # dashboard
    for side in ((0.50, 0.97), (-0.97, -0.50)):
        mesh.fender("paint", 0.0, 0.70, 0.80, side, 165, 15)
    seat(mesh, 0.05, 1.22, 0.26)
    mesh.box("chassis", (0.08, 0.46), (-0.18, 0.18), (1.06, 1.22))
    steering_wheel(mesh, (0.78, 0.0, 1.72), 0.20)
    for y in (-0.56, 0.56):
        mesh.bar("chassis", (-0.42, y, 1.04), (-0.36, y, 2.46), 0.045)
        mesh.bar("chassis", (1.12, y * 0.93, 1.04), (0.96, y, 2.46), 0.035)
    mesh.bar("chassis", (-0.38, -0.56, 1.9), (-0.38, 0.56, 1.9), 0.03)  # roll-over cross bar
    mesh.loft("roof", [[(-0.62, -0.70, 2.43), (1.16, -0.70, 2.43), (1.16, 0.70, 2.43), (-0.62, 0.70, 2.43)],
                       [(-0.62, -0.70, 2.47), (1.16, -0.70, 2.47), (1.16, 0.70, 2.47), (-0.62, 0.70, 2.47)],
                       [(-0.50, -0.58, 2.53), (1.02, -0.58, 2.53), (1.02, 0.58, 2.53), (-0.50, 0.58, 2.53)]])
    mesh.bar("roof", (0.27, 0.0, 2.52), (0.27, 0.0, 2.56), 0.10, 10)  # satellite receiver
    for y in (-0.40, 0.40):
        mesh.bar("steel", (-0.15, y, 0.62), (-0.74, y * 1.05, 0.52), 0.035, 6)  # lower links
    mesh.bar("steel", (-0.32, 0.0, 0.92), (-0.74, 0.0, 0.98), 0.03, 6)  # top link
    mesh.write("utility_tractor")


def transplanter():
    mesh = Mesh()
    mesh.both_sides("chassis", (-0.60, 2.0), (0.38, 0.46), (0.42, 0.50))  # frame
    for x in (-0.55, 0.5, 1.9):
        mesh.box("chassis", (x, x + 0.08), (-0.38, 0.38), (0.43, 0.49))
    mesh.bar("chassis", (0.0, -0.67, 0.34), (0.0, 0.67, 0.34), 0.04)  # rear axle
    mesh.bar("chassis", (1.4, -0.68, 0.30), (1.4, 0.68, 0.30), 0.035)  # front axle
    mesh.both_sides("chassis", (-0.04, 0.04), (0.38, 0.46), (0.30, 0.42))
    mesh.both_sides("chassis", (1.36, 1.44), (0.38, 0.46), (0.28, 0.42))
    mesh.box("steel", (0.05, 1.60), (-0.62, 0.62), (0.50, 0.54))  # deck
    mesh.box("battery", (0.10, 0.72), (-0.36, 0.36), (0.54, 0.84))
    seat(mesh, 0.25, 0.86, 0.24)
    mesh.loft("paint_light", [bonnet_section(1.22, 0.40, 0.54, 0.98, 1.10), bonnet_section(1.75, 0.38, 0.50, 0.84, 0.94),
                              bonnet_section(2.04, 0.30, 0.46, 0.66, 0.74)])
    mesh.both_sides("lamp", (1.98, 2.06), (0.16, 0.26), (0.58, 0.66))
    steering_wheel(mesh, (1.02, 0.0, 1.20), 0.17)
    for side in ((0.64, 0.88), (-0.88, -0.64)):
        mesh.fender("paint_light", 0.0, 0.36, 0.42, side, 150, 35, 0.02, 6)
        mesh.fender("paint_light", 1.4, 0.32, 0.38, side, 140, 50, 0.02, 5)
    for y in (-0.46, 0.46):
        mesh.bar("chassis", (0.02, y, 0.50), (0.02, y, 1.66), 0.03)  # roll bar
    mesh.bar("chassis", (0.02, -0.47, 1.66), (0.02, 0.47, 1.66), 0.03)
    for y in (-0.40, 0.40):
        mesh.bar("roof", (0.02, y, 1.69), (0.02, y, 1.75), 0.08, 10)  # two satellite antennas
    # Sloped rack with four seedling trays; a pyramid is one seedling.
    back, front, low, high = -0.86, -0.16, 0.86, 1.28
    slope = (high - low) / (front - back)
    for y in (-0.72, 0.72):
        mesh.bar("steel", (back + 0.05, y, low - 0.02), (front, y, high - 0.02), 0.025, 6)
        mesh.bar("steel", (-0.50, y * 0.58, 0.48), (-0.50, y, low + slope * 0.36 - 0.02), 0.025, 6)
    for tray in range(4):
        left = -0.90 + 0.46 * tray
        outline = [(back, left), (front, left), (front, left + 0.42), (back, left + 0.42)]
        mesh.loft("tray", [[(x, y, low + slope * (x - back) + h) for x, y in outline] for h in (0.0, 0.05)])
        for i in range(6):
            for j in range(4):
                x = back + 0.06 + 0.116 * i
                mesh.pyramid("seedling", x, left + 0.06 + 0.1 * j, low + slope * (x - back) + 0.05, 0.03, 0.11)
    mesh.write("transplanter")


def horticultural_tractor():
    mesh = Mesh()
    mesh.both_sides("chassis", (-0.25, 1.45), (0.16, 0.22), (0.26, 0.34))  # frame
    mesh.bar("chassis", (0.0, -0.36, 0.28), (0.0, 0.36, 0.28), 0.035)  # rear axle
    mesh.bar("chassis", (1.2, -0.37, 0.21), (1.2, 0.37, 0.21), 0.025)  # front axle
    mesh.both_sides("chassis", (1.16, 1.24), (0.10, 0.16), (0.21, 0.30))
    mesh.box("chassis", (-0.10, 0.12), (-0.16, 0.16), (0.24, 0.42))  # gear and motor
    mesh.box("steel", (0.05, 1.30), (-0.36, 0.36), (0.34, 0.37))  # deck
    mesh.box("battery", (0.86, 1.30), (-0.22, 0.22), (0.37, 0.66))
    mesh.loft("paint", [bonnet_section(0.80, 0.26, 0.37, 0.72, 0.80), bonnet_section(1.40, 0.25, 0.36, 0.66, 0.74),
                        bonnet_section(1.62, 0.20, 0.34, 0.52, 0.58)])
    mesh.both_sides("lamp", (1.57, 1.64), (0.09, 0.17), (0.45, 0.52))
    mesh.box("chassis", (-0.12, 0.22), (-0.16, 0.16), (0.37, 0.60))  # seat carrier
    seat(mesh, -0.12, 0.60, 0.20)
    steering_wheel(mesh, (0.56, 0.0, 0.92), 0.15)
    for side in ((0.36, 0.49), (-0.49, -0.36)):
        mesh.fender("paint", 0.0, 0.29, 0.34, side, 150, 30, 0.02, 6)
    mesh.bar("chassis", (0.84, 0.20, 0.70), (0.84, 0.20, 1.22), 0.018, 6)  # antenna mast
    mesh.bar("roof", (0.84, 0.20, 1.22), (0.84, 0.20, 1.28), 0.07, 10)  # satellite receiver
    for y in (-0.24, 0.24):
        mesh.bar("steel", (-0.10, y, 0.30), (-0.44, y, 0.26), 0.02, 6)  # lower links
    mesh.write("horticultural_tractor")


def skid_steer_robot():
    # The side units carry the wheels; the chassis hangs between them.
    mesh = Mesh()
    mesh.box("chassis", (-0.215, 1.135), (-0.35, 0.35), (0.26, 0.56))
    mesh.box("steel", (-0.12, 1.04), (-0.34, 0.34), (0.56, 0.58))  # top plate
    for left, right in ((0.43, 0.56), (-0.56, -0.43)):
        mesh.loft("paint_light", [
            [(-0.15, left, 0.28), (1.07, left, 0.28), (1.07, right, 0.28), (-0.15, right, 0.28)],
            [(-0.20, left, 0.40), (1.12, left, 0.40), (1.12, right, 0.40), (-0.20, right, 0.40)],
            [(0.10, left, 0.66), (0.82, left, 0.66), (0.82, right, 0.66), (0.10, right, 0.66)]])
        mesh.bar("chassis", (0.46, 0.8 * left, 0.45), (0.46, 0.8 * right, 0.45), 0.05)
    for side in ((0.43, 0.685), (-0.685, -0.43)):
        for x in (0.0, 0.92):
            mesh.fender("paint_light", x, 0.30, 0.34, side, 145, 35, 0.02, 6)
    mesh.both_sides("battery", (0.02, 0.44), (0.05, 0.32), (0.58, 0.72))
    mesh.box("tray", (0.55, 0.95), (-0.22, 0.22), (0.58, 0.70))  # tank
    mesh.bar("steel", (0.98, 0.0, 0.58), (0.98, 0.0, 0.80), 0.02, 8)
    mesh.bar("roof", (0.98, 0.0, 0.78), (0.98, 0.0, 0.83), 0.07, 12)  # lidar
    for y in (-0.28, 0.28):
        mesh.bar("steel", (-0.08, y, 0.58), (-0.08, y, 0.74), 0.012, 6)
        mesh.bar("roof", (-0.08, y, 0.74), (-0.08, y, 0.78), 0.06, 10)  # two satellite antennas
    mesh.both_sides("lamp", (1.13, 1.15), (0.20, 0.30), (0.44, 0.50))
    mesh.write("skid_steer_robot")


def four_wheel_steer_robot():
    mesh = Mesh()
    mesh.both_sides("chassis", (-0.50, 2.50), (0.42, 0.54), (0.96, 1.10))  # beams over the wheels
    for x in (0.0, 2.0):
        mesh.box("chassis", (x - 0.08, x + 0.08), (-0.54, 0.54), (0.98, 1.08))
        mesh.both_sides("steel", (x - 0.07, x + 0.07), (0.54, 0.62), (0.94, 1.12))  # kingpin heads
        for y in (-0.60, 0.60):
            mesh.bar("steel", (x, y, 0.50), (x, y, 1.16), 0.045)  # kingpins
            mesh.bar("chassis", (x, y, 0.50), (x, 1.27 * y, 0.50), 0.09, 12)  # hub motors
    for y in (-0.42, 0.42):
        mesh.loft("battery", [[(x, y + s, z) for x, s in ((0.62, -0.16), (1.38, -0.16), (1.38, 0.16), (0.62, 0.16))]
                              for z in (0.46, 0.96)])
    mesh.box("chassis", (0.50, 1.50), (-0.56, 0.56), (1.10, 1.14))
    mesh.loft("paint", [bonnet_section(-0.42, 0.50, 1.10, 1.28, 1.36), bonnet_section(0.40, 0.52, 1.10, 1.34, 1.44),
                        bonnet_section(1.60, 0.52, 1.10, 1.34, 1.44), bonnet_section(2.42, 0.50, 1.10, 1.26, 1.34)])
    mesh.both_sides("lamp", (2.40, 2.44), (0.28, 0.42), (1.16, 1.24))
    mesh.box("steel", (2.46, 2.58), (-0.70, 0.70), (0.90, 1.00))  # bumper
    mesh.both_sides("steel", (2.40, 2.50), (0.42, 0.54), (0.90, 1.00))
    for y in (-0.40, 0.40):
        mesh.bar("roof", (1.0, y, 1.44), (1.0, y, 1.50), 0.08, 12)  # two satellite antennas
        mesh.bar("steel", (-0.50, y, 0.98), (-0.60, y, 0.70), 0.03, 6)  # hitch frame
    mesh.write("four_wheel_steer_robot")


utility_tractor()
transplanter()
horticultural_tractor()
skid_steer_robot()
four_wheel_steer_robot()
