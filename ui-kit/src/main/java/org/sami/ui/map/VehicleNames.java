package org.sami.ui.map;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.palette.SemanticColor;
import org.sami.ui.map.Sprites.Sprite;

/**
 * Writes the names of vehicles, each next to its hull where it hides nothing, or a little away with a line to it. A name that would hide
 * others at every position is left out until the map is zoomed in. A name is never dimmed: where other things are highlighted it is written
 * in the colour of less weight, so that each boat is still known. The names of vehicles that are chosen, spoken of or silent are
 * always written, and have the first choice.
 */
final class VehicleNames {
    private static final double MOST_HIDDEN = 0.2; // of a name's plate
    private static final int MAX_FULLY_LABELLED = 8; // of so many, each has its name, if need be away from its hull
    private static final int PLACES = 8; // around a hull

    private final Sprites<Name> sprites = new Sprites<>();
    private final Map<String, Integer> before = new HashMap<>(); // at which place a name stood last, so that it stays

    private record Name(String text, boolean bold, boolean quiet) {}

    /** Writes the names of vehicles that are on the map. */
    void paint(MapPaint paint, List<ShownVehicle> vehicles) {
        double half = VehicleHulls.halfPx();
        for (ShownVehicle vehicle : vehicles) {
            paint.labels()
                    .add(
                            paint.frame().px(vehicle.at()) - half,
                            paint.frame().py(vehicle.at()) - half,
                            2 * half,
                            2 * half);
        }
        List<ShownVehicle> order = new ArrayList<>(vehicles);
        order.sort(Comparator.comparing(vehicle -> !isImportant(paint, vehicle)));
        order.forEach(
                vehicle -> write(paint, vehicle, isImportant(paint, vehicle), vehicles.size() <= MAX_FULLY_LABELLED));
    }

    /** Where many are spoken of, none of them is more important than others. */
    private static boolean isImportant(MapPaint paint, ShownVehicle vehicle) {
        return vehicle.selected()
                || vehicle.isStale()
                || (paint.highlighted().size() <= MAX_FULLY_LABELLED && paint.isHighlighted(vehicle.id()));
    }

    private void write(MapPaint paint, ShownVehicle vehicle, boolean important, boolean few) {
        String text = vehicle.isStale() ? vehicle.shortName() + " · " + vehicle.age() + " old" : vehicle.shortName();
        Sprite plate = plate(paint, new Name(text, vehicle.selected(), paint.isDimmed(vehicle.id())));
        double x = paint.frame().px(vehicle.at());
        double y = paint.frame().py(vehicle.at());
        double w = plate.width();
        double h = plate.height();
        double apart = VehicleHulls.halfPx() + (vehicle.selected() ? VehicleHulls.RING_PX + 3 : 3);
        double[] corners = corners(x, y, w, h, apart, important || few ? 3 : 1);
        int last = before.getOrDefault(vehicle.id(), PLACES);
        int place = last < PLACES && paint.labels().isFree(corners[2 * last], corners[2 * last + 1], w, h)
                ? last
                : paint.labels().place(corners, w, h, important ? 1 : MOST_HIDDEN);
        if (place >= 0) {
            double left = corners[2 * place];
            double top = corners[2 * place + 1];
            before.put(vehicle.id(), place);
            paint.labels().addText(left, top, w, h);
            if (place >= PLACES) {
                lead(paint, x, y, new Rectangle2D.Double(left, top, w, h));
            }
            plate.paint(paint.g(), left, top);
        }
    }

    /** The left upper corners of places around a hull, in rings, the nearest first. */
    private static double[] corners(double x, double y, double w, double h, double apart, int rings) {
        double[] corners = new double[2 * PLACES * rings];
        int at = 0;
        for (int ring = 0; ring < rings; ring++) {
            double far = apart + ring * 1.7 * h;
            double aside = ring == 0 ? far / 2 : far - h; // the outer ones stand around, not in a column
            double[] places = {
                x + far,
                y - h / 2,
                x - far - w,
                y - h / 2,
                x - w / 2,
                y + far,
                x - w / 2,
                y - far - h,
                x + far,
                y + aside,
                x + far,
                y - aside - h,
                x - far - w,
                y + aside,
                x - far - w,
                y - aside - h
            };
            System.arraycopy(places, 0, corners, at, places.length);
            at += places.length;
        }
        return corners;
    }

    /** A thin line from a hull to a name that stands away from it. */
    private static void lead(MapPaint paint, double x, double y, Rectangle2D plate) {
        Graphics2D g = paint.g();
        g.setColor(SemanticColor.TEXT.withAlpha(150));
        g.setStroke(Painting.butt(1));
        g.draw(new Line2D.Double(
                x,
                y,
                Math.max(plate.getMinX(), Math.min(plate.getMaxX(), x)),
                Math.max(plate.getMinY(), Math.min(plate.getMaxY(), y))));
    }

    private Sprite plate(MapPaint paint, Name name) {
        Graphics2D g = paint.g();
        Font font = g.getFont();
        paint.font(name.bold() ? Font.BOLD : Font.PLAIN);
        Rectangle2D room = paint.plate(name.text(), 0, 0);
        Sprite plate = sprites.get(
                g,
                name,
                room.getWidth(),
                room.getHeight(),
                own -> new MapPaint(own, paint.frame(), paint.highlighted(), paint.labels(), paint.imagery())
                        .write(name.text(), room, name.quiet() ? SemanticColor.MUTED : SemanticColor.TEXT));
        g.setFont(font);
        return plate;
    }
}
