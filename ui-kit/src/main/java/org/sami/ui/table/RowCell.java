package org.sami.ui.table;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Insets;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JTable;
import javax.swing.SwingConstants;
import javax.swing.plaf.basic.BasicGraphicsUtils;
import javax.swing.table.DefaultTableCellRenderer;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** Draws the cells of a {@link RowTable}: words in as many lines as they need, numbers at the right in one. */
final class RowCell<R> extends DefaultTableCellRenderer {
    private static final int LEAST_HEIGHT = 30;
    private static final int PADDING = 12;

    private List<String> lines = List.of();

    /**
     * Makes it the cell of a row and column.
     *
     * @param most how many lines it has at most
     */
    void show(JTable view, RowColumn<R> column, R row, boolean selected, int width, int most) {
        super.getTableCellRendererComponent(view, "", selected, false, 0, 0);
        setHorizontalAlignment(column.right() ? SwingConstants.RIGHT : SwingConstants.LEFT);
        LookColors.foreground(
                this, selected ? SemanticColor.ON_SELECTION : column.color().apply(row));
        LookColors.background(this, selected ? SemanticColor.SELECTION : SemanticColor.SURFACE);
        setIcon(column.icon().apply(row).orElse(null));
        setIconTextGap(Spacing.NORMAL); // labels scale it
        setBorder(BorderFactory.createEmptyBorder(0, Look.px(Spacing.NORMAL), 0, Look.px(Spacing.NORMAL)));
        String text = column.text().apply(row);
        lines = lines(view, column, row, width, most);
        setText(lines.size() > 1 ? "" : lines.get(0));
        getAccessibleContext().setAccessibleName(text);
    }

    /** How high a row of so many lines is in a table, in pixels. */
    static int height(JTable view, int lines) {
        return heightOf(lines, view.getFontMetrics(view.getFont()));
    }

    /** How high a row of one line is, in pixels. */
    static int leastHeight() {
        return Look.px(Look.hasHighRows() ? Spacing.HIT_TARGET_FIELD : LEAST_HEIGHT);
    }

    private static int heightOf(int lines, FontMetrics metrics) {
        return Math.max(leastHeight(), lines * metrics.getHeight() + Look.px(PADDING));
    }

    /** The lines of a cell; one at least, and one of a number. */
    static <R> List<String> lines(JTable view, RowColumn<R> column, R row, int width, int most) {
        String text = column.text().apply(row);
        if (column.right()) {
            return List.of(text);
        }
        int icon = column.icon()
                .apply(row)
                .map(Icon::getIconWidth)
                .map(wide -> wide + Look.px(Spacing.NORMAL))
                .orElse(0);
        int room = Math.max(1, width - icon - 2 * Look.px(Spacing.NORMAL));
        if (most == 1 && column.cutInside()) {
            return List.of(TextLines.withEnd(text, view.getFontMetrics(view.getFont()), room));
        }
        return TextLines.of(text, view.getFontMetrics(view.getFont()), room, most);
    }

    @Override
    public Dimension getPreferredSize() {
        if (lines.size() < 2) {
            return super.getPreferredSize();
        }
        FontMetrics metrics = getFontMetrics(getFont());
        int widest = lines.stream().mapToInt(metrics::stringWidth).max().orElse(0);
        return new Dimension(left() + widest + getInsets().right, heightOf(lines.size(), metrics));
    }

    /** Where words begin. */
    private int left() {
        Icon icon = getIcon();
        return getInsets().left + (icon == null ? 0 : icon.getIconWidth() + Look.px(Spacing.NORMAL));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        if (lines.size() < 2) {
            return;
        }
        Graphics2D g = (Graphics2D) graphics;
        g.setFont(getFont());
        g.setColor(getForeground());
        FontMetrics metrics = g.getFontMetrics();
        Insets insets = getInsets();
        int y = insets.top
                + (getHeight() - insets.top - insets.bottom - lines.size() * metrics.getHeight()) / 2
                + metrics.getAscent();
        for (String line : lines) {
            BasicGraphicsUtils.drawString(this, g, line, left(), y);
            y += metrics.getHeight();
        }
    }
}
