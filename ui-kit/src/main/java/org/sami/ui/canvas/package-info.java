/**
 * What maps and nets have in common as something that is panned, zoomed and pointed at: {@link org.sami.ui.canvas.CanvasMouse} tells
 * panning from what a {@link org.sami.ui.canvas.CanvasTool} takes, {@link org.sami.ui.canvas.CanvasKey} names what keys do there. What is
 * shown, and where, does not belong here.
 */
package org.sami.ui.canvas;
