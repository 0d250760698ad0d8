package org.sami.crw.gui.picture;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.markup.MapRelevance;
import org.sami.crw.operator.picture.PanoramaPictures;
import org.sami.picture.photo.Photo;

/** The pictures of a window's session, for all panels that show some. On the event thread. */
public final class ShownPictures implements AutoCloseable {
    private final OperatorContext context;
    private final PhotoLoader loader = new PhotoLoader(this::changed);
    private final List<Runnable> listeners = new ArrayList<>();
    private Consumer<PictureChoice> opener = choice -> {};

    /** Those of a window's session. */
    public ShownPictures(OperatorContext context) {
        this.context = context;
        context.models().pictures().addListener(pictures -> changed());
    }

    /** Calls a listener when there are other pictures, or one has been read. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    private void changed() {
        listeners.forEach(Runnable::run);
    }

    /** All that there are, the oldest first. */
    List<PanoramaPictures> all() {
        return context.models().pictures().snapshot();
    }

    /** Those that a message or a decision shows, which came at that time. */
    public List<PictureChoice> with(MapRelevance map, long atMillis) {
        List<PictureChoice> shown = new ArrayList<>();
        for (PanoramaPictures each : PanoramaPictures.shownWith(all(), map, atMillis)) {
            shown.addAll(PictureChoice.of(each));
        }
        return shown;
    }

    /** The newest picture of a robot: of those that are here, else of those that may come; empty where there is none. */
    public Optional<PictureChoice> newest(String robot) {
        List<PictureChoice> taken = all().stream()
                .filter(each -> each.boat().equals(robot))
                .flatMap(each -> PictureChoice.of(each).stream())
                .toList();
        return last(taken, one -> one.picture().file().isPresent())
                .or(() -> last(taken, one -> one.picture().isComing()));
    }

    private static Optional<PictureChoice> last(List<PictureChoice> taken, Predicate<PictureChoice> which) {
        return taken.stream().filter(which).reduce((earlier, later) -> later);
    }

    /** A picture that fits into a box of pixels; empty while it is being read. */
    Optional<Photo> photo(Path file, int widthPx, int heightPx) {
        return loader.photo(file, widthPx, heightPx);
    }

    /** Shows a picture large. */
    public void open(PictureChoice choice) {
        opener.accept(choice);
    }

    void onOpen(Consumer<PictureChoice> shows) {
        opener = shows;
    }

    @Override
    public void close() {
        loader.close();
    }
}
