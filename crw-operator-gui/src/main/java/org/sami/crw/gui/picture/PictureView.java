package org.sami.crw.gui.picture;

import java.awt.Dimension;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Optional;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import org.sami.palette.SemanticColor;
import org.sami.picture.photo.Photo;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.table.TextLines;

/** One picture, as large as there is room, or enlarged: the wheel enlarges where the pointer is, dragging moves it. On the event thread. */
final class PictureView extends JPanel {
    private static final double STEP = Math.sqrt(2);
    private static final double MOST = 8;
    private static final int MOST_DECODED_PX = 4096;
    private static final int INSET = 16;

    private final ShownPictures pictures;
    private Optional<PictureChoice> choice = Optional.empty();
    private Optional<Photo> last = Optional.empty(); // of the choice
    private double zoom = 1; // 1 shows all of it
    private double centreX = 0.5; // what is in the middle, as parts of the picture
    private double centreY = 0.5;
    private Point dragged = new Point();

    PictureView(ShownPictures pictures) {
        this.pictures = pictures;
        setName("picture-large");
        setFocusable(true);
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mouseWheelMoved(MouseWheelEvent e) {
                zoomAt(e.getPoint(), e.getWheelRotation() < 0 ? STEP : 1 / STEP);
            }

            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                dragged = e.getPoint();
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                if (SwingUtilities.isLeftMouseButton(e)) {
                    drag(e.getPoint());
                }
            }

            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    zoomAt(e.getPoint(), zoom > 1 ? 1 / zoom : 2);
                }
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
        addMouseWheelListener(mouse);
        pictures.addListener(this::repaint);
    }

    /** Shows a picture, all of it; the same one stays as it is. */
    void show(Optional<PictureChoice> now) {
        boolean same = now.isPresent() && choice.isPresent() && choice.get().isSame(now.get());
        if (!same) {
            last = Optional.empty();
            fit();
        }
        choice = now;
        getAccessibleContext().setAccessibleName(now.map(PictureChoice::words).orElse("no picture"));
        repaint();
    }

    /** Shows all of it. */
    void fit() {
        zoom = 1;
        centreX = 0.5;
        centreY = 0.5;
        repaint();
    }

    void larger() {
        zoomAt(new Point(getWidth() / 2, getHeight() / 2), STEP);
    }

    void smaller() {
        zoomAt(new Point(getWidth() / 2, getHeight() / 2), 1 / STEP);
    }

    /** Enlarges or reduces about a point, which stays where it is. */
    private void zoomAt(Point at, double factor) {
        Dimension before = pictureSize();
        double x = centreX + (at.x - getWidth() / 2.0) / before.width;
        double y = centreY + (at.y - getHeight() / 2.0) / before.height;
        double next = zoom * factor;
        zoom = next < 1.001 ? 1 : Math.min(MOST, next);
        Dimension after = pictureSize();
        centreX = x - (at.x - getWidth() / 2.0) / after.width;
        centreY = y - (at.y - getHeight() / 2.0) / after.height;
        keepInside(after);
        repaint();
    }

    private void drag(Point to) {
        Dimension size = pictureSize();
        centreX -= (to.x - dragged.x) / (double) size.width;
        centreY -= (to.y - dragged.y) / (double) size.height;
        dragged = to;
        keepInside(size);
        repaint();
    }

    private void keepInside(Dimension size) {
        centreX = inside(centreX, getWidth() / (double) size.width);
        centreY = inside(centreY, getHeight() / (double) size.height);
    }

    private static double inside(double centre, double seen) {
        return seen >= 1 ? 0.5 : Math.max(seen / 2, Math.min(1 - seen / 2, centre));
    }

    /** How large all of the picture is now, in pixels. */
    private Dimension pictureSize() {
        double wide = last.filter(photo -> photo.widthPx() > 0)
                .map(photo -> photo.widthPx() / (double) photo.heightPx())
                .orElse(16.0 / 9);
        double width = Math.min(getWidth(), getHeight() * wide);
        return new Dimension(
                (int) Math.max(1, Math.round(width * zoom)), (int) Math.max(1, Math.round(width / wide * zoom)));
    }

    /** The picture is decoded again only when its size doubles, not at each step. */
    private Optional<Photo> photo(PictureChoice shown) {
        double decoded = Math.pow(2, Math.ceil(Math.log(zoom) / Math.log(2) - 1e-9));
        int width = (int) Math.min(MOST_DECODED_PX, Math.max(1, getWidth() * decoded));
        int height = (int) Math.min(MOST_DECODED_PX, Math.max(1, getHeight() * decoded));
        return shown.picture().file().flatMap(file -> pictures.photo(file, width, height));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(SemanticColor.SURFACE.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        choice.ifPresent(shown -> {
            last = photo(shown).or(() -> last);
            Optional<BufferedImage> image = last.flatMap(Photo::image);
            if (image.isPresent()) {
                Dimension size = pictureSize();
                int x = (int) Math.round(getWidth() / 2.0 - centreX * size.width);
                int y = (int) Math.round(getHeight() / 2.0 - centreY * size.height);
                g.setRenderingHint(RenderingHints.KEY_INTERPOLATION, RenderingHints.VALUE_INTERPOLATION_BILINEAR);
                g.drawImage(image.get(), x, y, size.width, size.height, null);
            } else {
                write(g, problem(shown));
            }
        });
        g.dispose();
    }

    /** Why the picture cannot be seen. */
    private String problem(PictureChoice shown) {
        String missing = shown.picture().words();
        return missing.isEmpty() ? last.map(Photo::problem).orElse("…") : missing;
    }

    private void write(Graphics2D g, String words) {
        g.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
        g.setFont(Fonts.text());
        g.setColor(SemanticColor.TEXT.get());
        FontMetrics metrics = g.getFontMetrics();
        int room = Math.max(1, getWidth() - 2 * Look.px(INSET));
        List<String> lines = TextLines.of(words, metrics, room, 6);
        int y = (getHeight() - lines.size() * metrics.getHeight()) / 2 + metrics.getAscent();
        for (String line : lines) {
            g.drawString(line, (getWidth() - metrics.stringWidth(line)) / 2, y);
            y += metrics.getHeight();
        }
    }

    @Override
    public Dimension getMinimumSize() {
        return new Dimension(Look.px(120), Look.px(68));
    }
}
