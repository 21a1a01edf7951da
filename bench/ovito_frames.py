"""What OVITO takes for the frames of a trajectory: ovito_frames.py FILE FRAMES SIDE SKY_RAYS. Tachyon draws them, as plainly as it can
(0 rays) or with shadows and so many rays of ambient occlusion a point."""
import sys
import tempfile

from ovito.io import import_file
from ovito.vis import TachyonRenderer, Viewport


def main(path: str, frames: str, side: str, sky_rays: str) -> None:
    lit = sky_rays != "0"
    pipeline = import_file(path)
    pipeline.add_to_scene()
    view = Viewport(type=Viewport.Type.Ortho, camera_dir=(1, 1, -1))
    view.zoom_all(size=(int(side), int(side)))
    renderer = TachyonRenderer(antialiasing=False, shadows=lit, ambient_occlusion=lit,
                               ambient_occlusion_samples=max(int(sky_rays), 1), direct_light=True)
    with tempfile.TemporaryDirectory() as folder:
        view.render_anim(f"{folder}/frame.png", size=(int(side), int(side)), range=(0, int(frames) - 1), renderer=renderer)


main(*sys.argv[1:])
