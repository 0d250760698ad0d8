package org.sami.ui.canvas;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Stream;
import javax.swing.KeyStroke;
import org.sami.ui.command.Command;

/** Something that keys do on a canvas that has the focus, such as panning it; an enum for each canvas names them. */
public interface CanvasKey {
    /** Its name among those of the canvas: {@code ZOOM_IN}. */
    String name();

    /** What the canvas is called: {@code Map}. */
    String canvas();

    /** What it does, in a few words. */
    String label();

    /** The keys, the first is the one shown in help and menus. */
    List<KeyStroke> strokes();

    /** Its stable id, that of its command: {@code map-zoom-in}. */
    default String id() {
        return canvas().toLowerCase(Locale.ROOT) + "-"
                + name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** The first key in words: {@code Ctrl+Z}. */
    default String keyText() {
        return Command.text(strokes().get(0));
    }

    /**
     * Reads keys.
     *
     * @param strokes as {@link KeyStroke#getKeyStroke(String)} does, such as {@code "ctrl shift Z"}
     */
    static List<KeyStroke> strokes(String... strokes) {
        return Stream.of(strokes).map(KeyStroke::getKeyStroke).toList();
    }

    /**
     * The commands of keys, for the component that has them and for the registry of a window, where they are found by typing.
     *
     * @param press does what a key does
     * @param whyNot why it can do nothing now; empty where it can
     */
    static <K extends CanvasKey> List<Command> commands(
            K[] keys, Consumer<K> press, Function<K, Optional<String>> whyNot) {
        List<Command> commands = new ArrayList<>();
        for (K key : keys) {
            commands.add(new Command(key.id(), key.canvas() + ": " + key.label(), () -> press.accept(key))
                    .withFocusKeys(key.strokes())
                    .unless(() -> whyNot.apply(key)));
        }
        return commands;
    }
}
