#!/usr/bin/env python3
"""Writes examples/real_field.geojson and examples/real_field_dem.asc.

They have the formats of real data - a boundary with a hole in WGS 84 longitude and latitude, an
elevation raster in UTM (EPSG:32632, ESRI ASCII grid with a .prj beside it) - but the field and its
hills are made up. Only the standard library is needed.
"""
import json
import math
from pathlib import Path

FOLDER = Path(__file__).resolve().parent
EAST, NORTH = 560_000.0, 5_390_000.0  # UTM 32N, lower left corner of the raster
CELL, COLUMNS, ROWS = 5.0, 64, 56

# The field in metres from the raster's corner.
BOUNDARY = [(60, 62), (152, 50), (246, 74), (262, 150), (214, 214), (120, 222), (66, 168)]
HOLE = [(150, 128), (166, 122), (176, 136), (164, 148), (150, 142)]


def lon_lat(east, north):
    """UTM 32N to WGS 84 degrees by Krueger's series (to the sixth order), good to a micrometre."""
    a, f, k0 = 6378137.0, 1 / 298.257223563, 0.9996
    n = f / (2 - f)
    rectifying = a / (1 + n) * (1 + n**2 / 4 + n**4 / 64)
    xi, eta = north / (k0 * rectifying), (east - 500_000.0) / (k0 * rectifying)
    beta = [
        n / 2 - 2 / 3 * n**2 + 37 / 96 * n**3,
        n**2 / 48 + n**3 / 15,
        17 / 480 * n**3,
    ]
    xi_, eta_ = xi, eta
    for j, b in enumerate(beta, 1):
        xi_ -= b * math.sin(2 * j * xi) * math.cosh(2 * j * eta)
        eta_ -= b * math.cos(2 * j * xi) * math.sinh(2 * j * eta)
    chi = math.asin(math.sin(xi_) / math.cosh(eta_))
    delta = [
        2 * n - 2 / 3 * n**2 - 2 * n**3,
        7 / 3 * n**2 - 8 / 5 * n**3,
        56 / 15 * n**3,
    ]
    phi = chi + sum(d * math.sin(2 * j * chi) for j, d in enumerate(delta, 1))
    lam = math.radians(9.0) + math.atan2(math.sinh(eta_), math.cos(xi_))
    return [round(math.degrees(lam), 8), round(math.degrees(phi), 8)]


def ring(points):
    closed = points + points[:1]
    return [lon_lat(EAST + x, NORTH + y) for x, y in closed]


def height(x, y):
    """A hillside falling to the south-east with two broad swells."""
    return (
        412.0
        - 0.035 * x
        + 0.02 * y
        + 1.8 * math.sin(x / 46.0 + 0.6) * math.cos(y / 61.0)
        + 0.9 * math.cos((x + y) / 37.0)
    )


def main():
    field = {
        "type": "FeatureCollection",
        "features": [
            {
                "type": "Feature",
                "properties": {"name": "synthetic field"},
                "geometry": {"type": "Polygon", "coordinates": [ring(BOUNDARY), ring(HOLE[::-1])]},
            }
        ],
    }
    (FOLDER / "real_field.geojson").write_text(json.dumps(field, indent=1) + "\n")

    lines = [
        f"ncols {COLUMNS}",
        f"nrows {ROWS}",
        f"xllcorner {EAST:.1f}",
        f"yllcorner {NORTH:.1f}",
        f"cellsize {CELL:.1f}",
        "nodata_value -9999",
    ]
    for row in reversed(range(ROWS)):  # the file starts in the north
        y = (row + 0.5) * CELL
        lines.append(" ".join(f"{height((i + 0.5) * CELL, y):.2f}" for i in range(COLUMNS)))
    (FOLDER / "real_field_dem.asc").write_text("\n".join(lines) + "\n")
    (FOLDER / "real_field_dem.prj").write_text(PROJECTION + "\n")


PROJECTION = (
    'PROJCS["WGS 84 / UTM zone 32N",GEOGCS["WGS 84",DATUM["WGS_1984",'
    'SPHEROID["WGS 84",6378137,298.257223563]],PRIMEM["Greenwich",0],'
    'UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],'
    'PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",9],'
    'PARAMETER["scale_factor",0.9996],PARAMETER["false_easting",500000],'
    'PARAMETER["false_northing",0],UNIT["metre",1],AUTHORITY["EPSG","32632"]]'
)

if __name__ == "__main__":
    main()
