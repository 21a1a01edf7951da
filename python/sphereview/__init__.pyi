from .camera import Camera as Camera, fit as fit
from .light import Light as Light
from .pictures import explain as explain, read_png as read_png, render as render, write_png as write_png
from .scene import Scene as Scene, read as read
