package org.sami.dreamm.canvas;

import java.awt.Point;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.Optional;
import java.util.Set;
import javax.swing.JComponent;
import javax.swing.TransferHandler;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.net.NetView;

/** Takes what is dragged from a palette onto the net: onto a vertex where the syntax allows it, else as a vertex of its own. */
final class NetDropHandler extends TransferHandler {
    private static final double REACH_PX = 6;

    private final transient NetView view;
    private final transient ShownNet net;
    private final transient NetActions actions;

    NetDropHandler(NetView view, ShownNet net, NetActions actions) {
        this.view = view;
        this.net = net;
        this.actions = actions;
    }

    private Optional<String> vertexAt(LayoutPoint at) {
        return view.scene().vertexAt(at.x(), at.y(), REACH_PX / view.zoom()).map(Vertex::id);
    }

    private Optional<String> edgeAt(LayoutPoint at) {
        return view.scene().edgeAt(at.x(), at.y(), REACH_PX / view.zoom()).map(Edge::id);
    }

    private LayoutPoint at(TransferSupport support) {
        Point pixel = support.getDropLocation().getDropPoint();
        return view.point(pixel.x, pixel.y);
    }

    @Override
    public boolean canImport(TransferSupport support) {
        if (!support.isDrop()
                || !support.isDataFlavorSupported(NetDropTransfer.FLAVOR)
                || actions.whyNotEdit("net-drop").isPresent()) {
            return false;
        }
        LayoutPoint at = at(support);
        Optional<String> vertex = vertexAt(at);
        Optional<String> edge = vertex.isPresent()
                ? Optional.empty()
                : edgeAt(at)
                        .filter(id -> drop(support)
                                .flatMap(drop -> drop.ontoEdge(net.plan(), id))
                                .isPresent());
        Optional<String> whyNot = vertex.flatMap(id -> drop(support).flatMap(drop -> drop.whyNotOnto(net.plan(), id)));
        view.highlight(vertex.or(() -> edge).map(Set::of).orElse(Set.of()));
        whyNot.ifPresent(actions::refuse);
        return whyNot.isEmpty();
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        view.highlight(Set.of());
        LayoutPoint at = at(support);
        Optional<NetDrop> drop = drop(support);
        drop.ifPresent(each -> {
            Optional<String> vertex = vertexAt(at);
            boolean onEdge = vertex.isEmpty()
                    && edgeAt(at).filter(edge -> actions.putOnEdge(each, edge)).isPresent();
            if (!onEdge) {
                actions.put(each, vertex, at);
            }
        });
        view.canvas().requestFocusInWindow();
        return drop.isPresent();
    }

    private static Optional<NetDrop> drop(TransferSupport support) {
        try {
            return Optional.of((NetDrop) support.getTransferable().getTransferData(NetDropTransfer.FLAVOR));
        } catch (UnsupportedFlavorException | IOException e) {
            return Optional.empty(); // not one of ours
        }
    }

    @Override
    public int getSourceActions(JComponent component) {
        return NONE;
    }
}
