package org.sami.ui.map;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import javax.swing.KeyStroke;

/** What keys do on a map that has the focus. */
public enum MapKey {
    /** Shows what lies west, or moves the chosen corner there. */
    LEFT("Pan left", key(KeyEvent.VK_LEFT)),
    /** Shows what lies east, or moves the chosen corner there. */
    RIGHT("Pan right", key(KeyEvent.VK_RIGHT)),
    /** Shows what lies north, or moves the chosen corner there. */
    UP("Pan up", key(KeyEvent.VK_UP)),
    /** Shows what lies south, or moves the chosen corner there. */
    DOWN("Pan down", key(KeyEvent.VK_DOWN)),
    /** Shows less, larger. */
    ZOOM_IN("Zoom in", key(KeyEvent.VK_PLUS), key(KeyEvent.VK_ADD), key(KeyEvent.VK_EQUALS), shift(KeyEvent.VK_EQUALS)),
    /** Shows more, smaller. */
    ZOOM_OUT("Zoom out", key(KeyEvent.VK_MINUS), key(KeyEvent.VK_SUBTRACT)),
    /** Shows all that layers have. */
    FIT("Show all", key(KeyEvent.VK_HOME), key(KeyEvent.VK_F)),
    /** Puts a point where the pointer is, or in the middle of the map. */
    ADD("Put a point here", key(KeyEvent.VK_INSERT), key(KeyEvent.VK_SPACE)),
    /** Chooses the next corner. */
    NEXT("Next point", key(KeyEvent.VK_N), key(KeyEvent.VK_PERIOD)),
    /** Chooses the corner before. */
    PREVIOUS("Previous point", key(KeyEvent.VK_P), key(KeyEvent.VK_COMMA)),
    /** Takes the chosen corner away. */
    DELETE("Take the point away", key(KeyEvent.VK_DELETE), key(KeyEvent.VK_BACK_SPACE)),
    /** Takes the last change back. */
    UNDO("Undo", control(KeyEvent.VK_Z)),
    /** Makes it again. */
    REDO(
            "Redo",
            control(KeyEvent.VK_Y),
            KeyStroke.getKeyStroke(KeyEvent.VK_Z, InputEvent.CTRL_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK)),
    /** Ends drawing and keeps what was drawn. */
    FINISH("Finish", key(KeyEvent.VK_ENTER)),
    /** Leaves what is being done. */
    CANCEL("Cancel", key(KeyEvent.VK_ESCAPE)),
    /** Measures distances and areas. */
    MEASURE("Measure", key(KeyEvent.VK_M)),
    /** Copies the coordinates under the pointer. */
    COPY("Copy coordinates", control(KeyEvent.VK_C)),
    /** Goes to the field in which coordinates are typed. */
    TYPE("Type coordinates", key(KeyEvent.VK_G));

    private final String label;
    private final List<KeyStroke> strokes;

    MapKey(String label, KeyStroke... strokes) {
        this.label = label;
        this.strokes = List.of(strokes);
    }

    /** What it does, in a few words. */
    public String label() {
        return label;
    }

    /** The keys, the first is the one that is told. */
    public List<KeyStroke> strokes() {
        return strokes;
    }

    /** The stable name of its action: {@code map.zoom-in}. */
    public String id() {
        return "map." + name().toLowerCase(java.util.Locale.ROOT).replace('_', '-');
    }

    /** The first key in words: {@code Ctrl+Z}. */
    public String keyText() {
        KeyStroke stroke = strokes.get(0);
        String modifiers = InputEvent.getModifiersExText(stroke.getModifiers());
        return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(stroke.getKeyCode());
    }

    private static KeyStroke key(int code) {
        return KeyStroke.getKeyStroke(code, 0);
    }

    private static KeyStroke shift(int code) {
        return KeyStroke.getKeyStroke(code, InputEvent.SHIFT_DOWN_MASK);
    }

    private static KeyStroke control(int code) {
        return KeyStroke.getKeyStroke(code, InputEvent.CTRL_DOWN_MASK);
    }
}
