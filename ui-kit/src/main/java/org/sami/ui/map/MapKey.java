package org.sami.ui.map;

import java.util.List;
import javax.swing.KeyStroke;
import org.sami.ui.canvas.CanvasKey;

/** What keys do on a map that has the focus. */
public enum MapKey implements CanvasKey {
    /** Shows what lies west, or moves the chosen corner there. */
    LEFT("Pan left", "LEFT"),
    /** Shows what lies east, or moves the chosen corner there. */
    RIGHT("Pan right", "RIGHT"),
    /** Shows what lies north, or moves the chosen corner there. */
    UP("Pan up", "UP"),
    /** Shows what lies south, or moves the chosen corner there. */
    DOWN("Pan down", "DOWN"),
    /** Shows less, larger. */
    ZOOM_IN("Zoom in", "PLUS", "ADD", "EQUALS", "shift EQUALS"),
    /** Shows more, smaller. */
    ZOOM_OUT("Zoom out", "MINUS", "SUBTRACT"),
    /** Shows all that layers have. */
    FIT("Show all", "HOME", "F"),
    /** Puts a point where the pointer is, or in the middle of the map. */
    ADD("Put a point here", "INSERT", "SPACE"),
    /** Chooses the next corner. */
    NEXT("Next point", "N", "PERIOD"),
    /** Chooses the corner before. */
    PREVIOUS("Previous point", "P", "COMMA"),
    /** Takes the chosen corner away. */
    DELETE("Take the point away", "DELETE", "BACK_SPACE"),
    /** Takes the last change back. */
    UNDO("Undo", "ctrl Z"),
    /** Makes it again. */
    REDO("Redo", "ctrl Y", "ctrl shift Z"),
    /** Ends drawing and keeps what was drawn. */
    FINISH("Finish", "ENTER"),
    /** Leaves what is being done. */
    CANCEL("Cancel", "ESCAPE"),
    /** Measures distances and areas. */
    MEASURE("Measure", "M"),
    /** Copies the coordinates under the pointer. */
    COPY("Copy coordinates", "ctrl C"),
    /** Goes to the field in which coordinates are typed. */
    TYPE("Type coordinates", "G");

    private final String label;
    private final List<KeyStroke> strokes;

    MapKey(String label, String... strokes) {
        this.label = label;
        this.strokes = CanvasKey.strokes(strokes);
    }

    /** Whether it is about what is drawn, and does nothing where nothing is. */
    boolean isOfSketch() {
        return switch (this) {
            case ADD, NEXT, PREVIOUS, DELETE, UNDO, REDO, FINISH, CANCEL -> true;
            default -> false;
        };
    }

    @Override
    public String canvas() {
        return "Map";
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
