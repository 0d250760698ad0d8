package org.sami.crw.gui.picture;

import java.awt.Component;
import java.awt.Dimension;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** Small pictures in rows, as large as the width allows. On the event thread. */
public final class PictureStrip extends JPanel {
    private static final int LEAST_WIDTH = 108;
    private static final int MOST_WIDTH = 320;

    private final ShownPictures pictures;
    private final int mostRows;
    private final List<PictureButton> buttons = new ArrayList<>();

    /**
     * No pictures yet.
     *
     * @param mostRows into how many rows they may go; they become narrower before there are more
     */
    public PictureStrip(ShownPictures pictures, int mostRows) {
        super(null);
        this.pictures = pictures;
        this.mostRows = mostRows;
        setName("picture-strip");
        setOpaque(false);
        setVisible(false);
        pictures.addListener(this::repaint);
    }

    /** Shows these; those that are shown already keep their buttons. Hidden where there are none. */
    public void show(List<PictureChoice> now) {
        if (now.equals(buttons.stream().map(PictureButton::choice).toList())) {
            return;
        }
        boolean same = now.size() == buttons.size();
        for (int i = 0; same && i < now.size(); i++) {
            same = now.get(i).isSame(buttons.get(i).choice());
        }
        if (!same) {
            buttons.clear();
            removeAll();
            for (PictureChoice each : now) {
                PictureButton button = new PictureButton(pictures, each);
                buttons.add(button);
                add(button);
            }
            setVisible(!now.isEmpty());
            revalidate();
        }
        for (int i = 0; i < now.size(); i++) {
            buttons.get(i).show(now.get(i));
        }
    }

    /** Marks the picture that is shown large, if it is one of these. */
    void mark(Optional<PictureChoice> large) {
        buttons.forEach(
                button -> button.setChosen(large.filter(button.choice()::isSame).isPresent()));
    }

    /** The first of them; empty where there is none. */
    public Optional<PictureChoice> first() {
        return buttons.stream().findFirst().map(PictureButton::choice);
    }

    private int columns(int width) {
        int fitting = Math.max(1, (width + gap()) / (Look.px(LEAST_WIDTH) + gap()));
        int least = (buttons.size() + mostRows - 1) / mostRows;
        return Math.max(1, Math.min(buttons.size(), Math.max(fitting, least)));
    }

    private static int gap() {
        return Look.px(Spacing.TIGHT);
    }

    private Dimension cell(int width, int columns) {
        int wide = Math.min(Look.px(MOST_WIDTH), Math.max(1, (width - (columns - 1) * gap()) / columns));
        return new Dimension(wide, wide * 9 / 16);
    }

    @Override
    public Dimension getPreferredSize() {
        int width = getWidth() > 0 ? getWidth() : Look.px(480);
        int columns = columns(width);
        int rows = (buttons.size() + columns - 1) / columns;
        return new Dimension(Look.px(LEAST_WIDTH), rows * (cell(width, columns).height + gap()));
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Look.px(LEAST_WIDTH), getPreferredSize().height);
    }

    @Override
    public void setBounds(int x, int y, int width, int height) {
        boolean otherWidth = width != getWidth();
        super.setBounds(x, y, width, height);
        if (otherWidth) {
            revalidate(); // its height follows from its width
        }
    }

    @Override
    public void doLayout() {
        int columns = columns(getWidth());
        Dimension cell = cell(getWidth(), columns);
        for (int i = 0; i < getComponentCount(); i++) {
            Component each = getComponent(i);
            each.setBounds(
                    i % columns * (cell.width + gap()), i / columns * (cell.height + gap()), cell.width, cell.height);
        }
    }
}
