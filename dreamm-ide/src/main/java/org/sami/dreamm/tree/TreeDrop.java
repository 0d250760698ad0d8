package org.sami.dreamm.tree;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.IOException;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JTree;
import javax.swing.TransferHandler;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreePath;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.tree.TreeItem.Kind;

/** Reorders the mission tree by dragging: plans and folders go between others, or onto one to go below it. */
final class TreeDrop extends TransferHandler {
    private static final DataFlavor FLAVOR = new DataFlavor(TreeItem.class, "a line of the mission tree");

    private final transient Move move;

    /** What moves a line. */
    @FunctionalInterface
    interface Move {
        /**
         * Moves it.
         *
         * @param parent path of the line below which it goes; empty = the project
         * @param index among its new neighbours, after it was taken out
         */
        void move(TreeItem moved, List<Integer> parent, int index);
    }

    TreeDrop(Move move) {
        this.move = Objects.requireNonNull(move, "move");
    }

    @Override
    public int getSourceActions(JComponent c) {
        return MOVE;
    }

    @Override
    protected @Nullable Transferable createTransferable(JComponent c) {
        return c instanceof JTree tree
                ? item(tree.getSelectionPath())
                        .filter(TreeDrop::moves)
                        .map(Dragged::new)
                        .orElse(null)
                : null;
    }

    static boolean moves(TreeItem item) {
        return !item.path().isEmpty();
    }

    private static Optional<TreeItem> item(TreePath path) {
        return path != null
                        && path.getLastPathComponent() instanceof DefaultMutableTreeNode node
                        && node.getUserObject() instanceof TreeItem item
                ? Optional.of(item)
                : Optional.empty();
    }

    @Override
    public boolean canImport(TransferSupport support) {
        return support.isDrop()
                && support.isDataFlavorSupported(FLAVOR)
                && support.getDropLocation() instanceof JTree.DropLocation at
                && item(at.getPath())
                        .filter(below -> below.kind() == Kind.PROJECT || moves(below))
                        .isPresent();
    }

    @Override
    public boolean importData(TransferSupport support) {
        if (!canImport(support)) {
            return false;
        }
        try {
            TreeItem moved = (TreeItem) support.getTransferable().getTransferData(FLAVOR);
            JTree.DropLocation at = (JTree.DropLocation) support.getDropLocation();
            TreeItem parent = item(at.getPath()).orElseThrow();
            int nodes = (int) parent.children().stream().filter(TreeDrop::moves).count();
            int index = at.getChildIndex() < 0 ? nodes : Math.min(at.getChildIndex(), nodes);
            move.move(moved, parent.path(), afterTaken(moved.path(), parent.path(), index));
            return true;
        } catch (UnsupportedFlavorException | IOException foreign) {
            return false;
        }
    }

    /** The index when the line has been taken out from before it among the same neighbours. */
    private static int afterTaken(List<Integer> moved, List<Integer> parent, int index) {
        boolean neighbours = moved.size() == parent.size() + 1
                && moved.subList(0, parent.size()).equals(parent);
        return neighbours && moved.get(moved.size() - 1) < index ? index - 1 : index;
    }

    /** A line on its way; it does not leave the process. */
    private record Dragged(TreeItem item) implements Transferable {
        @Override
        public DataFlavor[] getTransferDataFlavors() {
            return new DataFlavor[] {FLAVOR};
        }

        @Override
        public boolean isDataFlavorSupported(DataFlavor flavor) {
            return FLAVOR.equals(flavor);
        }

        @Override
        public Object getTransferData(DataFlavor flavor) {
            return item;
        }
    }
}
