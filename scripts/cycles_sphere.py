"""Draws the sphere of scripts/cycles.sh with Blender's Cycles, for comparison with Burnish.

Usage: blender -b --factory-startup --python-exit-code 1 --python cycles_sphere.py -- OUT.exr KEY=VALUE...
  env=FILE          lat-long environment; without it, black
  alpha=X,Y         GGX roughness along and across the tangent, which runs along circles of latitude
  color=R,G,B       linear reflectance at normal incidence
  shader=anisotropic  the Anisotropic BSDF: a constant color
  shader=principled   the Principled BSDF, metallic: the color turns white towards grazing incidence
  scattering=single | multiple
  strip=RADIANCE    of the rectangle that cycles.sh states; 0: none
  size=PIXELS samples=COUNT seed=NUMBER elevation=DEGREES azimuth=DEGREES distance=METERS fov=DEGREES

Burnish's axes (x right, y up, -z the middle of the environment) become Blender's by (x, y, z) -> (-z, -x, y), a
rotation: an environment texture of Blender has its middle at +x, and its columns run towards -y.
"""
import math
import sys

import bpy
from mathutils import Matrix, Vector


def arguments():
    words = sys.argv[sys.argv.index("--") + 1:]
    return words[0], dict(word.split("=", 1) for word in words[1:])


def numbers(text):
    return [float(part) for part in text.split(",")]


def to_blender(v):
    return Vector((-v[2], -v[0], v[1]))


def placed(position, direction, up):
    """The matrix of an object whose -z looks along direction, as cameras and lamps of Blender do."""
    back = -to_blender(direction).normalized()
    right = to_blender(up).cross(back).normalized()
    upward = back.cross(right)
    matrix = Matrix((right, upward, back)).transposed().to_4x4()
    matrix.translation = to_blender(position)
    return matrix


def add_sphere():
    columns, rows = 256, 128  # the silhouette is within 0.01 % of a sphere of radius 0.5
    points = [(0.0, 0.0, 0.5), (0.0, 0.0, -0.5)]
    for row in range(1, rows):
        height, width = (0.5 * f(math.pi * row / rows) for f in (math.cos, math.sin))
        for column in range(columns):
            turn = 2.0 * math.pi * column / columns
            points.append((width * math.cos(turn), width * math.sin(turn), height))

    def at(row, column):
        if row in (0, rows):
            return 0 if row == 0 else 1
        return 2 + (row - 1) * columns + column % columns

    faces = []
    for row in range(rows):
        for column in range(columns):
            face = (at(row, column), at(row + 1, column), at(row + 1, column + 1), at(row, column + 1))
            faces.append(tuple(dict.fromkeys(face)))  # triangles at the poles
    mesh = bpy.data.meshes.new("sphere")
    mesh.from_pydata(points, [], faces)
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    sphere = bpy.data.objects.new("sphere", mesh)
    bpy.context.collection.objects.link(sphere)
    return sphere


def add_material(sphere, o):
    material = bpy.data.materials.new("metal")
    material.use_nodes = True
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    tangent = nodes.new("ShaderNodeTangent")
    tangent.direction_type, tangent.axis = "RADIAL", "Z"
    ax, ay = numbers(o["alpha"])
    color = numbers(o["color"]) + [1.0]
    multiple = o["scattering"] == "multiple"
    roughness = math.sqrt(math.sqrt(ax * ay))
    if o["shader"] == "anisotropic":
        shader = nodes.new("ShaderNodeBsdfAnisotropic")
        shader.distribution = "MULTI_GGX" if multiple else "GGX"
        shader.inputs["Color"].default_value = color
        # alpha_x = r^2 (1 - a) and alpha_y = r^2 / (1 - a); for a < 0 they are r^2 / (1 + a) and r^2 (1 + a).
        ratio = math.sqrt(ax / ay)
        anisotropy = 1.0 - ratio if ratio <= 1.0 else 1.0 / ratio - 1.0
        shader.inputs["Anisotropy"].default_value = anisotropy
    else:
        shader = nodes.new("ShaderNodeBsdfPrincipled")
        shader.distribution = "MULTI_GGX" if multiple else "GGX"
        shader.inputs["Base Color"].default_value = color
        shader.inputs["Metallic"].default_value = 1.0
        # aspect = sqrt(1 - 0.9 a); alpha_x = r^2 / aspect, alpha_y = r^2 aspect: x is always the wider one.
        shader.inputs["Anisotropic"].default_value = (1.0 - min(ax, ay) / max(ax, ay)) / 0.9
        shader.inputs["Anisotropic Rotation"].default_value = 0.25 if ax < ay else 0.0
    shader.inputs["Roughness"].default_value = roughness
    out = nodes.new("ShaderNodeOutputMaterial")
    links.new(tangent.outputs[0], shader.inputs["Tangent"])
    links.new(shader.outputs[0], out.inputs["Surface"])
    sphere.data.materials.append(material)


def add_environment(o):
    world = bpy.data.worlds.new("world")
    bpy.context.scene.world = world
    world.use_nodes = True
    nodes, links = world.node_tree.nodes, world.node_tree.links
    background = nodes["Background"]
    if "env" not in o:
        background.inputs["Color"].default_value = (0.0, 0.0, 0.0, 1.0)
        return
    texture = nodes.new("ShaderNodeTexEnvironment")
    texture.image = bpy.data.images.load(o["env"])
    texture.image.colorspace_settings.name = "Linear"
    links.new(texture.outputs["Color"], background.inputs["Color"])


def add_strip(radiance):
    light = bpy.data.lights.new("strip", "AREA")
    light.shape = "RECTANGLE"
    light.size, light.size_y = 0.3, 1.8
    light.energy = 4.0 * radiance * light.size * light.size_y  # Cycles gives a lamp of P watts the radiance P / (4 area)
    strip = bpy.data.objects.new("strip", light)
    strip.matrix_world = placed((-1.2, 0.5, 1.4), (1.2, -0.5, -1.4), (0.0, 1.0, 0.0))
    bpy.context.collection.objects.link(strip)


def add_camera(o):
    azimuth, elevation = (math.radians(float(o[key])) for key in ("azimuth", "elevation"))
    eye = Vector((math.sin(azimuth) * math.cos(elevation), math.sin(elevation),
                  math.cos(azimuth) * math.cos(elevation))) * float(o["distance"])
    data = bpy.data.cameras.new("camera")
    data.sensor_fit = "VERTICAL"
    data.angle = math.radians(float(o["fov"]))
    camera = bpy.data.objects.new("camera", data)
    camera.matrix_world = placed(eye, -eye, (0.0, 1.0, 0.0))
    bpy.context.collection.objects.link(camera)
    bpy.context.scene.camera = camera


def render(out, o):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = int(o["samples"])
    cycles.seed = int(o.get("seed", 0))
    cycles.use_denoising = False
    cycles.use_adaptive_sampling = False
    # Nothing that trades energy for less noise.
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.blur_glossy = 0.0
    cycles.light_sampling_threshold = 0.0
    scene.render.film_transparent = True
    scene.render.resolution_x = scene.render.resolution_y = int(o["size"])
    scene.render.resolution_percentage = 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.color_mode = "RGBA"
    scene.view_settings.view_transform = "Raw"
    scene.render.filepath = out
    bpy.ops.render.render(write_still=True)


def main():
    out, o = arguments()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    add_material(add_sphere(), o)
    add_environment(o)
    if float(o["strip"]) > 0.0:
        add_strip(float(o["strip"]))
    add_camera(o)
    render(out, o)


main()
