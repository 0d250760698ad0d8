package org.sami.spn.drawing;

import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.LayoutPoint;

/**
 * Where everything on the drawing of a net lies: x to the right, y downwards, in pixels at scale 1. No label covers a vertex or another
 * label.
 *
 * @param title the plan's name
 * @param scale how many drawing units one unit of the plan's layout is; 1 where the layout is not the author's
 * @param labels of vertices and edges, in no order
 * @param notes those that lie on the drawing
 * @param frames around vertices that belong together, behind all else
 */
public record NetDrawing(
        String title,
        double scale,
        List<Vertex> vertices,
        List<Edge> edges,
        List<Label> labels,
        List<NoteBox> notes,
        List<FrameBox> frames) {
    /** The radius of a place. */
    public static final double PLACE_RADIUS = 24;

    /** The width of a transition's bar. */
    public static final double BAR_WIDTH = 11;

    /** The height of a transition's bar. */
    public static final double BAR_HEIGHT = 52;

    /** What a vertex is. */
    public enum Kind {
        /** A circle. */
        PLACE,
        /** A bar. */
        TRANSITION
    }

    /**
     * A place or a transition.
     *
     * @param start whether the mission begins here
     * @param end whether the mission ends here
     * @param subMission whether it runs sub-missions
     * @param recovery whether its author drew it in recovery mode (thesis, Figure 5.2)
     * @param disabled whether it is left out while the plan is tried
     */
    public record Vertex(
            String id,
            Kind kind,
            LayoutPoint centre,
            boolean start,
            boolean end,
            boolean subMission,
            boolean recovery,
            boolean disabled) {
        /** The box around it. */
        public DrawingBox box() {
            return boxOf(kind, centre);
        }

        /** The same vertex elsewhere. */
        Vertex shifted(double dx, double dy) {
            LayoutPoint there = new LayoutPoint(centre.x() + dx, centre.y() + dy);
            return new Vertex(id, kind, there, start, end, subMission, recovery, disabled);
        }
    }

    /**
     * A line from a vertex to another; an arrow is at its end.
     *
     * @param from the vertex at its first point
     * @param to the vertex at its last point
     * @param unconditional whether it has no condition, or lets nobody in
     */
    public record Edge(
            String id, String from, String to, List<LayoutPoint> points, boolean unconditional, boolean recovery) {
        public Edge {
            points = List.copyOf(points);
        }
    }

    /**
     * A text with its box.
     *
     * @param of id of the vertex or edge that it speaks of
     * @param onLine whether the box lies on the edge, which then is hidden behind it
     */
    public record Label(String of, TextBlock text, double x, double y, boolean onLine) {
        /** What the text takes. */
        public DrawingBox box() {
            return new DrawingBox(x, y, text.width(), text.height());
        }
    }

    /**
     * A note on the drawing.
     *
     * @param index in the plan's list of notes
     */
    public record NoteBox(int index, TextBlock text, double x, double y) {
        private static final double INSET = 8;
        private static final double LEAST = 40;

        /** The sheet, with some room around the text. */
        public DrawingBox box() {
            return new DrawingBox(
                    x, y, Math.max(LEAST, text.width() + 2 * INSET), Math.max(LEAST / 2, text.height() + 2 * INSET));
        }

        /** Where the text begins, from the sheet's left upper corner to the right and downwards. */
        public double inset() {
            return INSET;
        }
    }

    /**
     * A frame around vertices that belong together.
     *
     * @param index in the plan's list of frames
     * @param title in its left upper corner
     */
    public record FrameBox(
            int index, TextBlock title, FrameColor color, double x, double y, double width, double height) {
        private static final double INSET = 8;
        private static final double HEAD = 24;

        /** All of it. */
        public DrawingBox box() {
            return new DrawingBox(x, y, width, height);
        }

        /** The strip along its upper edge, by which it is held. */
        public DrawingBox head() {
            return new DrawingBox(x, y, width, Math.min(height, Math.max(HEAD, title.height() + INSET)));
        }

        /** Where the title is written. */
        public DrawingBox titleBox() {
            return new DrawingBox(x + INSET, y + INSET / 2, title.width(), title.height());
        }

        /** Whether a point is on its rim or in its head: within it, other things are meant. */
        public boolean isHeldAt(double px, double py, double reach) {
            return head().contains(px, py)
                    || (box().grown(reach).contains(px, py)
                            && !box().grown(-reach).contains(px, py));
        }
    }

    /** A drawing without notes and frames. */
    public NetDrawing(String title, double scale, List<Vertex> vertices, List<Edge> edges, List<Label> labels) {
        this(title, scale, vertices, edges, labels, List.of(), List.of());
    }

    public NetDrawing {
        notes = List.copyOf(notes);
        frames = List.copyOf(frames);
        vertices = List.copyOf(vertices);
        edges = List.copyOf(edges);
        labels = List.copyOf(labels);
    }

    /** The box of a vertex with that centre. */
    public static DrawingBox boxOf(Kind kind, LayoutPoint centre) {
        double width = kind == Kind.PLACE ? 2 * PLACE_RADIUS : BAR_WIDTH;
        double height = kind == Kind.PLACE ? 2 * PLACE_RADIUS : BAR_HEIGHT;
        return new DrawingBox(centre.x() - width / 2, centre.y() - height / 2, width, height);
    }

    /** The box around all of it; a box at the origin where the plan is empty. */
    public DrawingBox bounds() {
        DrawingBox bounds = null;
        for (Vertex vertex : vertices) {
            bounds = union(bounds, vertex.box());
        }
        for (Label label : labels) {
            bounds = union(bounds, label.box());
        }
        for (NoteBox note : notes) {
            bounds = union(bounds, note.box());
        }
        for (FrameBox frame : frames) {
            bounds = union(bounds, frame.box());
        }
        for (Edge edge : edges) {
            for (LayoutPoint point : edge.points()) {
                bounds = union(bounds, new DrawingBox(point.x(), point.y(), 0, 0));
            }
        }
        return bounds == null ? new DrawingBox(0, 0, 0, 0) : bounds;
    }

    private static DrawingBox union(@Nullable DrawingBox bounds, DrawingBox box) {
        return bounds == null ? box : bounds.union(box);
    }
}
