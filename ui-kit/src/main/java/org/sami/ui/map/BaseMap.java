package org.sami.ui.map;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Consumer;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.command.Command;

/** The base map below the layers of a map: what it is, what of it is still being read, and the command that leaves that. On the event thread. */
final class BaseMap {
    private final MapCanvas canvas;
    private final Consumer<String> problems;
    private final BaseMapLoader loader;
    private final Command stop;
    private final ReadingNote note;

    /**
     * The base map of a canvas, which has none yet.
     *
     * @param problems is told in one line what is wrong with a file
     */
    BaseMap(MapCanvas canvas, Consumer<String> problems) {
        this.canvas = canvas;
        this.problems = problems;
        loader = new BaseMapLoader(source -> show(Optional.of(source)), this::showOutlines, problems, this::look);
        stop = new Command("map-base-stop", "Stop reading the base map", this::stop)
                .withIcon("close")
                .unless(() -> reading().isPresent() ? Optional.empty() : Optional.of("no map file is being read"));
        note = new ReadingNote(this::reading, stop);
        canvas.setLayout(new MigLayout("insets 0"));
        canvas.add(note, "pos 12 12, wmax 100%-24");
    }

    /** Reads a file beside the event thread and shows it then. */
    void open(Path file) {
        loader.open(file);
    }

    /** Shows no tiles, only the grid, and leaves what is still being read; outlines are layers and stay. */
    void close() {
        loader.leaveAll();
        show(Optional.empty());
    }

    /** The command that leaves what is still being read. */
    Command stopReading() {
        return stop;
    }

    private void stop() {
        if (loader.reading().isPresent()) {
            loader.leaveAll();
        } else {
            close(); // its tiles come too slowly
        }
    }

    /** What is being read, in a few words; empty where nothing is. */
    private Optional<String> reading() {
        OfflineTiles tiles = canvas.tiles();
        return loader.reading()
                .map(file -> file.getFileName().toString())
                .or(() ->
                        tiles.source().filter(source -> tiles.isReading()).map(source -> "tiles of " + source.name()));
    }

    private void show(Optional<TileSource> source) {
        canvas.show(new OfflineTiles(
                source,
                () -> {
                    canvas.repaint();
                    look();
                },
                this::look,
                problems));
        canvas.setGrid(source.isEmpty());
        look();
    }

    private void look() {
        note.look();
    }

    private void showOutlines(OutlineLayer layer) {
        canvas.layers().find(layer.id()).ifPresent(canvas.layers()::remove);
        canvas.layers().addBelow(layer);
    }

    /** Reads no more, and closes its files. */
    void end() {
        loader.end();
        canvas.tiles().close();
    }
}
