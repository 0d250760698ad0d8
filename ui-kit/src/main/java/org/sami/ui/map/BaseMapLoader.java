package org.sami.ui.map;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Consumer;
import org.sami.ui.EventThread;

/**
 * Opens files of base maps beside the event thread, and hands over there what they hold or what is wrong with them. A file may take its time, or
 * never be read: nobody waits for it, and it can be left. On the event thread.
 */
final class BaseMapLoader {
    private final Consumer<TileSource> tiles;
    private final Consumer<OutlineLayer> outlines;
    private final Consumer<String> problems;
    private final Runnable changed;
    private final List<Load> loads = new ArrayList<>();
    private final ExecutorService opener = Executors.newCachedThreadPool(task -> {
        Thread thread = new Thread(task, "map-open");
        thread.setDaemon(true);
        return thread;
    });

    /** A file that is being read. */
    private static final class Load {
        private final Path file;
        private Future<?> work;

        Load(Path file) {
            this.file = file;
        }

        boolean isOutlines() {
            String name = file.toString().toLowerCase(Locale.ROOT);
            return name.endsWith(".json") || name.endsWith(".geojson");
        }
    }

    /**
     * A loader that reads nothing yet.
     *
     * @param problems is told in one line what is wrong with a file
     * @param changed is run when a file is begun, was read or was left
     */
    BaseMapLoader(
            Consumer<TileSource> tiles, Consumer<OutlineLayer> outlines, Consumer<String> problems, Runnable changed) {
        this.tiles = tiles;
        this.outlines = outlines;
        this.problems = problems;
        this.changed = changed;
    }

    /** Begins to read a file. There is one map of tiles: others that are still being read are left. */
    void open(Path file) {
        Load load = new Load(file);
        if (!load.isOutlines()) {
            loads.stream().filter(other -> !other.isOutlines()).toList().forEach(this::leave);
        }
        loads.add(load);
        load.work = opener.submit(() -> read(load));
        changed.run();
    }

    /** The file that has been read for longest and is not read yet. */
    Optional<Path> reading() {
        return loads.stream().findFirst().map(load -> load.file);
    }

    /** Leaves all files that are still being read: nothing comes of them. */
    void leaveAll() {
        List.copyOf(loads).forEach(this::leave);
        changed.run();
    }

    private void leave(Load load) {
        loads.remove(load);
        load.work.cancel(true);
    }

    private void read(Load load) {
        try {
            if (load.isOutlines()) {
                String name = load.file.getFileName().toString();
                OutlineLayer layer = new OutlineLayer(name, GeoJson.read(load.file));
                done(load, () -> outlines.accept(layer), () -> {});
            } else {
                MbTiles source = MbTiles.open(load.file);
                done(load, () -> tiles.accept(source), () -> close(source));
            }
        } catch (IOException | RuntimeException e) {
            String problem = e.getMessage() == null ? load.file + " cannot be read: " + e : e.getMessage();
            done(load, () -> problems.accept(problem), () -> {});
        }
    }

    /** Hands over what came of a file, unless it was left meanwhile. */
    private void done(Load load, Runnable take, Runnable drop) {
        EventThread.later(() -> {
            if (loads.remove(load)) {
                take.run();
                changed.run();
            } else {
                drop.run();
            }
        });
    }

    private static void close(TileSource source) {
        try {
            source.close();
        } catch (IOException e) {
            // nothing was written to it
        }
    }

    /** Leaves what is being read, and reads no more. */
    void end() {
        leaveAll();
        opener.shutdown();
    }
}
