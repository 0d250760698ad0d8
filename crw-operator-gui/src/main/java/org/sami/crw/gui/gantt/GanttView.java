package org.sami.crw.gui.gantt;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseEvent;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import javax.swing.JPanel;
import javax.swing.JViewport;
import javax.swing.Scrollable;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import org.sami.crw.gui.gantt.GanttLine.Kind;
import org.sami.crw.operator.gantt.GanttBar;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.look.Spacing;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.TextLines;

/** Paints the lines of the chart below an axis of time, with a line where now is. The axis stays in sight while the lines are scrolled. */
final class GanttView extends JPanel implements Scrollable {
    private static final int ROW = 26;
    private static final int HIGH_ROW = 40;
    private static final int AXIS = 26;
    private static final int INDENT = 14;
    private static final int LEAST_NAMES = 150;
    private static final int MOST_NAMES = 300;
    private static final double NAMES = 0.34; // of the width
    private static final int TICKS = 84;
    private static final int LEAST_BAR = 3;

    private final ProxyMarks marks;
    private List<GanttLine> lines = List.of();
    private GanttAxis axis = new GanttAxis(0, 1, 1);
    private long nowMillis;
    private int selected = -1;

    GanttView(ProxyMarks marks) {
        this.marks = marks;
        setName("gantt-chart");
        setFocusable(true);
        getAccessibleContext().setAccessibleName("Gantt chart of the missions");
        getAccessibleContext().setAccessibleDescription("");
        setToolTipText(""); // made where the pointer is
    }

    /** Shows these lines at a moment. */
    void show(List<GanttLine> next, int line, GanttAxis time, long now) {
        boolean other = next.size() != lines.size();
        if (!next.equals(lines)) {
            getAccessibleContext()
                    .setAccessibleDescription(
                            next.stream().map(GanttLine::label).collect(Collectors.joining("; ")));
        }
        lines = List.copyOf(next);
        selected = line;
        axis = time;
        nowMillis = now;
        if (other) {
            revalidate();
        }
        repaint();
    }

    /** How wide the part with the bars is, in pixels. */
    int timeWidth() {
        return Math.max(1, getWidth() - names() - Look.px(Spacing.NORMAL));
    }

    private int names() {
        return Math.max(Math.min(Look.px(LEAST_NAMES), getWidth() / 2), Math.min(Look.px(MOST_NAMES), (int)
                (NAMES * getWidth())));
    }

    private static int rowHeight() {
        return Look.px(Look.hasHighRows() ? HIGH_ROW : ROW);
    }

    /** The line at a place; -1 where there is none. */
    int lineAt(int y) {
        int line = (y - Look.px(AXIS)) / rowHeight();
        return y - top() < Look.px(AXIS) || line >= lines.size() ? -1 : line;
    }

    /** Brings a line into sight. */
    void reveal(int line) {
        scrollRectToVisible(new Rectangle(0, line * rowHeight(), 1, rowHeight() + Look.px(AXIS)));
    }

    private int top() {
        return SwingUtilities.getAncestorOfClass(JViewport.class, this) instanceof JViewport port
                ? port.getViewPosition().y
                : 0;
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(LEAST_NAMES * 2), Look.px(AXIS) + lines.size() * rowHeight());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(SemanticColor.SURFACE.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        List<Long> ticks = axis.ticks(Look.px(TICKS));
        for (int i = 0; i < lines.size(); i++) {
            paintRow(g, i);
        }
        g.setColor(SemanticColor.MAP_GRID.get());
        ticks.forEach(at -> g.fillRect(x(at), top(), 1, getHeight()));
        for (int i = 0; i < lines.size(); i++) {
            paintBars(g, lines.get(i), y(i));
        }
        paintAxis(g, ticks);
        g.dispose();
    }

    private int x(long millis) {
        return names() + (int) Math.round(axis.x(millis));
    }

    private int y(int line) {
        return Look.px(AXIS) + line * rowHeight();
    }

