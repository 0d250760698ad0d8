package org.sami.crw.gui.picture;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import javax.swing.JButton;
import org.sami.palette.SemanticColor;
import org.sami.picture.photo.Photo;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.table.TextLines;

/** A small picture that is pressed to see it large; where it is not here, it says why. */
final class PictureButton extends JButton {
    private static final int INSET = 6;

    private final ShownPictures pictures;
    private PictureChoice choice;
    private boolean chosen;

    PictureButton(ShownPictures pictures, PictureChoice choice) {
        this.pictures = pictures;
        this.choice = choice;
        setName("picture-" + choice.picture().name());
        setContentAreaFilled(false);
        setBorderPainted(false);
        setRolloverEnabled(true);
        addActionListener(pressed -> pictures.open(this.choice));
        show(choice);
    }

    /** The same picture, as it is known now. */
    void show(PictureChoice now) {
        choice = now;
        String words = choice.words();
        String missing = choice.picture().words();
        setToolTipText(missing.isEmpty() ? words + ": show it large" : words + ": " + missing);
        getAccessibleContext().setAccessibleName(words);
        repaint();
    }

    PictureChoice choice() {
        return choice;
    }

    /** Marks the one that is shown large. */
    void setChosen(boolean now) {
        chosen = now;
        repaint();
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(120), Look.px(68));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(SemanticColor.SURFACE_RAISED.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        Optional<Photo> photo = choice.picture().file().flatMap(file -> pictures.photo(file, getWidth(), getHeight()));
        Optional<BufferedImage> image = photo.flatMap(Photo::image);
        if (image.isPresent()) {
            int x = (getWidth() - image.get().getWidth()) / 2;
            int y = (getHeight() - image.get().getHeight()) / 2;
            g.drawImage(image.get(), x, y, null);
        } else {
            write(g, photo.map(Photo::problem).orElse(missing()));
        }
        frame(g);
        g.dispose();
    }

    private String missing() {
        return choice.picture().file().isPresent()
                ? "…"
                : choice.picture().isComing() ? "not here yet" : "will not come";
    }

    private void write(Graphics2D g, String words) {
        g.setFont(Fonts.small());
        g.setColor(SemanticColor.MUTED.get());
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        FontMetrics metrics = g.getFontMetrics();
        int room = getWidth() - 2 * Look.px(INSET);
        List<String> lines =
                TextLines.of(words, metrics, Math.max(1, room), Math.max(1, getHeight() / metrics.getHeight()));
        int y = (getHeight() - lines.size() * metrics.getHeight()) / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, (getWidth() - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
    }

    private void frame(Graphics2D g) {
        boolean marked = chosen || isFocusOwner() || getModel().isRollover();
        int thick = Look.px(marked ? 3 : 1);
        g.setStroke(new BasicStroke(thick));
        g.setColor((marked ? SemanticColor.ACCENT : SemanticColor.BORDER).get());
        g.drawRect(thick / 2, thick / 2, getWidth() - thick, getHeight() - thick);
    }
}
