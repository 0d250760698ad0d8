package org.sami.crw.sim.picture;

import java.awt.Color;
import java.awt.GradientPaint;
import java.awt.Graphics2D;
import java.awt.geom.Ellipse2D;
import java.util.SplittableRandom;

/** The water up to the horizon: small waves of the moment, and the sun's glitter. */
final class WaterSurface {
    private static final int WAVES = 900;
    private static final int GLINTS = 220;

    private WaterSurface() {}

    static void draw(Graphics2D to, Perspective view, Scene scene, double sunRad) {
        int depth = Perspective.HEIGHT - Perspective.HORIZON_Y;
        to.setPaint(new GradientPaint(
                0,
                Perspective.HORIZON_Y,
                new Color(0xA9C6CF),
                0,
                Perspective.HORIZON_Y + depth * 0.8f,
                new Color(0x2F6274)));
        to.fillRect(0, Perspective.HORIZON_Y, Perspective.WIDTH, depth);
        SplittableRandom random = new SplittableRandom(
                scene.seed() ^ scene.time().toEpochMilli() * 31 ^ Double.doubleToLongBits(scene.headingRad()));
        for (int wave = 0; wave < WAVES; wave++) {
            double near = random.nextDouble();
            near *= near; // most of them far away
            double y = Perspective.HORIZON_Y + 2 + near * depth;
            double width = 3 + near * 46 * (0.5 + random.nextDouble());
            double height = 0.6 + near * 3.2;
            double x = random.nextDouble() * (Perspective.WIDTH + 60) - 30;
            boolean light = random.nextBoolean();
            to.setColor(light ? new Color(214, 234, 238, 34) : new Color(18, 56, 70, 38));
            to.fill(new Ellipse2D.Double(x - width / 2, y, width, height));
        }
        double sunX = view.x(sunRad);
        for (int glint = 0; glint < GLINTS; glint++) {
            double near = random.nextDouble();
            double x = sunX + random.nextGaussian() * (8 + 60 * near);
            to.setColor(new Color(255, 248, 224, 60 + random.nextInt(90)));
            to.fill(new Ellipse2D.Double(
                    x, Perspective.HORIZON_Y + 2 + near * near * depth * 0.8, 2 + 7 * near, 0.8 + 1.4 * near));
        }
    }
}
