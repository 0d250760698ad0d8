package org.sami.crw.sim.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.sami.crw.sim.hull.TargetField;
import org.sami.crw.sim.picture.DownwardView.Spot;
import org.sami.crw.sim.picture.Scene.SeenBoat;
import org.sami.spn.value.GeoPoint;

/** Draws what a camera in the air sees straight below it: the water with what floats on it, boats, and robots that fly lower. */
final class AerialDrawing {
    private static final int WAVES = 420;
    private static final double JETTY_LONG_M = 9;
    private static final double TARGET_M = 2.4;
    private static final double TAG_ABOVE_M = 1.4;
    private static final double COPTER_REACH_M = 0.9;
    private static final Color SHADOW = new Color(12, 40, 52, 90);
    private static final Color INK = new Color(0x2B3338);

    private final Graphics2D to;
    private final DownwardView view;
    private final Scene scene;

    AerialDrawing(Graphics2D to, Scene scene) {
        this.to = to;
        this.scene = scene;
        view = new DownwardView(scene.at(), scene.headingRad());
    }

    void draw() {
        water();
        for (FloatingObject object : FloatingObject.near(view.eye(), view.seenM() + 3, scene.seed())) {
            at(object.at(), 0, object.kind().widthM, () -> floating(object.kind()));
        }
        new TargetField(scene.seed())
                .near(scene.at().latDeg(), scene.at().lonDeg(), view.seenM() + TARGET_M)
                .forEach(target -> at(GeoPoint.of(target.latDeg(), target.lonDeg()), 0, TARGET_M, this::target));
        at(scene.home(), 0, JETTY_LONG_M, this::jetty);
        List<SeenBoat> others = new ArrayList<>(scene.others());
        others.sort(Comparator.comparingDouble(other -> other.at().altM())); // the higher ones hide the lower ones
        for (SeenBoat other : others) {
            at(other.at(), other.headingRad(), SeenThings.BOAT_M, other.flies() ? this::copter : this::hull);
            view.spot(other.at())
                    .filter(spot -> spot.isSeen(SeenThings.BOAT_M))
                    .ifPresent(spot -> SeenThings.tag(
                            to, other.name(), spot.x(), spot.y() - TAG_ABOVE_M * spot.scale() - 2, SeenThings.SMALL));
        }
        north();
    }

    /** Deep water with the crests of the moment, which all run one way. */
    private void water() {
        to.setColor(new Color(0x2C6377));
        to.fillRect(0, 0, Perspective.WIDTH, Perspective.HEIGHT);
        SplittableRandom random = new SplittableRandom(
                scene.seed() ^ scene.time().toEpochMilli() * 31 ^ Double.doubleToLongBits(scene.headingRad()));
        double runs = new SplittableRandom(scene.seed()).nextDouble(2 * Math.PI) - view.headingRad();
        double scale = view.waterScale();
        AffineTransform before = to.getTransform();
        for (int wave = 0; wave < WAVES; wave++) {
            double length = Math.max(3, (0.5 + 1.8 * random.nextDouble()) * scale);
            double width = Math.max(1, 0.12 * scale * (0.5 + random.nextDouble()));
            to.translate(random.nextDouble() * Perspective.WIDTH, random.nextDouble() * Perspective.HEIGHT);
            to.rotate(runs + 0.25 * random.nextGaussian());
            to.setColor(random.nextBoolean() ? new Color(206, 230, 236, 40) : new Color(14, 48, 62, 46));
            to.fill(new Ellipse2D.Double(-length / 2, -width / 2, length, width));
            to.setTransform(before);
        }
    }

    /** Draws a thing in metres: x to its right, y to its back, around its own place. */
    private void at(GeoPoint place, double headingRad, double reachM, Runnable thing) {
        Spot spot = view.spot(place).orElse(null);
        if (spot == null || !spot.isSeen(reachM)) {
            return;
        }
        AffineTransform before = to.getTransform();
        to.translate(spot.x(), spot.y());
        to.rotate(headingRad - view.headingRad());
        to.scale(spot.scale(), spot.scale());
        thing.run();
        to.setTransform(before);
    }

    private void floating(FloatingObject.Kind kind) {
        double w = kind.widthM;
        switch (kind) {
            case RED_BUOY -> buoy(w, new Color(0xD5402B));
            case YELLOW_BUOY -> buoy(w, new Color(0xF0B429));
            case BARREL -> {
                fill(SHADOW, new RoundRectangle2D.Double(-w / 2 + 0.12, -0.16, w, 0.55, 0.2, 0.2));
                fill(new Color(0x2F6DB5), new RoundRectangle2D.Double(-w / 2, -0.27, w, 0.55, 0.2, 0.2));
                fill(new Color(0x234F85), new Rectangle2D.Double(-w * 0.2, -0.27, 0.06, 0.55));
                fill(new Color(0x234F85), new Rectangle2D.Double(w * 0.16, -0.27, 0.06, 0.55));
            }
            case DRIFTWOOD -> {
                fill(SHADOW, new RoundRectangle2D.Double(-w / 2 + 0.1, -0.05, w, 0.3, 0.3, 0.3));
                fill(new Color(0x6B4E37), new RoundRectangle2D.Double(-w / 2, -0.15, w, 0.3, 0.3, 0.3));
                to.setStroke(new BasicStroke(0.09f));
                to.draw(new Line2D.Double(w * 0.2, 0, w * 0.36, -0.5));
            }
        }
    }

