package org.sami.ui.map;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.command.Command;
import org.sami.ui.map.base.BaseSource;

/**
 * The base maps below the layers of a map: which there are, which of them are shown, what is still being read, and the command that leaves that. A
 * file that cannot be read changes nothing of what is shown. On the event thread.
 */
final class BaseMaps {
    private static final String ID = "base-";

    private final MapCanvas canvas;
    private final Consumer<String> problems;
    private final Runnable changed;
    private final BaseMapLoader loader;
    private final Command stop;
    private final ReadingNote note;
    private final List<Entry> entries = new ArrayList<>();

    /** A file that is shown, is to be shown, or was shown. */
    private static final class Entry {
        private final Path file;
        private boolean on = true;
        private Optional<BaseLayer> layer = Optional.empty();
        private String problem = "";

        Entry(Path file) {
            this.file = file;
        }

        boolean shows(BaseLayer other) {
            return layer.filter(one -> one.source() == other.source()).isPresent();
        }

        BaseMapState state() {
            String name = layer.map(MapLayer::title).orElse(file.getFileName().toString());
            return new BaseMapState(file, name, on, problem);
        }
    }

    /**
     * The base maps of a canvas, which has none yet.
     *
     * @param problems receives, in one line, what is wrong with a file
     * @param changed is run when there are others, or others are shown
     */
    BaseMaps(MapCanvas canvas, Consumer<String> problems, Runnable changed) {
        this.canvas = canvas;
        this.problems = problems;
        this.changed = changed;
        loader = new BaseMapLoader(this::take, this::refuse, this::look);
        stop = new Command("map-base-stop", "Stop reading the base map", this::stop)
                .withIcon("close")
                .unless(() -> reading().isPresent() ? Optional.empty() : Optional.of("no map file is being read"));
        note = new ReadingNote(this::reading, stop);
        canvas.setLayout(new MigLayout("insets 0"));
        canvas.add(note, "pos 12 12, wmax 100%-24");
    }

    /** Reads a file off the event thread and shows it then. */
    void open(Path file) {
        loader.open(file);
    }

    /** A base map that was there before: it stays on the list also where it cannot be read now. */
    void restore(Path file, boolean on) {
        Entry entry = find(file).orElseGet(() -> add(file));
        entry.on = on;
        if (on) {
            loader.open(file);
        }
    }

    /** Shows or hides one; one that was not read yet is read. */
    void setOn(Path file, boolean on) {
        find(file).ifPresent(entry -> {
            entry.on = on;
            entry.layer.ifPresent(layer -> layer.setOn(on));
            if (on && entry.layer.isEmpty()) {
                loader.open(file);
            } else if (on) {
                hideOtherImagery(entry);
            } else {
                loader.leave(file);
            }
            tell();
        });
    }

    /** Takes one off the list, and closes it. */
    void forget(Path file) {
        loader.leave(file);
        find(file).ifPresent(entry -> {
            entry.layer.ifPresent(this::drop);
            entries.remove(entry);
            tell();
        });
    }

    /** Shows what another map shows now, without reading a file, and nothing else; to be called again when that may have changed. */
    void showThoseOf(BaseMaps other) {
        List<BaseLayer> shown = other.shown();
        entries.stream()
                .filter(entry -> shown.stream().noneMatch(entry::shows))
                .toList()
                .forEach(entry -> {
                    entry.layer.ifPresent(this::drop);
                    entries.remove(entry);
                });
        shown.stream()
                .filter(layer -> entries.stream().noneMatch(entry -> entry.shows(layer)))
                .forEach(layer -> {
                    BaseLayer same =
                            new BaseLayer(layer.id(), layer.file(), layer.source(), false, this::look, problem -> {});
                    add(layer.file()).layer = Optional.of(same);
                    put(same);
                });
    }

    private List<BaseLayer> shown() {
        return entries.stream()
                .flatMap(entry -> entry.layer.stream())
                .filter(MapLayer::isVisible)
                .toList();
    }

    /** All of them, in the order in which they were opened. */
    List<BaseMapState> states() {
        return entries.stream().map(Entry::state).toList();
    }

    private Optional<Entry> find(Path file) {
        return entries.stream().filter(entry -> entry.file.equals(file)).findFirst();
    }

    private Entry add(Path file) {
        Entry entry = new Entry(file);
        entries.add(entry);
        return entry;
    }

    /** The command that leaves what is still being read. */
    Command stopReading() {
        return stop;
    }

    private void stop() {
        if (loader.reading().isPresent()) {
            loader.leaveAll();
        } else { // its tiles come too slowly
            entries.stream()
                    .filter(entry -> entry.layer.filter(BaseLayer::isReading).isPresent())
                    .map(entry -> entry.file)
                    .toList()
                    .forEach(file -> setOn(file, false));
        }
    }

    /** What is being read, in a few words; empty where nothing is. */
    private Optional<String> reading() {
        return loader.reading()
                .map(file -> file.getFileName().toString())
                .or(() -> entries.stream()
                        .flatMap(entry -> entry.layer.stream())
                        .filter(BaseLayer::isReading)
                        .findFirst()
                        .map(layer -> "tiles of " + layer.title()));
    }

    private void take(Path file, BaseSource source) {
        Entry entry = find(file).orElseGet(() -> add(file));
        entry.layer.ifPresent(this::drop);
        entry.on = true;
        entry.problem = "";
        String id = ID + file.getFileName();
        BaseLayer layer = new BaseLayer(
                canvas.layers().find(id).isPresent() ? ID + file : id, file, source, true, this::look, problems);
        entry.layer = Optional.of(layer);
        hideOtherImagery(entry);
        put(layer);
        source.restriction().ifPresent(problems);
        tell();
    }

    /** Imagery lies below all outlines, and one hides another. */
    private void put(BaseLayer layer) {
        canvas.layers().addBelow(layer);
        if (!layer.source().isImagery()) {
            entries.stream()
                    .flatMap(entry -> entry.layer.stream())
                    .filter(other -> other.source().isImagery())
                    .forEach(imagery -> {
                        canvas.layers().remove(imagery);
                        canvas.layers().addBelow(imagery);
                    });
        }
    }

    private void hideOtherImagery(Entry shown) {
        if (shown.layer.filter(layer -> layer.source().isImagery()).isEmpty()) {
            return;
        }
        entries.stream()
                .filter(other -> other != shown && !BaseMapLoader.isOutlines(other.file))
                .forEach(other -> {
                    other.on = false;
                    other.layer.ifPresent(layer -> layer.setOn(false));
                });
    }

    private void refuse(Path file, String problem) {
        find(file).ifPresent(entry -> {
            if (entry.layer.isEmpty()) {
                entry.problem = problem; // it stays on the list: the stick may come back
            }
        });
        problems.accept(problem);
        changed.run();
    }

    private void drop(BaseLayer layer) {
        canvas.layers().remove(layer);
        layer.close();
    }

    private void look() {
        note.look();
    }

    private void tell() {
        look();
        changed.run();
    }

    /** Reads no more, and closes its files. */
    void end() {
        loader.end();
        entries.forEach(entry -> entry.layer.ifPresent(BaseLayer::close));
    }
}
