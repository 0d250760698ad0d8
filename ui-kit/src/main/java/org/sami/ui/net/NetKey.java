package org.sami.ui.net;

import java.util.List;
import javax.swing.KeyStroke;
import org.sami.ui.canvas.CanvasKey;

/** What keys do on a net that has the focus. */
public enum NetKey implements CanvasKey {
    /** Shows what lies left. */
    LEFT("Pan left", "LEFT"),
    /** Shows what lies right. */
    RIGHT("Pan right", "RIGHT"),
    /** Shows what lies above. */
    UP("Pan up", "UP"),
    /** Shows what lies below. */
    DOWN("Pan down", "DOWN"),
    /** Shows less, larger. */
    ZOOM_IN("Zoom in", "PLUS", "ADD", "EQUALS"),
    /** Shows more, smaller. */
    ZOOM_OUT("Zoom out", "MINUS", "SUBTRACT"),
    /** Shows it at its own size. */
    ACTUAL_SIZE("Actual size", "1"),
    /** Shows all of it. */
    FIT("Show all", "HOME", "F"),
    /** Selects the next vertex, in the plan's order. */
    NEXT("Next vertex", "N", "PERIOD"),
    /** Selects the vertex before. */
    PREVIOUS("Previous vertex", "P", "COMMA"),
    /** Opens what is selected. */
    OPEN("Open", "ENTER"),
    /** Selects nothing. */
    CLEAR("Select nothing", "ESCAPE"),
    /** Shows or hides the overview. */
    OVERVIEW("Overview", "O"),
    /** Shows the nominal parts, the recovery parts, or all. */
    MODE("Nominal, recovery or all", "R");

    private final String label;
    private final List<KeyStroke> strokes;

    NetKey(String label, String... strokes) {
        this.label = label;
        this.strokes = CanvasKey.strokes(strokes);
    }

    @Override
    public String canvas() {
        return "Net";
    }

    @Override
    public String label() {
        return label;
    }

    @Override
    public List<KeyStroke> strokes() {
        return strokes;
    }
}
