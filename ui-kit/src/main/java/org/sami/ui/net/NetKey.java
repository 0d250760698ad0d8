package org.sami.ui.net;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.List;
import java.util.Locale;
import javax.swing.KeyStroke;

/** What keys do on a net that has the focus. */
public enum NetKey {
    /** Shows what lies left. */
    LEFT("Pan left", key(KeyEvent.VK_LEFT)),
    /** Shows what lies right. */
    RIGHT("Pan right", key(KeyEvent.VK_RIGHT)),
    /** Shows what lies above. */
    UP("Pan up", key(KeyEvent.VK_UP)),
    /** Shows what lies below. */
    DOWN("Pan down", key(KeyEvent.VK_DOWN)),
    /** Shows less, larger. */
    ZOOM_IN("Zoom in", key(KeyEvent.VK_PLUS), key(KeyEvent.VK_ADD), key(KeyEvent.VK_EQUALS)),
    /** Shows more, smaller. */
    ZOOM_OUT("Zoom out", key(KeyEvent.VK_MINUS), key(KeyEvent.VK_SUBTRACT)),
    /** Shows it at its own size. */
    ACTUAL_SIZE("Actual size", key(KeyEvent.VK_1)),
    /** Shows all of it. */
    FIT("Show all", key(KeyEvent.VK_HOME), key(KeyEvent.VK_F)),
    /** Selects the next vertex, in the plan's order. */
    NEXT("Next vertex", key(KeyEvent.VK_N), key(KeyEvent.VK_PERIOD)),
    /** Selects the vertex before. */
    PREVIOUS("Previous vertex", key(KeyEvent.VK_P), key(KeyEvent.VK_COMMA)),
    /** Opens what is selected. */
    OPEN("Open", key(KeyEvent.VK_ENTER)),
    /** Selects nothing. */
    CLEAR("Select nothing", key(KeyEvent.VK_ESCAPE)),
    /** Shows or hides the overview. */
    OVERVIEW("Overview", key(KeyEvent.VK_O)),
    /** Shows the nominal parts, the recovery parts, or all. */
    MODE("Nominal, recovery or all", key(KeyEvent.VK_R));

    private final String label;
    private final List<KeyStroke> strokes;

    NetKey(String label, KeyStroke... strokes) {
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

    /** The stable name of its action: {@code net.zoom-in}. */
    public String id() {
        return "net." + name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The first key in words. */
    public String keyText() {
        KeyStroke stroke = strokes.get(0);
        String modifiers = InputEvent.getModifiersExText(stroke.getModifiers());
        return (modifiers.isEmpty() ? "" : modifiers + "+") + KeyEvent.getKeyText(stroke.getKeyCode());
    }

    private static KeyStroke key(int code) {
        return KeyStroke.getKeyStroke(code, 0);
    }
}
