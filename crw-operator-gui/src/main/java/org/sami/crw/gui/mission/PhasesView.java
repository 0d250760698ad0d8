package org.sami.crw.gui.mission;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.util.Optional;
import javax.swing.JComponent;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.palette.SemanticColor;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.spn.phase.PhaseView;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** A mission as phases and actors, for people who do not read nets: phase below phase, a row an actor, what is under way stands out. */
final class PhasesView extends JComponent {
    private static final int BOX_WIDTH = 168;
    private static final int ROW_HEIGHT = 44;
    private static final int ACTOR_WIDTH = 110;
    private static final int HEAD_HEIGHT = 32;

    private Optional<GanttMission> phases = Optional.empty();

    PhasesView() {
        setName("mission-phases");
    }

    void show(Optional<GanttMission> now) {
        phases = now.filter(mission -> !mission.chart().isEmpty());
        revalidate();
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        int width = 0;
        int height = Spacing.INSET;
        if (phases.isPresent()) {
            for (String name : phases.get().chart().phases()) {
                PhaseView view = view(name);
                int columns = view.boxes().stream()
                        .mapToInt(box -> box.column() + 1)
                        .max()
                        .orElse(1);
                width = Math.max(width, ACTOR_WIDTH + columns * BOX_WIDTH);
                height += HEAD_HEIGHT + view.actors().size() * ROW_HEIGHT;
            }
        }
        return new Dimension(Look.px(width + 2 * Spacing.INSET), Look.px(height + Spacing.INSET));
    }

    private PhaseView view(String phase) {
        GanttMission now = phases.orElseThrow();
        return now.chart().view(phase, now.taken());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setColor(SemanticColor.SURFACE.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        if (phases.isEmpty()) {
            g.setColor(SemanticColor.MUTED.get());
            g.setFont(Fonts.text());
            g.drawString("This plan names no phases (markup Phase Item).", Look.px(Spacing.WIDE), Look.px(HEAD_HEIGHT));
        } else {
            int y = Spacing.INSET;
            for (String name : phases.get().chart().phases()) {
                y = paint(g, name, y);
            }
        }
        g.dispose();
    }

    private int paint(Graphics2D g, String name, int top) {
        PhaseView view = view(name);
        g.setFont(Fonts.heading());
        g.setColor(SemanticColor.TEXT.get());
        g.drawString(name, Look.px(Spacing.INSET), Look.px(top + HEAD_HEIGHT - Spacing.INSET));
        int rows = top + HEAD_HEIGHT;
        for (int row = 0; row < view.actors().size(); row++) {
            int y = rows + row * ROW_HEIGHT;
            g.setColor((row % 2 == 0 ? SemanticColor.SURFACE_RAISED : SemanticColor.SURFACE).get());
            g.fillRect(0, Look.px(y), getWidth(), Look.px(ROW_HEIGHT));
            g.setFont(Fonts.strong());
            g.setColor(SemanticColor.MUTED.get());
            text(g, view.actors().get(row), Spacing.INSET, y, ACTOR_WIDTH - Spacing.INSET);
        }
        for (PhaseView.Box box : view.boxes()) {
            paint(g, box.action(), ACTOR_WIDTH + box.column() * BOX_WIDTH, rows + box.row() * ROW_HEIGHT);
        }
        return rows + view.actors().size() * ROW_HEIGHT;
    }

    private void paint(Graphics2D g, PhaseAction action, int x, int y) {
        Status status = phases.orElseThrow().status(action.id());
        boolean active = status == Status.ACTIVE;
        Color fill = active ? SemanticColor.ACCENT.get() : SemanticColor.SURFACE.get();
        Color line = status == Status.DONE ? SemanticColor.OK.get() : SemanticColor.ACCENT.get();
        int left = Look.px(x + Spacing.TIGHT);
        int top = Look.px(y + Spacing.TIGHT);
        int width = Look.px(BOX_WIDTH - 2 * Spacing.TIGHT);
        int height = Look.px(ROW_HEIGHT - 2 * Spacing.TIGHT);
        g.setColor(fill);
        g.fillRoundRect(left, top, width, height, Look.px(Spacing.NORMAL), Look.px(Spacing.NORMAL));
        g.setColor(line);
        g.drawRoundRect(left, top, width, height, Look.px(Spacing.NORMAL), Look.px(Spacing.NORMAL));
        g.setFont(active ? Fonts.strong() : Fonts.text());
        g.setColor((active ? SemanticColor.ON_ACCENT : SemanticColor.TEXT).get());
        String mark = status == Status.DONE ? "✓ " : active ? "▶ " : "";
        text(g, mark + action.label(), x + Spacing.INSET, y, BOX_WIDTH - 2 * Spacing.INSET);
    }

    /** Text in the middle of a row, cut with dots where it has no room. */
    private static void text(Graphics2D g, String text, int x, int y, int width) {
        FontMetrics metrics = g.getFontMetrics();
        String shown = text;
        while (shown.length() > 1 && metrics.stringWidth(shown) > Look.px(width)) {
            shown = shown.substring(0, shown.length() - 2) + "…";
        }
        g.drawString(
                shown, Look.px(x), Look.px(y) + (Look.px(ROW_HEIGHT) + metrics.getAscent() - metrics.getDescent()) / 2);
    }
}
