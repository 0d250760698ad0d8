package org.sami.ui.net;

import java.awt.geom.AffineTransform;
import java.awt.geom.NoninvertibleTransformException;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import org.sami.spn.drawing.DrawingBox;
import org.sami.ui.look.Look;

/** Which part of a net a viewer shows, and how large: the transformation of its view. */
final class NetViewport {
    private static final double LEAST = 0.05;
    private static final double MOST = 4;
    private static final double MARGIN = 24;

    private final NetViewer viewer;
    private final Runnable changed;
    private double own = Look.scalePercent() / 100.0;
    private DrawingBox fitted = new DrawingBox(0, 0, 0, 0);
    private AffineTransform afterFit = new AffineTransform();
    private AffineTransform settled = new AffineTransform();

    /**
     * Makes the viewport of a viewer.
     *
     * @param changed is run after another part is shown
     */
    NetViewport(NetViewer viewer, Runnable changed) {
        this.viewer = viewer;
        this.changed = changed;
    }

    /** How many pixels a drawing unit has. */
    double scale() {
        return viewer.view().getScaleX();
    }

    /** How many it has at the net's own size. */
    double own() {
        return own;
    }

    /** How large the net is shown, 1 at its own size. */
    double zoom() {
        return scale() / own;
    }

    /**
     * Takes the scale of the look, so that the net's letters stay as large as those around it. A box that was fitted into the view is
     * fitted again; else what is in the middle stays there.
     */
    void takeScaleOfLook() {
        double next = Look.scalePercent() / 100.0;
        if (next == own) {
            return;
        }
        double zoom = zoom();
        boolean untouched = viewer.view().equals(afterFit);
        own = next;
        if (untouched) {
            fit(fitted);
        } else {
            setZoom(zoom);
        }
    }

    /** Notes what is shown as not moved by hand. */
    void settle() {
        settled = new AffineTransform(viewer.view());
    }

    /** Whether what is shown has not been moved since {@link #settle}. */
    boolean isSettled() {
        return viewer.view().equals(settled);
    }

    /** Whether a box is not larger than what is shown. */
    boolean holds(DrawingBox box) {
        Rectangle2D shown = shown();
        return box.width() <= shown.getWidth() && box.height() <= shown.getHeight();
    }

    void setZoom(double zoom) {
        scale(zoom / zoom(), viewer.getWidth() / 2.0, viewer.getHeight() / 2.0);
    }

    /** Shows all larger or smaller by a factor; what is at a pixel stays there. */
    void scale(double factor, double px, double py) {
        double bounded = Math.max(LEAST, Math.min(MOST, zoom() * factor)) / zoom();
        AffineTransform change = AffineTransform.getTranslateInstance(px, py);
        change.scale(bounded, bounded);
        change.translate(-px, -py);
        viewer.view().preConcatenate(change);
        viewer.repaint();
        changed.run();
    }

    /** Moves what is shown by some pixels. */
    void pan(double dx, double dy) {
        viewer.view().preConcatenate(AffineTransform.getTranslateInstance(-dx, -dy));
        viewer.repaint();
        changed.run();
    }

    /** Shows a box in the middle, as large as it fits, and not larger than its own size. */
    void fit(DrawingBox box) {
        double width = Math.max(1, viewer.getWidth() - 2 * MARGIN);
        double height = Math.max(1, viewer.getHeight() - 2 * MARGIN);
        double scale = Math.max(
                LEAST * own,
                Math.min(own, Math.min(width / Math.max(1, box.width()), height / Math.max(1, box.height()))));
        show(box.x() + box.width() / 2, box.y() + box.height() / 2, scale);
        fitted = box;
        afterFit = new AffineTransform(viewer.view());
    }

    /** Shows a point of the drawing in the middle. */
    void centre(double x, double y) {
        show(x, y, scale());
    }

    /** Moves what is shown so far that a box is in it with a margin; its middle where it is larger than that. */
    void reveal(DrawingBox box) {
        Rectangle2D shown = shown();
        double margin = MARGIN / scale();
        double dx = shift(box.x() - margin, box.maxX() + margin, shown.getMinX(), shown.getMaxX());
        double dy = shift(box.y() - margin, box.maxY() + margin, shown.getMinY(), shown.getMaxY());
        if (dx != 0 || dy != 0) {
            centre(shown.getCenterX() + dx, shown.getCenterY() + dy);
        }
    }

    /** Shows a box in the middle with a margin, and smaller only where it does not fit otherwise. */
    void showWhole(DrawingBox box) {
        DrawingBox withMargin = box.grown(MARGIN / scale());
        Rectangle2D shown = shown();
        if (withMargin.width() <= shown.getWidth() && withMargin.height() <= shown.getHeight()) {
            centre(box.x() + box.width() / 2, box.y() + box.height() / 2);
        } else {
            fit(box);
        }
    }

    /** How far a range has to move to hold another. */
    private static double shift(double from, double to, double shownFrom, double shownTo) {
        if (to - from > shownTo - shownFrom) {
            return (from + to - shownFrom - shownTo) / 2;
        }
        return from < shownFrom ? from - shownFrom : Math.max(0, to - shownTo);
    }

    private void show(double x, double y, double scale) {
        viewer.view().setToIdentity();
        AffineTransform view = AffineTransform.getTranslateInstance(viewer.getWidth() / 2.0, viewer.getHeight() / 2.0);
        view.scale(scale, scale);
        view.translate(-x, -y);
        viewer.view().preConcatenate(view);
        viewer.repaint();
        changed.run();
    }

    /** The point of the drawing at a pixel. */
    Point2D point(double px, double py) {
        try {
            return viewer.view().inverseTransform(new Point2D.Double(px, py), null);
        } catch (NoninvertibleTransformException e) {
            throw new IllegalStateException("a net is never shown at the scale 0", e);
        }
    }

    /** The pixel of a point of the drawing. */
    Point2D pixel(double x, double y) {
        return viewer.view().transform(new Point2D.Double(x, y), null);
    }

    /** What is shown, in drawing units. */
    Rectangle2D shown() {
        Point2D corner = point(0, 0);
        Point2D opposite = point(viewer.getWidth(), viewer.getHeight());
        Rectangle2D shown = new Rectangle2D.Double();
        shown.setFrameFromDiagonal(corner, opposite);
        return shown;
    }
}
