package org.sami.ui.net;

import java.util.Optional;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.NetDrawing.Vertex;

/**
 * Where the pointer is on a net.
 *
 * @param x in drawing units
 * @param y in drawing units
 * @param px in pixels of the view
 * @param py in pixels of the view
 * @param vertex under it
 * @param edge under it, where no vertex is
 * @param note under it, where neither is
 * @param frame whose rim or head is under it, where nothing else is
 * @param menu whether it asks for a menu: the right button
 * @param box whether a box is meant: Shift is held
 * @param additive whether it adds to what is selected: Ctrl is held
 * @param clicks how many in a row
 */
public record NetPointer(
        double x,
        double y,
        int px,
        int py,
        Optional<Vertex> vertex,
        Optional<Edge> edge,
        Optional<NoteBox> note,
        Optional<FrameBox> frame,
        boolean menu,
        boolean box,
        boolean additive,
        int clicks) {
    /** The id of what is under it; none where only the canvas is. */
    public Optional<String> element() {
        return vertex.map(Vertex::id).or(() -> edge.map(Edge::id));
    }
}
