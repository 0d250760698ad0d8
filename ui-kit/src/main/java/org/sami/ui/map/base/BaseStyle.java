package org.sami.ui.map.base;

import java.awt.Color;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;

/**
 * How outlines are painted.
 *
 * @param lineScale how many pixels of the screen a logical pixel is
 */
public record BaseStyle(Color land, Color outline, double lineScale) {
    /** The style of the look in force; on the event thread. */
    public static BaseStyle now(double deviceScale) {
        return new BaseStyle(
                SemanticColor.MAP_LAND.get(), SemanticColor.MAP_OUTLINE.get(), deviceScale * Look.scalePercent() / 100);
    }
}
