package org.sami.dreamm.tree;

import java.awt.Component;
import java.awt.FontMetrics;
import java.util.function.Predicate;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.plaf.basic.BasicTreeUI;
import javax.swing.tree.DefaultMutableTreeNode;
import javax.swing.tree.TreeCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.ElidedText;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Icons;
import org.sami.ui.look.LookColors;

/**
 * Shows a line of the mission tree: icon, title, and its detail in less weight. The open plan stands out. Where the tree is narrow, the detail
 * is left out first, then the middle of the title; the tree's tooltip says the whole.
 */
final class TreeCell extends JPanel implements TreeCellRenderer {
    private static final int LEFT = 4;
    private static final int RIGHT = 8;
    private static final int GAP = 8;

    private final transient Predicate<TreeItem> open;
    private final JLabel title = new JLabel();
    private final JLabel detail = new JLabel();

    TreeCell(Predicate<TreeItem> open) {
        super(new MigLayout("insets 2 " + LEFT + " 2 " + RIGHT + ", gap " + GAP + ", hidemode 3", "[][]", "[]"));
        this.open = open;
        setOpaque(false);
        add(title);
        add(detail);
    }

    @Override
    public Component getTreeCellRendererComponent(
            JTree tree, Object value, boolean selected, boolean expanded, boolean leaf, int row, boolean focused) {
        if (value instanceof DefaultMutableTreeNode node && node.getUserObject() instanceof TreeItem item) {
            title.setIcon(Icons.small(item.kind().icon()));
            title.setFont(open.test(item) ? Fonts.strong() : Fonts.text());
            detail.setFont(Fonts.small());
            show(item, room(tree, node.getLevel()));
            getAccessibleContext().setAccessibleName(item.title() + " " + item.detail());
        }
        boolean marked = selected && tree.hasFocus(); // without the focus a selection is a pale grey in every theme
        LookColors.foreground(title, marked ? SemanticColor.ON_SELECTION : SemanticColor.TEXT);
        LookColors.foreground(detail, marked ? SemanticColor.ON_SELECTION : SemanticColor.MUTED);
        return this;
    }

    private void show(TreeItem item, int room) {
        title.setText(item.title().isEmpty() ? "(no name)" : item.title());
        detail.setText(item.detail());
        detail.setVisible(!item.detail().isEmpty());
        if (getPreferredSize().width > room) {
            detail.setVisible(false);
        }
        int over = getPreferredSize().width - room;
        if (over > 0) {
            FontMetrics metrics = title.getFontMetrics(title.getFont());
            title.setText(ElidedText.middle(title.getText(), metrics, metrics.stringWidth(title.getText()) - over));
            title.invalidate();
            invalidate(); // else the layout, which has not been laid out since, keeps the width of the whole title
        }
    }

    /** How wide a line may be; as wide as it wants before the tree has a size. */
    private static int room(JTree tree, int level) {
        if (!(tree.getParent() instanceof JViewport viewport)
                || viewport.getWidth() == 0
                || !(tree.getUI() instanceof BasicTreeUI ui)) {
            return Integer.MAX_VALUE;
        }
        int step = ui.getLeftChildIndent() + ui.getRightChildIndent();
        return viewport.getWidth() - (level + 1) * step - tree.getInsets().left - tree.getInsets().right;
    }
}