    private void paintRow(Graphics2D g, int index) {
        GanttLine line = lines.get(index);
        int y = y(index);
        boolean chosen = index == selected;
        if (chosen || line.kind() == Kind.MISSION) {
            g.setColor((chosen ? SemanticColor.SELECTION : SemanticColor.SURFACE_RAISED).get());
            g.fillRect(0, y, chosen ? names() : getWidth(), rowHeight());
        }
        int x = Look.px(Spacing.NORMAL + line.depth() * INDENT);
        Color ink = (chosen
                        ? SemanticColor.ON_SELECTION
                        : line.status() == Status.AHEAD ? SemanticColor.MUTED : SemanticColor.TEXT)
                .get();
        g.setColor(ink);
        g.setFont(Fonts.text());
        int base = baseline(g, y);
        if (line.open().isPresent()) {
            g.drawString(line.open().get() ? "▾" : "▸", x, base);
        }
        x += Look.px(INDENT);
        if (line.robot().isPresent()) {
            double size = Look.px(11);
            MarkIcon.paint(g, marks.of(line.robot().get()), x + size / 2, y + rowHeight() / 2.0, size);
            x += Look.px(INDENT + Spacing.TIGHT);
        }
        int right = names() - Look.px(Spacing.NORMAL);
        if (!line.note().isEmpty()) {
            g.setFont(Fonts.small());
            g.setColor(chosen ? ink : SemanticColor.MUTED.get());
            right -= g.getFontMetrics().stringWidth(line.note());
            g.drawString(line.note(), right, base);
            right -= Look.px(Spacing.NORMAL);
        }
        Font font = line.kind() == Kind.MISSION || (line.status() == Status.ACTIVE && line.kind() != Kind.ROBOT)
                ? Fonts.strong()
                : Fonts.text();
        g.setFont(font);
        g.setColor(ink);
        String sign = line.kind() == Kind.ACTION || line.kind() == Kind.PHASE
                ? switch (line.status()) {
                    case DONE -> "✓ ";
                    case ACTIVE -> "▶ ";
                    case AHEAD -> "";
                }
                : "";
        g.drawString(
                TextLines.of(sign + line.label(), g.getFontMetrics(), Math.max(1, right - x), 1)
                        .get(0),
                x,
                base);
    }

    private static int baseline(Graphics2D g, int y) {
        FontMetrics metrics = g.getFontMetrics();
        return y + (rowHeight() + metrics.getAscent() - metrics.getDescent()) / 2;
    }

    private void paintBars(Graphics2D g, GanttLine line, int y) {
        Graphics2D time = (Graphics2D) g.create();
        time.clipRect(names(), 0, getWidth() - names(), getHeight());
        for (GanttBar bar : line.bars()) {
            paintBar(time, line, bar, y);
        }
        time.dispose();
    }

    private void paintBar(Graphics2D g, GanttLine line, GanttBar bar, int y) {
        int left = x(bar.fromMillis());
        int width = Math.max(Look.px(LEAST_BAR), x(bar.untilMillis(nowMillis)) - left);
        boolean thin = line.kind() == Kind.MISSION;
        int inset = Look.px(thin ? 9 : 4);
        int height = rowHeight() - 2 * inset;
        SemanticColor plain = bar.goesOn() ? SemanticColor.ACCENT : SemanticColor.OK;
        Color hue =
                line.robot().map(robot -> marks.of(robot).color()).orElse((thin ? SemanticColor.MUTED : plain).get());
        boolean filled = thin || (bar.goesOn() && line.robot().isEmpty());
        g.setColor(filled ? hue : blend(hue, SemanticColor.SURFACE.get(), bar.goesOn() ? 0.5 : 0.28));
        g.fillRoundRect(left, y + inset, width, height, Look.px(4), Look.px(4));
        g.setColor(line.robot().isPresent() ? SemanticColor.MUTED.get() : hue);
        g.setStroke(new BasicStroke(Look.px(1)));
        g.drawRoundRect(left, y + inset, width - 1, height - 1, Look.px(4), Look.px(4));
        if (!thin && line.kind() != Kind.ACTION) {
            write(g, line.robot().isPresent() ? bar.label() : "", left, width, y, filled);
        }
    }

