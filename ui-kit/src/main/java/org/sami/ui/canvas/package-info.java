/**
 * What maps and nets share for panning, zooming and pointing: {@link org.sami.ui.canvas.CanvasMouse} reports
 * panning from what a {@link org.sami.ui.canvas.CanvasTool} takes, {@link org.sami.ui.canvas.CanvasKey} names what keys do there. What is
 * shown, and where, does not belong here.
 */
@NullMarked
package org.sami.ui.canvas;

import org.jspecify.annotations.NullMarked;
