package org.sami.dreamm.tree;

import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.Enumeration;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.DropMode;
import javax.swing.JTree;
import javax.swing.ToolTipManager;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.DefaultTreeModel;
import javax.swing.tree.TreeNode;
import javax.swing.tree.TreePath;
import javax.swing.tree.TreeSelectionModel;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.tree.TreeItem.Kind;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.Plan;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** The tree of lines. What is open and selected stays so through edits. */
final class MissionTreeView extends JTree {
    private static final int ROW = 26;

    private final transient DreammContext context;
    private boolean filling;

    MissionTreeView(DreammContext context) {
        super(new DefaultMutableTreeNode());
        this.context = context;
        setName("mission-tree-lines");
        getAccessibleContext().setAccessibleName("Mission tree");
        getSelectionModel().setSelectionMode(TreeSelectionModel.SINGLE_TREE_SELECTION);
        setCellRenderer(new TreeCell(this::isOpen));
        setShowsRootHandles(true);
        ToolTipManager.sharedInstance().registerComponent(this);
        setToggleClickCount(0);
        setDragEnabled(!GraphicsEnvironment.isHeadless() && context.profile().allows("plan-move"));
        setDropMode(DropMode.ON_OR_INSERT);
        // Swing paints where the drop was once it is over: the lines may change only then.
        setTransferHandler(new TreeDrop((moved, parent, index) -> EventThread.later(
                () -> context.apply(PlanTree.move(context.document().project(), moved, parent, index)))));
        addTreeSelectionListener(e -> {
            if (!filling) {
                selected().ifPresent(this::showItem);
                context.commands().refresh();
            }
        });
        fill();
        style();
    }

    private boolean isOpen(TreeItem item) {
        return item.kind() == Kind.PLAN && context.editor().planId().equals(Optional.of(item.plan()));
    }

    /** Shows a line's plan, and the place of a sub-mission. */
    private void showItem(TreeItem item) {
        if (item.kind() == Kind.SUB_MISSION) {
            Plan plan = context.document().plan(item.plan()).orElseThrow();
            context.editor().open(item.plan(), Set.of(ProjectSearch.shown(plan, item.id())));
        } else if (!item.plan().isEmpty()) {
            context.editor().open(item.plan());
        }
    }

    /** The line that is selected. */
    Optional<TreeItem> selected() {
        return getSelectionPath() == null ? Optional.empty() : item(getSelectionPath());
    }

    private static Optional<TreeItem> item(TreePath path) {
        return path.getLastPathComponent() instanceof DefaultMutableTreeNode node
                        && node.getUserObject() instanceof TreeItem item
                ? Optional.of(item)
                : Optional.empty();
    }

    /** Lines are shortened to the width that is seen: they are measured again when that changes. */
    private void remeasure() {
        firePropertyChange(CELL_RENDERER_PROPERTY, null, getCellRenderer());
    }

    /** Shows the project as it is now. */
    void fill() {
        Set<String> expanded = new HashSet<>();
        for (int row = 0; row < getRowCount(); row++) {
            if (isExpanded(row)) {
                item(getPathForRow(row)).ifPresent(item -> expanded.add(item.key()));
            }
        }
        Optional<String> selected = selected().map(TreeItem::key);
        TreeItem root = PlanTree.of(context.document().project());
        expanded.add(root.key());
        filling = true;
        setModel(new DefaultTreeModel(node(root)));
        for (TreePath path : paths()) {
            TreeItem item = item(path).orElseThrow();
            if (expanded.contains(item.key()) || (item.kind() == Kind.FOLDER && expanded.size() == 1)) {
                expandPath(path);
            }
            if (selected.equals(Optional.of(item.key()))) {
                setSelectionPath(path);
            }
        }
        filling = false;
    }

    /** Selects the line of the open plan, if none of its lines is selected. */
    void follow() {
        Optional<String> plan = context.editor().planId();
        if (!selected().map(TreeItem::plan).equals(plan)) {
            filling = true;
            paths().stream()
                    .filter(path -> item(path).filter(this::isOpen).isPresent())
                    .findFirst()
                    .ifPresent(path -> {
                        setSelectionPath(path);
                        showRow(path);
                    });
            filling = false;
        }
        repaint();
    }

    /** Brings a line into sight from its beginning, however long it is. */
    private void showRow(TreePath path) {
        Rectangle bounds = getPathBounds(path);
        if (bounds != null) {
            scrollRectToVisible(new Rectangle(0, bounds.y, 1, bounds.height));
        }
    }

    @Override
    public @Nullable String getToolTipText(MouseEvent e) {
        TreePath path = getPathForLocation(e.getX(), e.getY());
        return path == null
                ? null
                : item(path)
                        .map(item -> item.title() + (item.detail().isEmpty() ? "" : " · " + item.detail()))
                        .orElse(null);
    }

    private List<TreePath> paths() {
        List<TreePath> paths = new ArrayList<>();
        Enumeration<TreeNode> nodes = ((DefaultMutableTreeNode) getModel().getRoot()).preorderEnumeration();
        while (nodes.hasMoreElements()) {
            paths.add(new TreePath(((DefaultMutableTreeNode) nodes.nextElement()).getPath()));
        }
        return paths;
    }

    private static DefaultMutableTreeNode node(TreeItem item) {
        DefaultMutableTreeNode node = new DefaultMutableTreeNode(item);
        item.children().forEach(child -> node.add(node(child)));
        return node;
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean another = width != getWidth();
        super.setBounds(x, y, width, height);
        if (another) {
            remeasure();
        }
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        style();
    }

    private void style() {
        setRowHeight(Look.px(ROW));
        LookColors.background(this, SemanticColor.SURFACE);
    }

    /** What the author means by "this": the line of the tree that has the focus; empty where the focus is elsewhere. */
    Optional<TreeItem> focusedItem() {
        return isFocusOwner() ? selected() : Optional.empty();
    }
}
