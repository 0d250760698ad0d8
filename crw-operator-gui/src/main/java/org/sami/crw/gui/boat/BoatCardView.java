package org.sami.crw.gui.boat;

import java.awt.Dimension;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.util.List;
import java.util.Optional;
import javax.swing.Icon;
import javax.swing.JPanel;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.picture.PictureTile;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.TextLines;

/** Paints the card of a boat: its name, numbers and what it does, and at the right its newest picture. */
final class BoatCardView extends JPanel {
    private static final int HEIGHT = 102;
    private static final int LEAST_PICTURE = 72;
    private static final int MOST_PICTURE = 124;
    private static final double PICTURE = 0.32; // of the width
    private static final int STATE_LINES = 3;

    private final OperatorContext context;
    private final ShownPictures pictures;
    private Optional<BoatCard> card = Optional.empty();
    private boolean selected;
    private boolean focused;

    BoatCardView(OperatorContext context, ShownPictures pictures) {
        this.context = context;
        this.pictures = pictures;
    }

    BoatCardView of(BoatCard shown, boolean isSelected, boolean hasFocus) {
        card = Optional.of(shown);
        selected = isSelected;
        focused = hasFocus;
        getAccessibleContext().setAccessibleName(shown.name() + ", " + shown.state());
        return this;
    }

    /** How high a card is, in pixels: five lines of text and the space around them. */
    static int height() {
        return Look.px(HEIGHT);
    }

    /** Where the picture lies on a card of a width, in pixels. */
    static Rectangle picture(int width) {
        int wide = Math.max(Look.px(LEAST_PICTURE), Math.min(Look.px(MOST_PICTURE), (int) (PICTURE * width)));
        int high = Math.min(wide * 9 / 16, height() - 2 * Look.px(Spacing.NORMAL));
        return new Rectangle(width - wide - Look.px(Spacing.NORMAL), (height() - high) / 2, wide, high);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(LEAST_PICTURE * 3), height());
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        card.ifPresent(one -> {
            Graphics2D g = (Graphics2D) graphics.create();
            g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            paint(g, one);
            g.dispose();
        });
    }

    private void paint(Graphics2D g, BoatCard one) {
        g.setColor((selected ? SemanticColor.SELECTION : SemanticColor.SURFACE).get());
        g.fillRect(0, 0, getWidth(), getHeight());
        Rectangle picture = picture(getWidth());
        int left = Look.px(Spacing.NORMAL);
        int right = picture.x - Look.px(Spacing.NORMAL);
        g.setFont(Fonts.strong());
        FontMetrics strong = g.getFontMetrics();
        int step = strong.getHeight();
        int y = (getHeight() - (2 + STATE_LINES) * step) / 2 + strong.getAscent();
        int x = left;
        if (one.known()) {
            Icon mark = BoatNameColumn.icon(context, one.name());
            mark.paintIcon(this, g, x, y - strong.getAscent() + (step - mark.getIconHeight()) / 2);
            x += mark.getIconWidth() + Look.px(Spacing.NORMAL);
        }
        int linkLeft = right - strong.stringWidth(one.link());
        write(g, one.name(), SemanticColor.TEXT, Fonts.strong(), x, y, linkLeft - x - Look.px(Spacing.NORMAL));
        write(
                g,
                one.link(),
                one.stale() ? SemanticColor.CRITICAL : SemanticColor.MUTED,
                Fonts.text(),
                linkLeft,
                y,
                right - linkLeft);
        y += step;
        g.setFont(Fonts.text());
        write(g, one.battery(), one.charge(), Fonts.text(), left, y, right - left);
        int numbers = left + g.getFontMetrics().stringWidth(one.battery());
        SemanticColor ink = one.stale() ? SemanticColor.STALE : SemanticColor.TEXT;
        write(
                g,
                fitting(one.figures(), g.getFontMetrics(), right - numbers),
                ink,
                Fonts.text(),
                numbers,
                y,
                right - numbers);
        y += step;
        g.setFont(Fonts.text());
        List<String> lines = TextLines.of(one.state(), g.getFontMetrics(), Math.max(1, right - left), STATE_LINES);
        for (String line : lines) {
            write(g, line, one.trouble(), Fonts.text(), left, y, right - left);
            y += step;
        }
        PictureTile.paint(g, pictures, pictures.newest(one.name()), picture);
        g.setColor(SemanticColor.BORDER.get());
        g.fillRect(0, getHeight() - 1, getWidth(), 1);
        if (focused) {
            g.setColor(SemanticColor.ACCENT.get());
            g.drawRect(0, 0, getWidth() - 1, getHeight() - 2);
        }
    }

    /** As many numbers as have room; those with least weight are left out. */
    private static String fitting(List<String> figures, FontMetrics metrics, int room) {
        String line = "";
        for (String figure : figures) {
            String longer = line + " · " + figure;
            if (metrics.stringWidth(longer) > room) {
                break;
            }
            line = longer;
        }
        return line;
    }

    private void write(Graphics2D g, String words, SemanticColor color, Font font, int x, int y, int room) {
        g.setFont(font);
        g.setColor((selected ? SemanticColor.ON_SELECTION : color).get());
        g.drawString(
                TextLines.of(words, g.getFontMetrics(), Math.max(1, room), 1).get(0), x, y);
    }
}
