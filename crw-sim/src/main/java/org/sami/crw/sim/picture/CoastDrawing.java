package org.sami.crw.sim.picture;

import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.RadialGradientPaint;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.SplittableRandom;

/** Sky, sun, clouds, hills and trees on the far coast; all at bearings that follow from the seed of the water. */
final class CoastDrawing {
    private static final int CLOUDS = 26;
    private final Perspective view;
    private final long seed;
    private final double sunRad;

    CoastDrawing(Perspective view, long seed) {
        this.view = view;
        this.seed = seed;
        sunRad = Math.toRadians(new SplittableRandom(seed).nextInt(130, 230));
    }

    /** Where the sun stands. */
    double sunRad() {
        return sunRad;
    }

    void draw(Graphics2D to) {
        to.setPaint(new GradientPaint(0, 0, new Color(0x6FA8DC), 0, Perspective.HORIZON_Y, new Color(0xE8F1F5)));
        to.fillRect(0, 0, Perspective.WIDTH, Perspective.HORIZON_Y + 1);
        sun(to);
        clouds(to);
        ridge(to, 1, 44, 0.0, new Color(0xA9BDCB));
        ridge(to, 2, 26, -0.15, new Color(0x7F9AA5));
        trees(to);
    }

    private void sun(Graphics2D to) {
        double x = view.x(sunRad);
        float[] stops = {0f, 0.12f, 1f};
        Color[] colors = {new Color(255, 252, 235, 255), new Color(255, 246, 214, 190), new Color(255, 246, 214, 0)};
        if (x > -200 && x < Perspective.WIDTH + 200) {
            to.setPaint(new RadialGradientPaint((float) x, 42, 150, stops, colors));
            to.fill(new Ellipse2D.Double(x - 150, -108, 300, 300));
        }
    }

    private void clouds(Graphics2D to) {
        SplittableRandom random = new SplittableRandom(seed ^ 0x636c6f7564L);
        for (int cloud = 0; cloud < CLOUDS; cloud++) {
            double bearing = random.nextDouble(2 * Math.PI);
            double y = 18 + random.nextDouble() * 82;
            double size = 16 + (110 - y) * 0.35 * (0.6 + random.nextDouble());
            int puffs = 4 + random.nextInt(4);
            double x = view.x(bearing);
            for (int puff = 0; puff < puffs; puff++) {
                double off = (puff - puffs / 2.0) * size * 0.62;
                double height = size * (0.42 + 0.3 * random.nextDouble());
                to.setColor(new Color(255, 255, 255, 70 + random.nextInt(50)));
                to.fill(new Ellipse2D.Double(x + off - size / 2, y - height / 2, size * 1.25, height));
            }
        }
    }

    /** Hills with open water between them. */
    private void ridge(Graphics2D to, int layer, double highestPx, double sunk, Color color) {
        Path2D outline = new Path2D.Double();
        outline.moveTo(0, Perspective.HORIZON_Y);
        for (int x = 0; x <= Perspective.WIDTH; x += 2) {
            double height = Math.max(0, highestPx * (relief(view.bearingRad(x), layer) + sunk));
            outline.lineTo(x, Perspective.HORIZON_Y - height);
        }
        outline.lineTo(Perspective.WIDTH, Perspective.HORIZON_Y);
        outline.closePath();
        to.setColor(color);
        to.fill(outline);
    }

    /** -1 to 1, the same after a full turn. */
    private double relief(double bearingRad, int layer) {
        SplittableRandom random = new SplittableRandom(seed ^ (0x68696c6cL * layer));
        double sum = 0;
        double weights = 0;
        for (int wave : new int[] {1, 2, 3, 5, 9, 14, 31}) {
            double weight = 1.0 / (0.6 + wave * 0.45);
            sum += weight * StrictMath.sin(wave * bearingRad + random.nextDouble(2 * Math.PI));
            weights += weight;
        }
        return sum / weights + 0.18;
    }

    /** A wooded shore, nearer than the hills. */
    private void trees(Graphics2D to) {
        for (int x = 0; x <= Perspective.WIDTH; x++) {
            double bearing = view.bearingRad(x);
            double shore = relief(bearing, 3);
            if (shore > 0.12) {
                long tuft = (long) Math.floor(bearing * 260);
                double crown = new SplittableRandom(seed + tuft * 13).nextDouble();
                double height = Math.min(1, (shore - 0.12) * 9) * (4 + 5 * crown);
                int green = 78 + (int) (34 * crown);
                to.setColor(new Color(52 + (int) (18 * crown), green, 58));
                to.fill(new Rectangle2D.Double(x, Perspective.HORIZON_Y - height, 1.5, height));
                to.setColor(new Color(0xB9AD8C)); // the beach below
                to.fill(new Rectangle2D.Double(x, Perspective.HORIZON_Y - 1, 1.5, 1.6));
            }
        }
    }
}
