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
    font_size = max(5.0, min(9.0, 72 * scale * 0.3))
    names = figures.short_names(run.robots)
    robots = [_Robot(axis, run, name, names[name], path, font_size) for name, path in paths.items()]
    moving = [artist for robot in robots for artist in robot.layers] + [clock]
    for artist in moving:
        artist.set_animated(True)
    figure.canvas.draw()
    background = figure.canvas.copy_from_bbox(figure.bbox)
    for index, time_s in enumerate(times):
        figure.canvas.restore_region(background)
        for robot in robots:
            robot.move(times[max(0, index - TRAIL)], time_s)
        clock.set_text(f"{time_s:.0f} s of {times[-1]:.0f} s")
        for layer in zip(*(robot.layers for robot in robots)):
            for artist in layer:
                axis.draw_artist(artist)
        axis.draw_artist(clock)
        yield Image.fromarray(np.asarray(figure.canvas.buffer_rgba())).convert("RGB")
    pyplot.close(figure)


class _Robot:
    """What moves in the picture for one robot; its goal, which does not, is drawn on the map."""

    def __init__(self, axis, run, name, short_name, path, font_size):
        """path: as of figures.cells_of()."""
        color = figures.color_of(run, name)
        text = {"fontsize": font_size, "ha": "center", "va": "center_baseline"}
        row, column = path[1, -1], path[2, -1]
        axis.add_patch(pyplot.Rectangle((column - 0.42, row - 0.42), 0.84, 0.84, fill=False, edgecolor=color, linewidth=2))
        axis.text(column, row, short_name, color="#777777", **text)
        length, width = (side / run.cell_size_m for side in run.footprint_m)
        self._axis = axis
        self._path = path
        self._trail, = axis.plot([], [], color=color, linewidth=3, alpha=0.5)
        self._body = axis.add_patch(pyplot.Rectangle((-length / 2, -width / 2), length, width, facecolor=color, edgecolor="black"))
        self._label = axis.text(0, 0, short_name, color=figures.text_color(color), **text)

    @property
    def layers(self):
        """Its artists, the lowest first."""
        return self._trail, self._body, self._label

    def move(self, since_s, time_s):
        """To where it was at a time, with its trail since another."""
        time, row, column, yaw = self._path
        recent = np.linspace(since_s, time_s, 3 * TRAIL)
        self._trail.set_data(np.interp(recent, time, column), np.interp(recent, time, row))
        at = min(np.searchsorted(time, time_s), len(time) - 1)
        x, y = np.interp(time_s, time, column), np.interp(time_s, time, row)
        self._body.set_transform(Affine2D().rotate(-yaw[at]).translate(x, y) + self._axis.transData)  # rows count down
        self._label.set_position((x, y))
