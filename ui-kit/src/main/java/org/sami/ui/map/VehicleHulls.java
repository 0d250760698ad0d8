package org.sami.ui.map;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.util.function.Function;
import org.sami.palette.SemanticColor;
import org.sami.ui.map.Sprites.Sprite;

/** Paints the hulls of vehicles, turned to their headings, with lines to where they will be in ten seconds. */
final class VehicleHulls {
    static final double RING_PX = 5; // between a hull and the ring around one that is chosen
    private static final double LOOKAHEAD_S = 10;
    private static final double LEAST_VECTOR_PX = 4;
    private static final int HEADINGS = 120; // three degrees apart

    private final Sprites<Hull> sprites = new Sprites<>();
    private final Function<String, VehicleShape> forms;

    private record Hull(VehicleShape form, Color color, boolean stale, int heading) {}

    /** What each vehicle looks like, by its id. */
    VehicleHulls(Function<String, VehicleShape> forms) {
        this.forms = forms;
    }

    /** From the middle to the bow, in logical pixels at the scale in force. */
    static double halfPx() {
        return Painting.px(VehicleShape.HALF_PX);
    }

    /** How far from its middle a vehicle is painted on this map, in pixels. */
    static double reachPx(MapPaint paint, ShownVehicle vehicle) {
        return halfPx() + RING_PX + vectorPx(paint, vehicle);
    }

    private static double vectorPx(MapPaint paint, ShownVehicle vehicle) {
        double px = vehicle.speedMps() * LOOKAHEAD_S / paint.frame().metresPerPixel();
        return px >= LEAST_VECTOR_PX && !vehicle.isStale() ? px : 0;
    }

    void paint(MapPaint paint, ShownVehicle vehicle) {
        Graphics2D g = paint.g();
        double x = paint.frame().px(vehicle.at());
        double y = paint.frame().py(vehicle.at());
        double vector = vectorPx(paint, vehicle);
        g.setStroke(Painting.butt(2.5));
        if (vector > 0) {
            g.setColor(vehicle.mark().color());
            g.draw(new Line2D.Double(
                    x, y, x + vector * Math.sin(vehicle.courseRad()), y - vector * Math.cos(vehicle.courseRad())));
        }
        if (vehicle.selected()) {
            g.setColor(SemanticColor.ACCENT.get());
            double ring = halfPx() + RING_PX;
            g.draw(new Ellipse2D.Double(x - ring, y - ring, 2 * ring, 2 * ring));
        }
        sprite(g, vehicle).paintAround(g, x, y);
    }

    private Sprite sprite(Graphics2D g, ShownVehicle vehicle) {
        int heading = Math.floorMod(Math.round(vehicle.headingRad() / (2 * Math.PI) * HEADINGS), HEADINGS);
        Hull hull = new Hull(forms.apply(vehicle.id()), vehicle.mark().color(), vehicle.isStale(), heading);
        double side = 2 * halfPx() + 4;
        return sprites.get(g, hull, side, side, own -> paint(own, hull, side / 2));
    }

    private void paint(Graphics2D g, Hull hull, double middle) {
        AffineTransform place = AffineTransform.getTranslateInstance(middle, middle);
        place.rotate(hull.heading() * 2 * Math.PI / HEADINGS);
        place.scale(Painting.px(1), Painting.px(1));
        Shape shape = place.createTransformedShape(hull.form().outline());
        g.setColor(hull.stale() ? Painting.alpha(hull.color(), 0.35) : hull.color());
        g.fill(shape);
        g.setStroke(Painting.line(1.5));
        g.setColor(SemanticColor.TEXT.get());
        g.draw(shape);
    }
}
