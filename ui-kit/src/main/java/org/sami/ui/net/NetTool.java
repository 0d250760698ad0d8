package org.sami.ui.net;

import java.awt.Graphics2D;
import org.sami.ui.canvas.CanvasTool;

/** What the pointer does on a net. An editor has other tools than a monitor. */
public interface NetTool extends CanvasTool<NetPointer> {
    /** Paints on top of the net, in drawing units. */
    default void paint(Graphics2D g) {}
}
