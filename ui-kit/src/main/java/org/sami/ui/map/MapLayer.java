package org.sami.ui.map;

import java.util.Objects;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;

/**
 * One layer of a map: what it shows is set by its owner on the event thread, and painted at once. What stays as it is while vehicles move is
 * painted by {@link #paintStill}, below all that moves, and kept until the layer says {@link #stillChanged}.
 */
public abstract class MapLayer {
    private final String id;
    private final String title;
    private boolean visible = true;
    private Runnable listener = () -> {};
    private long stillRevision;

    /**
     * Makes a layer that is shown.
     *
     * @param id stable, unique on its map
     * @param title what people call it
     */
    protected MapLayer(String id, String title) {
        this.id = Objects.requireNonNull(id, "id");
        this.title = Objects.requireNonNull(title, "title");
    }

    /** Its stable id. */
    public final String id() {
        return id;
    }

    /** What people call it. */
    public final String title() {
        return title;
    }

    /** Whether it is shown. */
    public final boolean isVisible() {
        return visible;
    }

    /** Shows or hides it. */
    public final void setVisible(boolean visible) {
        if (this.visible != visible) {
            this.visible = visible;
            stillChanged();
        }
    }

    /** Has the map painted again; of this layer what moves. */
    protected final void changed() {
        listener.run();
    }

    /** Has the map painted again with all of this layer. */
    protected final void stillChanged() {
        stillRevision++;
        listener.run();
    }

    /** Grows when what is kept of this layer is to be painted again. */
    final long stillRevision() {
        return stillRevision;
    }

    final void listen(Runnable listener) {
        this.listener = listener;
    }

    /** Paints what stays as it is while vehicles move, if there is something. */
    protected void paintStill(MapPaint paint) {}

    /** Paints what moves, if something does. */
    protected void paint(MapPaint paint) {}

    /** Writes names, after all layers were painted: those of the topmost layer first, so that others make room for them. */
    protected void paintNames(MapPaint paint) {}

    /** The box around what it shows; none where it has no place of its own. */
    public Optional<GeoBounds> bounds() {
        return Optional.empty();
    }

    /** The id of what lies at a pixel; none where nothing can be chosen there. */
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return Optional.empty();
    }

    /** One line about a pixel, such as a value with its unit; none where there is nothing to show. */
    public Optional<String> textAt(MapFrame frame, double px, double py) {
        return Optional.empty();
    }

    /** Offers what a pointer may snap to. */
    public void offer(Snapping snapping) {}
}
