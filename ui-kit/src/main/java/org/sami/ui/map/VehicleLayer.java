package org.sami.ui.map;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.AffineTransform;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.ui.geo.GeoBounds;
import org.sami.ui.geo.MapFrame;
import org.sami.ui.geo.Snapping;
import org.sami.ui.look.SemanticColor;

/** Vehicles as hulls with their heading, a line to where they will be in ten seconds, and their short names. */
public final class VehicleLayer extends MapLayer {
    private static final double HULL_PX = 13; // from the middle to the bow
    private static final double REACH_PX = 16;
    private static final double AHEAD_S = 10;
    private static final double LEAST_VECTOR_PX = 4;
    private static final Path2D HULL = hull();
    private static final BasicStroke THIN = new BasicStroke(1.5f);
    private static final BasicStroke THICK = new BasicStroke(2.5f);

    private List<ShownVehicle> vehicles = List.of();

    public VehicleLayer(String id, String title) {
        super(id, title);
    }

    /** Shows these vehicles instead of those before; later ones lie on top. */
    public void show(List<ShownVehicle> vehicles) {
        this.vehicles = List.copyOf(vehicles);
        changed();
    }

    /** What is shown. */
    public List<ShownVehicle> vehicles() {
        return vehicles;
    }

    /** The bow up, the middle at the origin. */
    private static Path2D hull() {
        Path2D hull = new Path2D.Double();
        hull.moveTo(0, -HULL_PX);
        hull.curveTo(6, -7, 6.5, 0, 5.5, HULL_PX - 3);
        hull.lineTo(-5.5, HULL_PX - 3);
        hull.curveTo(-6.5, 0, -6, -7, 0, -HULL_PX);
        hull.closePath();
        return hull;
    }

    @Override
    protected void paint(MapPaint paint) {
        MapFrame frame = paint.frame();
        List<Rectangle2D> taken = new ArrayList<>();
        for (ShownVehicle vehicle : vehicles) {
            taken.add(around(frame.px(vehicle.at()), frame.py(vehicle.at())));
            paint.paint(vehicle.id(), () -> hull(paint, vehicle));
        }
        for (ShownVehicle vehicle : vehicles) {
            paint.paint(vehicle.id(), () -> name(paint, vehicle, taken));
        }
    }

    private static Rectangle2D around(double x, double y) {
        return new Rectangle2D.Double(x - HULL_PX, y - HULL_PX, 2 * HULL_PX, 2 * HULL_PX);
    }

    private static void hull(MapPaint paint, ShownVehicle vehicle) {
        Graphics2D g = paint.g();
        double x = paint.frame().px(vehicle.at());
        double y = paint.frame().py(vehicle.at());
        double vector = vehicle.speedMps() * AHEAD_S / paint.frame().metresPerPixel();
        if (vector >= LEAST_VECTOR_PX && !vehicle.isStale()) {
            g.setStroke(THICK);
            g.setColor(vehicle.mark().color());
            g.draw(new Line2D.Double(
                    x, y, x + vector * Math.sin(vehicle.courseRad()), y - vector * Math.cos(vehicle.courseRad())));
        }
        AffineTransform turn = AffineTransform.getTranslateInstance(x, y);
        turn.rotate(vehicle.headingRad());
        java.awt.Shape shape = turn.createTransformedShape(HULL);
        if (vehicle.selected()) {
            g.setColor(SemanticColor.ACCENT.get());
            g.setStroke(THICK);
            double ring = HULL_PX + 5;
            g.draw(new java.awt.geom.Ellipse2D.Double(x - ring, y - ring, 2 * ring, 2 * ring));
        }
        Color fill = vehicle.isStale()
                ? Painting.alpha(vehicle.mark().color(), 0.35)
                : vehicle.mark().color();
        g.setColor(fill);
        g.fill(shape);
        g.setStroke(THIN);
        g.setColor(SemanticColor.TEXT.get());
        g.draw(shape);
    }

    private static void name(MapPaint paint, ShownVehicle vehicle, List<Rectangle2D> taken) {
        paint.font(vehicle.selected() ? Font.BOLD : Font.PLAIN);
        String text = vehicle.isStale()
                ? vehicle.shortName() + " · " + Math.round(vehicle.ageS()) + " s old"
                : vehicle.shortName();
        double x = paint.frame().px(vehicle.at());
        double y = paint.frame().py(vehicle.at());
        Rectangle2D size = paint.plate(text, 0, 0);
        double apart = HULL_PX + 3;
        double[][] corners = {
            {x + apart, y - size.getHeight() / 2},
            {x - apart - size.getWidth(), y - size.getHeight() / 2},
            {x - size.getWidth() / 2, y + apart},
            {x - size.getWidth() / 2, y - apart - size.getHeight()},
            {x + apart, y + apart / 2},
            {x + apart, y - apart / 2 - size.getHeight()},
            {x - apart - size.getWidth(), y + apart / 2},
            {x - apart - size.getWidth(), y - apart / 2 - size.getHeight()}
        };
        List<Rectangle2D> plates = new ArrayList<>();
        for (double[] corner : corners) {
            plates.add(paint.plate(text, corner[0], corner[1]));
        }
        Rectangle2D plate = plates.stream()
                .min(Comparator.comparingDouble(candidate -> hidden(candidate, taken)))
                .orElseThrow();
        taken.add(plate);
        paint.write(text, plate);
    }

    /** How much of others a plate would hide, in square pixels. */
    private static double hidden(Rectangle2D plate, List<Rectangle2D> taken) {
        double hidden = 0;
        for (Rectangle2D other : taken) {
            Rectangle2D both = plate.createIntersection(other);
            if (both.getWidth() > 0 && both.getHeight() > 0) {
                hidden += both.getWidth() * both.getHeight();
            }
        }
        return hidden;
    }

    @Override
    public Optional<GeoBounds> bounds() {
        return GeoBounds.of(vehicles.stream().map(ShownVehicle::at).toList());
    }

    @Override
    public Optional<String> itemAt(MapFrame frame, double px, double py) {
        return vehicles.stream()
                .filter(vehicle -> frame.distancePx(vehicle.at(), px, py) <= REACH_PX)
                .min(Comparator.comparingDouble(vehicle -> frame.distancePx(vehicle.at(), px, py)))
                .map(ShownVehicle::id);
    }

    @Override
    public void offer(Snapping snapping) {
        vehicles.forEach(vehicle -> snapping.addCorner(vehicle.at()));
    }
}
