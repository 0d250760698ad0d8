package org.sami.crw.sim.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.sami.crw.sim.picture.Perspective.Spot;

/**
 * Draws a {@link Scene}: 640 × 360 pixels, with name, heading, position, height and time at the lower edge; level ahead with bearings at
 * the upper edge, or straight down with an arrow to north.
 */
public final class ScenePicture {
    /** Most bytes of a picture. */
    public static final int MOST_BYTES = 60_000;

    private static final double SEEN_M = 220;
    private static final int STRIP_PX = 24;
    private static final String[] WINDS = {"N", "NE", "E", "SE", "S", "SW", "W", "NW"};
    private static final Font BOLD = new Font(Font.SANS_SERIF, Font.BOLD, 13);
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("yyyy-MM-dd HH:mm:ss 'UTC'", Locale.ROOT)
            .withZone(ZoneOffset.UTC);

    private ScenePicture() {}

    private record Thing(Spot spot, Runnable drawing) {}

    /** The picture as a JPEG of at most {@link #MOST_BYTES} bytes. */
    public static byte[] jpeg(Scene scene) {
        BufferedImage image = draw(scene);
        for (float quality = 0.82f; ; quality -= 0.12f) {
            byte[] bytes = encode(image, quality);
            if (bytes.length <= MOST_BYTES || quality < 0.2f) {
                return bytes;
            }
        }
    }

    static BufferedImage draw(Scene scene) {
        BufferedImage image = new BufferedImage(Perspective.WIDTH, Perspective.HEIGHT, BufferedImage.TYPE_INT_RGB);
        Graphics2D to = image.createGraphics();
        try {
            to.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
            to.setRenderingHint(RenderingHints.KEY_TEXT_ANTIALIASING, RenderingHints.VALUE_TEXT_ANTIALIAS_ON);
            if (scene.isFromAbove()) {
                new AerialDrawing(to, scene).draw();
            } else {
                levelAhead(to, scene);
            }
            edge(to, scene);
        } finally {
            to.dispose();
        }
        return image;
    }

    private static void levelAhead(Graphics2D to, Scene scene) {
        Perspective view = new Perspective(scene.at(), scene.headingRad());
        CoastDrawing coast = new CoastDrawing(view, scene.seed());
        coast.draw(to);
        WaterSurface.draw(to, view, scene, coast.sunRad());
        things(to, view, scene).forEach(thing -> thing.drawing().run());
        bearings(to, view, scene.headingRad());
    }

    /** The farthest first, as the nearer ones stand before them. */
    private static List<Thing> things(Graphics2D to, Perspective view, Scene scene) {
        List<Thing> things = new ArrayList<>();
        for (FloatingObject object : FloatingObject.near(view.eye(), SEEN_M, scene.seed())) {
            Spot spot = view.spot(object.at());
            if (spot.isSeen(object.kind().widthM)) {
                things.add(new Thing(spot, () -> SeenThings.object(to, spot, object.kind())));
            }
        }
        for (Scene.SeenBoat boat : scene.others()) {
            Spot spot = view.spot(boat.at());
            if (spot.isSeen(SeenThings.BOAT_M) && spot.aheadM() < 2 * SEEN_M) {
                things.add(
                        new Thing(spot, () -> SeenThings.robot(to, spot, boat, scene.headingRad(), SeenThings.SMALL)));
            }
        }
        Spot home = view.spot(scene.home());
        if (home.aheadM() > 4 && home.isSeen(SeenThings.JETTY_M) && home.aheadM() < 2 * SEEN_M) {
            things.add(new Thing(home, () -> SeenThings.jetty(to, home)));
        }
        things.sort(Comparator.comparingDouble((Thing thing) -> -thing.spot().aheadM()));
        return things;
    }

    /** A scale of bearings along the upper edge, a line each ten degrees. */
    private static void bearings(Graphics2D to, Perspective view, double headingRad) {
        to.setFont(SeenThings.SMALL);
        int from = (int) Math.floor(Math.toDegrees(headingRad) / 10) * 10 - 40;
        for (int degrees = from; degrees <= from + 90; degrees += 10) {
            double x = view.x(Math.toRadians(degrees));
            String text = Math.floorMod(degrees, 45) == 0
                    ? WINDS[Math.floorMod(degrees, 360) / 45]
                    : Integer.toString(Math.floorMod(degrees, 360));
            to.setColor(new Color(20, 40, 60, 190));
            to.fillRect((int) Math.round(x), 0, 1, 6);
            to.drawString(text, (float) (x - to.getFontMetrics().stringWidth(text) / 2.0), 18);
        }
    }

    private static void edge(Graphics2D to, Scene scene) {
        int top = Perspective.HEIGHT - STRIP_PX;
        to.setColor(new Color(12, 20, 26, 190));
        to.fillRect(0, top, Perspective.WIDTH, STRIP_PX);
        int degrees = Math.floorMod((int) Math.round(Math.toDegrees(scene.headingRad())), 360);
        String wind = WINDS[Math.floorMod(Math.round(degrees / 45f), 8)];
        to.setColor(Color.WHITE);
        to.setFont(BOLD);
        String name = shortened(to, scene.boat(), 150);
        to.drawString(name, 10, top + 17);
        to.setFont(SeenThings.SMALL);
        to.drawString(String.format(Locale.ROOT, "%03d° %s", degrees, wind), 172, top + 17);
        to.drawString(
                String.format(
                        Locale.ROOT,
                        "%.6f, %.6f",
                        scene.at().latDeg(),
                        scene.at().lonDeg()),
                262,
                top + 17);
        if (scene.isFromAbove()) {
            to.drawString(String.format(Locale.ROOT, "%.0f m up", scene.at().altM()), 414, top + 17);
        }
        String time = TIME.format(scene.time());
        to.drawString(time, Perspective.WIDTH - 10 - to.getFontMetrics().stringWidth(time), top + 17);
    }

    private static String shortened(Graphics2D to, String text, int widthPx) {
        String shown = text;
        while (shown.length() > 1 && to.getFontMetrics().stringWidth(shown) > widthPx) {
            shown = shown.substring(0, shown.length() - 2) + "…";
        }
        return shown;
    }

    private static byte[] encode(BufferedImage image, float quality) {
        ImageWriter writer = ImageIO.getImageWritersByFormatName("jpeg").next();
        try {
            ImageWriteParam param = writer.getDefaultWriteParam();
            param.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            param.setCompressionQuality(quality);
            ByteArrayOutputStream bytes = new ByteArrayOutputStream(MOST_BYTES);
            try (MemoryCacheImageOutputStream out = new MemoryCacheImageOutputStream(bytes)) {
                writer.setOutput(out);
                writer.write(null, new IIOImage(image, null, null), param);
            }
            return bytes.toByteArray();
        } catch (IOException e) {
            throw new UncheckedIOException(e); // memory does not fail
        } finally {
            writer.dispose();
        }
    }
}
