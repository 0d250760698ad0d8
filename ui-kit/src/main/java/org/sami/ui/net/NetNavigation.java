package org.sami.ui.net;

import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;

/** Moves the view over a net: to all of it, to what is to be seen, from vertex to vertex, and by keys. On the event thread. */
final class NetNavigation {
    private static final double PAN_PX = 80;
    private static final double STEP = 1.25;
    /** The least size at which the words of a net are read. */
    private static final double READABLE_ZOOM = 0.8;

    private static final double NET_MARGIN_PX = 24;
    /** Room around what is followed, in parts of the view's lesser side. */
    private static final double FOLLOW_MARGIN = 0.2;

    private final NetView view;
    private final NetViewport viewport;
    private final NetOverview overview;
    private boolean toBegin;
    private boolean following;
    private Set<String> followed = Set.of();

    NetNavigation(NetView view, NetViewport viewport, NetOverview overview) {
        this.view = view;
        this.viewport = viewport;
        this.overview = overview;
    }

    void fit() {
        toBegin = false;
        viewport.fit(view.scene().shownBounds());
        viewport.settle();
    }

    void setFollowing(boolean following) {
        this.following = following;
        begin();
    }

    /** Shows a plan for the first time, as soon as the view has a size. */
    void begin() {
        followed = view.marking().tokens().keySet();
        toBegin = view.getWidth() == 0 || view.getHeight() == 0;
        if (toBegin) {
            return;
        }
        fit();
        if (following && viewport.zoom() < READABLE_ZOOM) {
            viewport.setZoom(READABLE_ZOOM);
            showAmidst(followed);
        }
        viewport.settle();
    }

    /** The view has a size now, perhaps another one, and the scale of the look may be another. */
    void laidOut() {
        boolean settled = viewport.isSettled();
        viewport.takeScaleOfLook();
        if (toBegin) {
            begin();
        } else if (settled) {
            if (following) {
                showAmidst(followed);
            }
            viewport.settle();
        }
    }

    /**
     * Shows places whose tokens have changed with room around them, where somebody watches a mission and has not moved the view since
     * all of the net was shown last.
     */
    void follow(NetMarking before) {
        Set<String> changed = view.marking().newIn(before);
        if (following && !toBegin && viewport.isSettled() && !changed.isEmpty()) {
            followed = changed;
            showAmidst(changed);
            viewport.settle();
        }
    }

    /** Moves vertices with their words into the middle, unless all of that is seen with room around it already. */
    private void showAmidst(Set<String> ids) {
        NetScene scene = view.scene();
        scene.boxWithWords(ids)
                .filter(viewport::holds)
                .or(() -> scene.boxOf(ids).filter(viewport::holds))
                .or(() -> scene.vertices().stream()
                        .map(Vertex::id)
                        .filter(ids::contains)
                        .findFirst()
                        .flatMap(id -> scene.boxOf(Set.of(id)))) // of places that lie too far apart, one is seen
                .filter(box -> !isSeenWithRoom(box))
                .ifPresent(this::showAmidstNet);
    }

    /** Shows a box in the middle, or as near to it as possible without showing space outside the net while a part of the net is hidden. */
    private void showAmidstNet(DrawingBox box) {
        DrawingBox net = view.scene().shownBounds().union(box).grown(NET_MARGIN_PX / viewport.scale());
        Rectangle2D shown = viewport.shown();
        viewport.centre(
                middle(box.x() + box.width() / 2, shown.getWidth(), net.x(), net.maxX()),
                middle(box.y() + box.height() / 2, shown.getHeight(), net.y(), net.maxY()));
    }

    /** The middle of the shown part of a range, as near to a point of it as possible without showing space outside the range; the range's own middle where all of it has room. */
    private static double middle(double point, double shown, double from, double to) {
        return to - from <= shown ? (from + to) / 2 : Math.max(from + shown / 2, Math.min(to - shown / 2, point));
    }

