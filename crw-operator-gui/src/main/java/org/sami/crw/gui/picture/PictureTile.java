package org.sami.crw.gui.picture;

import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import org.sami.palette.SemanticColor;
import org.sami.picture.photo.Photo;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;
import org.sami.ui.table.TextLines;

/** Paints the newest picture of a robot into a box of a list, or says that there is none. */
public final class PictureTile {
    private static final int STEP = 31; // pictures are read in steps of 32 pixels, and rather reduced than enlarged

    private PictureTile() {}

    /**
     * Paints it.
     *
     * @param choice empty where the robot has taken no picture
     */
    public static void paint(Graphics2D g, ShownPictures pictures, Optional<PictureChoice> choice, Rectangle box) {
        Optional<Photo> photo = choice.flatMap(one -> one.picture().file())
                .flatMap(file -> pictures.photo(file, box.width + STEP, box.height + STEP));
        Optional<BufferedImage> image = photo.flatMap(Photo::image);
        g.setColor(SemanticColor.SURFACE_RAISED.get());
        g.fill(box);
        if (image.isPresent()) {
            double scale = Math.min(
                    (double) box.width / image.get().getWidth(),
                    (double) box.height / image.get().getHeight());
            int wide = (int) Math.round(scale * image.get().getWidth());
            int high = (int) Math.round(scale * image.get().getHeight());
            g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
            g.drawImage(image.get(), box.x + (box.width - wide) / 2, box.y + (box.height - high) / 2, wide, high, null);
        } else {
            String words = choice.isEmpty()
                    ? "no picture yet"
                    : choice.get().picture().isComing()
                            ? "a picture is coming"
                            : photo.map(Photo::problem).orElse("…");
            write(g, words, box);
        }
        g.setColor(SemanticColor.BORDER.get());
        g.drawRect(box.x, box.y, box.width - 1, box.height - 1);
    }

    private static void write(Graphics2D g, String words, Rectangle box) {
        g.setFont(Fonts.small());
        g.setColor(SemanticColor.MUTED.get());
        FontMetrics metrics = g.getFontMetrics();
        int most = Math.max(1, box.height / metrics.getHeight());
        List<String> lines = TextLines.of(words, metrics, box.width - 2 * Look.px(Spacing.TIGHT), most);
        int y = box.y + (box.height - lines.size() * metrics.getHeight()) / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, box.x + (box.width - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
    }
}
