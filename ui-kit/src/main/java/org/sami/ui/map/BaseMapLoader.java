package org.sami.ui.map;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import org.sami.ui.EventThread;

/** Opens files of base maps beside the event thread, and hands over there what they hold or what is wrong with them. */
final class BaseMapLoader implements AutoCloseable {
    private final Consumer<Optional<TileSource>> tiles;
    private final Consumer<OutlineLayer> outlines;
    private final Consumer<String> problems;
    private final ExecutorService opener = Executors.newCachedThreadPool(task -> {
        Thread thread = new Thread(task, "map-open");
        thread.setDaemon(true);
        return thread;
    });

    BaseMapLoader(Consumer<Optional<TileSource>> tiles, Consumer<OutlineLayer> outlines, Consumer<String> problems) {
        this.tiles = tiles;
        this.outlines = outlines;
        this.problems = problems;
    }

    void open(Path file) {
        opener.execute(() -> read(file));
    }

    private void read(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        try {
            if (name.endsWith(".json") || name.endsWith(".geojson")) {
                OutlineLayer layer = new OutlineLayer(file.getFileName().toString(), GeoJson.read(file));
                EventThread.later(() -> outlines.accept(layer));
            } else {
                MbTiles source = MbTiles.open(file);
                EventThread.later(() -> tiles.accept(Optional.of(source)));
            }
        } catch (IOException | RuntimeException e) {
            String problem = e.getMessage() == null ? file + " cannot be read: " + e : e.getMessage();
            EventThread.later(() -> problems.accept(problem));
        }
    }

    @Override
    public void close() {
        opener.shutdown();
    }
}
