package org.sami.ui.map;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.BiConsumer;
import org.jspecify.annotations.Nullable;
import org.sami.ui.EventThread;
import org.sami.ui.map.base.BaseSource;
import org.sami.ui.map.base.MapFileLimits;
import org.sami.ui.map.base.MbTiles;
import org.sami.ui.map.base.OutlineSource;

/**
 * Opens files of base maps off the event thread, and hands over there what they hold or what is wrong with them. A file may take its time, or
 * never be read: nobody waits for it, and it can be left. On the event thread.
 */
final class BaseMapLoader {
    private final BiConsumer<Path, BaseSource> sources;
    private final BiConsumer<Path, String> problems;
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
        private @Nullable Future<?> work;

        Load(Path file) {
            this.file = file;
        }
    }

    /**
     * A loader that reads nothing yet.
     *
     * @param sources is handed what was read
     * @param problems receives, in one line, what is wrong with a file
     * @param changed is run when a file is begun, was read or was left
     */
    BaseMapLoader(BiConsumer<Path, BaseSource> sources, BiConsumer<Path, String> problems, Runnable changed) {
        this.sources = sources;
        this.problems = problems;
        this.changed = changed;
    }

    /** Whether a file of that name holds outlines; else it holds tiles. */
    static boolean isOutlines(Path file) {
        String name = file.toString().toLowerCase(Locale.ROOT);
        return name.endsWith(".json") || name.endsWith(".geojson");
    }

    /** Begins to read a file. There is one map of tiles: others that are still being read are left, as is the same file. */
    void open(Path file) {
        Load load = new Load(file);
        loads.stream()
                .filter(other -> other.file.equals(file) || (!isOutlines(file) && !isOutlines(other.file)))
                .toList()
                .forEach(this::leave);
        loads.add(load);
        load.work = opener.submit(() -> read(load));
        changed.run();
    }

    /** The file that has been read for longest and is not read yet. */
    Optional<Path> reading() {
        return loads.stream().findFirst().map(load -> load.file);
    }

    /** Leaves a file that is still being read, if it is. */
    void leave(Path file) {
        loads.stream().filter(load -> load.file.equals(file)).toList().forEach(this::leave);
        changed.run();
    }

    /** Leaves all files that are still being read: nothing comes of them. */
    void leaveAll() {
        List.copyOf(loads).forEach(this::leave);
        changed.run();
    }

    private void leave(Load load) {
        loads.remove(load);
        Objects.requireNonNull(load.work, "a load that is left has begun").cancel(true);
    }

    private void read(Load load) {
        try {
            BaseSource source = isOutlines(load.file)
                    ? OutlineSource.read(load.file, MapFileLimits.OF_A_FILE)
                    : MbTiles.open(load.file);
            done(load, () -> sources.accept(load.file, source), () -> close(source));
        } catch (IOException | RuntimeException e) {
            String problem = e.getMessage() == null ? load.file + " cannot be read: " + e : e.getMessage();
            done(load, () -> problems.accept(load.file, problem), () -> {});
        } catch (OutOfMemoryError full) {
            done(load, () -> problems.accept(load.file, load.file + " needs more memory than there is"), () -> {});
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

    private static void close(BaseSource source) {
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
