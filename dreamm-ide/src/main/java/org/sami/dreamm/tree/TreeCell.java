package org.sami.dreamm.tree;

import java.awt.Component;
import java.util.function.Predicate;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTree;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreeCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.SemanticColor;

/** Shows a line of the mission tree: icon, title, and its detail in less weight. The open plan stands out. */
final class TreeCell extends JPanel implements TreeCellRenderer {
    private final transient Predicate<TreeItem> open;
    private final JLabel title = new JLabel();
    private final JLabel detail = new JLabel();

    TreeCell(Predicate<TreeItem> open) {
        super(new MigLayout("insets 2 4 2 8, gap 8", "[][]", "[]"));
        this.open = open;
        setOpaque(false);
        add(title);
        add(detail);
    }

    @Override
    public Component getTreeCellRendererComponent(
            JTree tree, Object value, boolean selected, boolean expanded, boolean leaf, int row, boolean focused) {
        if (value instanceof DefaultMutableTreeNode node && node.getUserObject() instanceof TreeItem item) {
            title.setText(item.title().isEmpty() ? "(no name)" : item.title());
            title.setIcon(Icons.small(item.kind().icon()));
            title.setFont(open.test(item) ? Fonts.strong() : Fonts.text());
            detail.setText(item.detail());
            detail.setFont(Fonts.small());
            getAccessibleContext().setAccessibleName(item.title() + " " + item.detail());
        }
        boolean marked = selected && tree.hasFocus(); // without the focus a selection is a pale grey in every theme
        title.setForeground((marked ? SemanticColor.ON_SELECTION : SemanticColor.TEXT).get());
        detail.setForeground((marked ? SemanticColor.ON_SELECTION : SemanticColor.MUTED).get());
        return this;
    }
}