    private void write(Graphics2D g, String words, int left, int width, int y, boolean filled) {
        int from = Math.max(left, names()) + Look.px(Spacing.TIGHT + 1);
        int room = left + width - Look.px(Spacing.TIGHT) - from;
        g.setFont(Fonts.small());
        FontMetrics metrics = g.getFontMetrics();
        if (words.isEmpty() || room < metrics.stringWidth("mmm…")) {
            return;
        }
        g.setColor((filled ? SemanticColor.ON_ACCENT : SemanticColor.TEXT).get());
        g.drawString(TextLines.of(words, metrics, room, 1).get(0), from, baseline(g, y));
    }

    private static Color blend(Color over, Color under, double part) {
        return new Color(
                (int) (over.getRed() * part + under.getRed() * (1 - part)),
                (int) (over.getGreen() * part + under.getGreen() * (1 - part)),
                (int) (over.getBlue() * part + under.getBlue() * (1 - part)));
    }

    private void paintAxis(Graphics2D g, List<Long> ticks) {
        int top = top();
        g.setColor(SemanticColor.SURFACE.get());
        g.fillRect(0, top, getWidth(), Look.px(AXIS));
        g.setColor(SemanticColor.BORDER.get());
        g.fillRect(0, top + Look.px(AXIS) - 1, getWidth(), 1);
        g.setFont(Fonts.small());
        FontMetrics metrics = g.getFontMetrics();
        int base = top + (Look.px(AXIS) + metrics.getAscent() - metrics.getDescent()) / 2;
        String now = "now";
        int nowX = x(nowMillis);
        int nowLeft = Math.min(nowX - metrics.stringWidth(now) / 2, getWidth() - metrics.stringWidth(now) - 2);
        g.setColor(SemanticColor.MUTED.get());
        for (long at : ticks) {
            String text = SessionClock.text(at);
            int left = x(at) + Look.px(Spacing.TIGHT);
            int right = left + metrics.stringWidth(text);
            if (right < getWidth() && (right < nowLeft - Look.px(Spacing.TIGHT) || nowX > getWidth())) {
                g.drawString(text, left, base);
            }
        }
        if (nowX <= getWidth() && nowX >= names()) {
            g.setColor(SemanticColor.CRITICAL.get());
            g.fillRect(nowX, top + Look.px(AXIS) - Look.px(5), Look.px(2), getHeight());
            g.setFont(Fonts.small().deriveFont(Font.BOLD));
            g.drawString(now, nowLeft, base);
        }
    }

    @Override
    public @Nullable String getToolTipText(MouseEvent event) {
        int line = lineAt(event.getY());
        return line < 0
                ? null
                : words(lines.get(line), event.getX()).orElse(lines.get(line).label());
    }

    /** What the bar at a place says: what, from when to when, how long. */
    private Optional<String> words(GanttLine line, int x) {
        return line.bars().stream()
                .filter(bar -> x >= x(bar.fromMillis()) - 2 && x <= x(bar.untilMillis(nowMillis)) + Look.px(LEAST_BAR))
                .reduce((earlier, later) -> later)
                .map(bar -> words(bar, nowMillis));
    }

    static String words(GanttBar bar, long nowMillis) {
        long seconds = (bar.untilMillis(nowMillis) - bar.fromMillis()) / 1000;
        String length = seconds >= 60 ? seconds / 60 + " min " + seconds % 60 + " s" : seconds + " s";
        return bar.label() + " · " + (bar.beganBefore() ? "since before " : "") + SessionClock.text(bar.fromMillis())
                + (bar.goesOn() ? " until now" : " to " + SessionClock.text(bar.untilMillis(nowMillis))) + " · "
                + length;
    }

    // ---- in a scroll pane

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return rowHeight();
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(rowHeight(), visible.height - Look.px(AXIS) - rowHeight());
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() > getPreferredSize().height;
    }
}
