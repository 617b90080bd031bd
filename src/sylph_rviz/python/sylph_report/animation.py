"""A run as a small animated picture, made without a display."""
import numpy as np
from matplotlib import pyplot
from matplotlib.transforms import Affine2D
from PIL import Image

from sylph_report import figures

FRAMES = 120
FRAME_S = 0.1  # of the picture; longer runs go faster
LAST_S = 2.0
SIDE_INCHES = 4.2
DPI = 100
COLORS = 48
TRAIL = 8  # frames


def write(run, path):
    """Writes a GIF of the robots on their map. Returns how much faster than the run it is, None: nothing to draw."""
    robots = [(name, robot) for name, robot in run.robots.items() if robot.pose] if run.obstacles else []
    paths = {name: figures.cells_of(run, robot) for name, robot in robots}
    paths = {name: path for name, path in paths.items() if path.size}
    if not paths:
        return None
    end_s = max(path[0, -1] for path in paths.values())
    times = np.linspace(0.0, end_s, FRAMES)
    frames = list(_frames(run, paths, times))
    palette = frames[FRAMES // 2].quantize(COLORS)
    pixels = [np.asarray(frame.quantize(palette=palette, dither=Image.Dither.NONE)) for frame in frames]
    # What is as it was before is left transparent: that is a fifth of the size.
    images = [_image(pixels[0], palette)]
    images += [_image(np.where(now == before, COLORS, now), palette) for before, now in zip(pixels, pixels[1:])]
    durations = [round(1e3 * FRAME_S)] * (FRAMES - 1) + [round(1e3 * LAST_S)]
    images[0].save(path, save_all=True, append_images=images[1:], duration=durations, loop=0, optimize=False,
                   transparency=COLORS, disposal=1)  # fmt: skip
    return end_s / (FRAMES * FRAME_S)


def _image(pixels, palette):
    image = Image.fromarray(pixels.astype(np.uint8), "P")
    image.putpalette(palette.getpalette())
    return image


def _frames(run, paths, times):
    """The map is drawn once and under each frame copied: a whole drawing takes twenty times as long."""
    rows, columns = len(run.obstacles), len(run.obstacles[0])
    scale = SIDE_INCHES / max(rows, columns)
    figure, axis = pyplot.subplots(figsize=(max(columns * scale, 2.0), rows * scale + 0.25), dpi=DPI)
    figures.draw_map(axis, run.obstacles)
    axis.set(xticks=[], yticks=[])
    figure.subplots_adjust(0.01, 0.01, 0.99, 1.0 - 0.25 / figure.get_figheight())
    clock = axis.set_title("", fontsize=9, pad=4)
    names = figures.short_names(run.robots)
    size = max(5.0, min(9.0, 72 * scale * 0.3))
    length, width = (side / run.cell_size_m for side in run.footprint_m)
    artists = {}
    for name, path in paths.items():
        color = figures.color_of(run, name)
        goal = pyplot.Rectangle((path[2, -1] - 0.42, path[1, -1] - 0.42), 0.84, 0.84, fill=False, edgecolor=color, linewidth=2)
        axis.add_patch(goal)
        axis.text(path[2, -1], path[1, -1], names[name], color="#777777", fontsize=size, ha="center", va="center_baseline")
        trail, = axis.plot([], [], color=color, linewidth=3, alpha=0.5)
        body = axis.add_patch(pyplot.Rectangle((-length / 2, -width / 2), length, width, facecolor=color, edgecolor="black"))
        label = axis.text(0, 0, names[name], color=figures.text_color(color), fontsize=size, ha="center", va="center_baseline")
        artists[name] = (trail, body, label)
    moving = [artist for group in artists.values() for artist in group] + [clock]
    for artist in moving:
        artist.set_animated(True)
    figure.canvas.draw()
    background = figure.canvas.copy_from_bbox(figure.bbox)
    for index, time_s in enumerate(times):
        figure.canvas.restore_region(background)
        for name, (trail, body, label) in artists.items():
            time, row, column, yaw = paths[name]
            since = times[max(0, index - TRAIL)]
            recent = np.linspace(since, time_s, 3 * TRAIL)
            trail.set_data(np.interp(recent, time, column), np.interp(recent, time, row))
            at = min(np.searchsorted(time, time_s), len(time) - 1)
            x, y = np.interp(time_s, time, column), np.interp(time_s, time, row)
            body.set_transform(Affine2D().rotate(-yaw[at]).translate(x, y) + axis.transData)  # rows count down
            label.set_position((x, y))
        clock.set_text(f"{time_s:.0f} s of {times[-1]:.0f} s")
        for layer in range(3):
            for group in artists.values():
                axis.draw_artist(group[layer])
        axis.draw_artist(clock)
        yield Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")
    pyplot.close(figure)
