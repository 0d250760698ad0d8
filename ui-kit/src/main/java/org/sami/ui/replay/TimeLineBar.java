package org.sami.ui.replay;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import org.sami.palette.SemanticColor;
import org.sami.spn.replay.TimeLine.Mark;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** The time line: what happened when, one row for missions and decisions, one for messages and the operator, one for alarms; and where the replay is. */
final class TimeLineBar extends JPanel {
    private static final int ROW = 12;
    private static final int TOP = 6;
    private static final int NEAR = 6;
    private static final long[] STEPS_S = {
        1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 900, 1800, 3600, 7200, 14_400, 43_200, 86_400
    };

    private final transient PlaybackTimer player;

    TimeLineBar(PlaybackTimer player) {
        this.player = player;
        setName("time-line");
        setFocusable(true);
        setOpaque(false);
        setPreferredSize(new Dimension(Look.px(400), Look.px(2 * TOP + 3 * ROW + 18)));
        getAccessibleContext().setAccessibleName("Time line of the replay");
        setToolTipText("");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                player.goTo(markAt(e.getX(), e.getY()).map(Mark::atMillis).orElse(millisAt(e.getX())));
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                player.goTo(millisAt(e.getX()));
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        player.addListener(this::repaint);
    }

    private int inset() {
        return Look.px(Spacing.INSET);
    }

    private int x(long millis) {
        long end = Math.max(1, player.timeLine().endMillis());
        return inset() + (int) (millis * (getWidth() - 2L * inset()) / end);
    }

    private long millisAt(int x) {
        long end = player.timeLine().endMillis();
        return Math.max(0, Math.min(end, (x - inset()) * end / Math.max(1, getWidth() - 2 * inset())));
    }

    private static int row(Mark mark) {
        return switch (mark.kind()) {
            case MISSION_STARTED, MISSION_ENDED, DECISION_ASKED, DECISION_ANSWERED -> 0;
            case MESSAGE, OPERATOR -> 1;
            case ALARM -> 2;
        };
    }

    private static SemanticColor color(Mark mark) {
        return switch (mark.kind()) {
            case MISSION_STARTED, MISSION_ENDED -> SemanticColor.OK;
            case DECISION_ASKED, DECISION_ANSWERED -> SemanticColor.ACCENT;
            case MESSAGE -> SemanticColor.MUTED;
            case OPERATOR -> SemanticColor.TEXT;
            case ALARM -> SemanticColor.CRITICAL;
        };
    }

    private int y(Mark mark) {
        return Look.px(TOP + row(mark) * ROW + ROW / 2);
    }

    private Optional<Mark> markAt(int x, int y) {
        List<Mark> marks = player.timeLine().marks();
        return marks.stream()
                .filter(mark ->
                        Math.abs(x(mark.atMillis()) - x) <= Look.px(NEAR) && Math.abs(y(mark) - y) <= Look.px(NEAR))
                .min(Comparator.comparingInt(mark -> Math.abs(x(mark.atMillis()) - x)));
    }

    @Override
    public String getToolTipText(MouseEvent e) {
        return markAt(e.getX(), e.getY())
                .map(mark -> SessionClock.text(mark.atMillis()) + "  " + mark.text())
                .orElse(SessionClock.text(millisAt(e.getX())));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        int bottom = Look.px(TOP + 3 * ROW);
        g.setColor(SemanticColor.BORDER.get());
        for (int row = 0; row < 3; row++) {
            int y = Look.px(TOP + row * ROW + ROW / 2);
            g.drawLine(inset(), y, getWidth() - inset(), y);
        }
        times(g, bottom);
        player.timeLine().marks().forEach(mark -> paint(g, mark));
        int at = x(player.playback().atMillis());
        Color accent = SemanticColor.ACCENT.get();
        g.setColor(accent);
        g.fillRect(at - Look.px(1), 0, Look.px(3), bottom + Look.px(2));
        int half = Look.px(6);
        g.fillPolygon(new int[] {at - half, at + half + 1, at}, new int[] {0, 0, half + 2}, 3);
        if (isFocusOwner()) {
            g.drawRect(1, 0, getWidth() - 3, getHeight() - 1);
        }
        g.dispose();
    }

    private void paint(Graphics2D g, Mark mark) {
        int x = x(mark.atMillis());
        int y = y(mark);
        int half = Look.px(4);
        g.setColor(color(mark).get());
        switch (mark.kind()) {
            case MISSION_STARTED ->
                g.fillPolygon(new int[] {x - half, x - half, x + half}, new int[] {y - half, y + half, y}, 3);
            case MISSION_ENDED -> g.fillRect(x - half, y - half, 2 * half, 2 * half);
            case DECISION_ASKED -> g.drawOval(x - half, y - half, 2 * half, 2 * half);
            case DECISION_ANSWERED, MESSAGE -> g.fillOval(x - half, y - half, 2 * half, 2 * half);
            case OPERATOR ->
                g.fillPolygon(new int[] {x - half, x, x + half, x}, new int[] {y, y - half, y, y + half}, 4);
            case ALARM -> g.fillPolygon(new int[] {x - half, x + half, x}, new int[] {y + half, y + half, y - half}, 3);
        }
    }

    /** Times below the rows, as close as they can be read, at full steps of seconds, minutes or hours. */
    private void times(Graphics2D g, int top) {
        g.setFont(Fonts.small());
        g.setColor(SemanticColor.MUTED.get());
        int apart = g.getFontMetrics().stringWidth("00:00:00") + Look.px(32);
        long end = player.timeLine().endMillis();
        long step = step(end * apart / Math.max(1, getWidth() - 2 * inset()));
        int baseline = top + g.getFontMetrics().getAscent() + Look.px(2);
        for (long at = 0; at <= end; at += step) {
            String text = SessionClock.text(at);
            int half = g.getFontMetrics().stringWidth(text) / 2;
            int x = Math.max(half + 2, Math.min(getWidth() - half - 2, x(at)));
            g.drawString(text, x - half, baseline);
        }
    }

    /** The smallest step that is at least as long, in ms; a multiple of the longest one where none is. */
    static long step(long leastMillis) {
        long longest = STEPS_S[STEPS_S.length - 1] * 1000;
        for (long seconds : STEPS_S) {
            if (seconds * 1000 >= leastMillis) {
                return seconds * 1000;
            }
        }
        return (leastMillis + longest - 1) / longest * longest;
    }
}