    private void buoy(double w, Color color) {
        fill(SHADOW, new Ellipse2D.Double(-w / 2 + 0.15, -w / 2 + 0.15, w, w));
        fill(color, new Ellipse2D.Double(-w / 2, -w / 2, w, w));
        fill(color.darker(), new Ellipse2D.Double(-w * 0.2, -w * 0.2, w * 0.4, w * 0.4));
        fill(new Color(255, 255, 255, 90), new Ellipse2D.Double(-w * 0.34, -w * 0.34, w * 0.22, w * 0.22));
    }

    /** A life raft: what the copters of a simulated search look for. */
    private void target() {
        double r = TARGET_M / 2;
        fill(SHADOW, new Ellipse2D.Double(-r + 0.2, -r + 0.2, 2 * r, 2 * r));
        fill(new Color(0xF26A1B), new Ellipse2D.Double(-r, -r, 2 * r, 2 * r));
        fill(new Color(0xFFE9A8), new Ellipse2D.Double(-r * 0.62, -r * 0.62, r * 1.24, r * 1.24));
        fill(new Color(0xF26A1B), new Rectangle2D.Double(-r * 0.62, -0.1, r * 1.24, 0.2));
        fill(new Color(0xF26A1B), new Rectangle2D.Double(-0.1, -r * 0.62, 0.2, r * 1.24));
    }

    private void hull() {
        double half = SeenThings.BOAT_M / 2;
        Path2D hull = new Path2D.Double();
        hull.moveTo(0, -half);
        hull.curveTo(0.34, -half * 0.5, 0.3, half * 0.6, 0.24, half);
        hull.lineTo(-0.24, half);
        hull.curveTo(-0.3, half * 0.6, -0.34, -half * 0.5, 0, -half);
        hull.closePath();
        fill(SHADOW, AffineTransform.getTranslateInstance(0.12, 0.12).createTransformedShape(hull));
        fill(new Color(0xF4F1E8), hull);
        fill(new Color(0xE0672A), new Rectangle2D.Double(-0.2, half * 0.45, 0.4, 0.14));
        fill(new Color(0x3C474D), new RoundRectangle2D.Double(-0.15, -0.3, 0.3, 0.5, 0.1, 0.1));
    }

    /** Four rotors on two crossed arms. */
    private void copter() {
        to.setStroke(new BasicStroke(0.08f));
        to.setColor(INK);
        double arm = COPTER_REACH_M * 0.55;
        to.draw(new Line2D.Double(-arm, -arm, arm, arm));
        to.draw(new Line2D.Double(-arm, arm, arm, -arm));
        for (int rotor = 0; rotor < 4; rotor++) {
            double x = rotor < 2 ? -arm : arm;
            double y = rotor % 2 == 0 ? -arm : arm;
            fill(new Color(230, 238, 242, 120), new Ellipse2D.Double(x - 0.36, y - 0.36, 0.72, 0.72));
        }
        fill(new Color(0xF4F1E8), new RoundRectangle2D.Double(-0.2, -0.26, 0.4, 0.52, 0.2, 0.2));
        fill(new Color(0xE0672A), new Ellipse2D.Double(-0.09, -0.24, 0.18, 0.18)); // the front
    }

    /** Planks, where robots are launched. */
    private void jetty() {
        double w = SeenThings.JETTY_M;
        fill(SHADOW, new Rectangle2D.Double(-w / 2 + 0.4, 0.4, w, JETTY_LONG_M));
        fill(new Color(0x9A7B57), new Rectangle2D.Double(-w / 2, 0, w, JETTY_LONG_M));
        for (double plank = 0.6; plank < JETTY_LONG_M; plank += 0.6) {
            fill(new Color(0x7E6346), new Rectangle2D.Double(-w / 2, plank, w, 0.07));
        }
    }

    private void fill(Color color, Shape shape) {
        to.setColor(color);
        to.fill(shape);
    }

    /** An arrow to true north in the upper right corner. */
    private void north() {
        AffineTransform before = to.getTransform();
        to.translate(Perspective.WIDTH - 30, 30);
        fill(new Color(12, 20, 26, 150), new Ellipse2D.Double(-20, -20, 40, 40));
        to.rotate(-view.headingRad());
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(0, -15);
        arrow.lineTo(6, 2);
        arrow.lineTo(-6, 2);
        arrow.closePath();
        fill(Color.WHITE, arrow);
        to.setFont(SeenThings.SMALL);
        to.drawString("N", -4, 15);
        to.setTransform(before);
    }
}