    /** Whether a box is seen and what lies around it in the net as well. */
    private boolean isSeenWithRoom(DrawingBox box) {
        double room =
                FOLLOW_MARGIN * Math.min(view.canvas().getWidth(), view.canvas().getHeight()) / viewport.scale();
        return isSeen(pixels(box.grown(room))
                .createIntersection(pixels(view.scene().shownBounds().union(box))));
    }

    void reveal(Set<String> ids) {
        if (!toBegin) {
            view.scene().boxOfLabels(ids).ifPresent(viewport::reveal);
            view.scene().boxOf(ids).ifPresent(viewport::reveal); // last, as in a small view not all words fit
        }
    }

    void revealWhole(Set<String> ids) {
        if (!toBegin) {
            view.scene().boxWithWords(ids).filter(box -> !isSeen(pixels(box))).ifPresent(viewport::showWhole);
        }
    }

    void revealReadable(Set<String> ids) {
        if (!toBegin && view.scene().boxOf(ids).isPresent()) {
            if (viewport.zoom() < READABLE_ZOOM) {
                viewport.setZoom(READABLE_ZOOM);
            }
            showAmidst(ids);
        }
    }

    private Rectangle2D pixels(DrawingBox box) {
        Rectangle2D pixels = new Rectangle2D.Double();
        pixels.setFrameFromDiagonal(viewport.pixel(box.x(), box.y()), viewport.pixel(box.maxX(), box.maxY()));
        return pixels;
    }

    /** Whether all of a rectangle is in the view, and none of it below the overview. */
    private boolean isSeen(Rectangle2D pixels) {
        return view.canvas().getBounds().contains(pixels)
                && !(overview.isVisible() && pixels.intersects(overview.getBounds()));
    }

    /** Shows the first of some vertices in the middle where it is not seen. */
    void centreFirst(Set<String> ids) {
        view.drawing().vertices().stream()
                .filter(vertex -> ids.contains(vertex.id()))
                .findFirst()
                .ifPresent(this::centre);
    }

    /** Shows a vertex in the middle where it is not seen. */
    private void centre(Vertex vertex) {
        if (!viewport.shown().contains(vertex.centre().x(), vertex.centre().y())) {
            viewport.centre(vertex.centre().x(), vertex.centre().y());
        }
    }

    void press(NetKey key) {
        double x = view.canvas().getWidth() / 2.0;
        double y = view.canvas().getHeight() / 2.0;
        switch (key) {
            case LEFT -> viewport.pan(-PAN_PX, 0);
            case RIGHT -> viewport.pan(PAN_PX, 0);
            case UP -> viewport.pan(0, -PAN_PX);
            case DOWN -> viewport.pan(0, PAN_PX);
            case ZOOM_IN -> viewport.scale(STEP, x, y);
            case ZOOM_OUT -> viewport.scale(1 / STEP, x, y);
            case ACTUAL_SIZE -> viewport.setZoom(1);
            case FIT -> fit();
            case NEXT -> step(1);
            case PREVIOUS -> step(-1);
            case OPEN -> view.selected().stream().findFirst().ifPresent(view::tellOpened);
            case CLEAR -> view.select(Set.of());
            case OVERVIEW -> view.toggleOverview();
            case MODE -> view.setMode(view.mode().next());
        }
    }

    /** Selects the vertex so many behind the last of those that are selected, of those that the mode shows. */
    private void step(int by) {
        Set<Vertex> shown = new HashSet<>(view.scene().vertices());
        shown.addAll(view.scene().silhouettes());
        List<Vertex> vertices = new ArrayList<>(view.drawing().vertices());
        vertices.retainAll(shown);
        if (vertices.isEmpty()) {
            return;
        }
        List<String> ids = vertices.stream().map(Vertex::id).toList();
        int now = view.selected().stream().mapToInt(ids::indexOf).max().orElse(-1);
        Vertex next = vertices.get(Math.floorMod(now < 0 && by < 0 ? -1 : now + by, vertices.size()));
        view.select(new LinkedHashSet<>(Set.of(next.id())));
        centre(next);
    }
}
