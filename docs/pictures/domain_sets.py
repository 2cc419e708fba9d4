"""Draws docs/pictures/domain-sets.svg from `capcon export`: python3 docs/pictures/domain_sets.py PROGRAM > docs/pictures/domain-sets.svg"""
import math, struct, subprocess, sys, tempfile, os


def sets_of(domain, points):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "sets.npy")
        subprocess.run([sys.argv[1], "export", "-n", str(points), "--domain", domain, "-o", path], check=True)
        data = open(path, "rb").read()
    head = data[10:10 + struct.unpack("<H", data[8:10])[0]].decode()
    sets = int(head.split("(")[1].split(",")[0])
    start = len(data) - sets * points * 32
    return [[struct.unpack_from("<4d", data, start + 32 * (s * points + i)) for i in range(points)] for s in range(sets)]


def to_disk(u, v):
    x, y = 2 * u - 1, 2 * v - 1
    if x == 0 and y == 0:
        return 0.0, 0.0
    r, angle = (x, math.pi / 4 * y / x) if abs(x) > abs(y) else (y, math.pi / 2 - math.pi / 4 * x / y)
    return r * math.cos(angle), r * math.sin(angle)


def outline(cell):
    x, y, w, h = cell
    steps = [k / 4 for k in range(4)]
    around = [(x + w * t, y) for t in steps] + [(x + w, y + h * t) for t in steps] + \
             [(x + w * (1 - t), y + h) for t in steps] + [(x, y + h * (1 - t)) for t in steps]
    return around


size, out = 220, []
rows = [("disk", 16, [0, 1]), ("disk", 64, [0]), ("square", 64, [0])]
column = 0
for domain, points, which in rows:
    sets = sets_of(domain, points)
    for s in which:
        place = (lambda u, v: tuple(0.5 + 0.48 * c for c in to_disk(u, v))) if domain == "disk" else \
                (lambda u, v: (0.02 + 0.96 * u, 0.02 + 0.96 * v))
        at = lambda u, v: "%.1f,%.1f" % tuple(size * (c + (column if k == 0 else 0)) for k, c in enumerate(place(u, v)))
        if domain == "disk":
            out.append('<circle cx="%d" cy="%d" r="%.1f" class="edge"/>' % (size * (column + .5), size / 2, 0.48 * size))
        else:
            out.append('<rect x="%.1f" y="%.1f" width="%.1f" height="%.1f" class="edge"/>' % (size * (column + .02), size * .02, size * .96, size * .96))
        for cell in sets[s]:
            out.append('<polygon points="%s" class="cell"/>' % " ".join(at(u, v) for u, v in outline(cell)))
        column += 1
print('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %d %d" width="%d">' % (size * column, size, size * column))
print('<rect width="100%" height="100%" fill="#fff"/><style>.edge{fill:#f4f4f4;stroke:#888}.cell{fill:#b3261e}</style>')
print("\n".join(out) + "\n</svg>")
