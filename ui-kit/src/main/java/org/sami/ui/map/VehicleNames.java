package org.sami.ui.map;

import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sami.ui.map.Sprites.Sprite;

/**
 * Writes the names of vehicles beside their hulls, each where it hides least. In a crowd, a name that would hide others is left out until
 * somebody looks nearer; the names of vehicles that are chosen, spoken of or silent are always written.
 */
final class VehicleNames {
    private static final int CROWD = 30;
    private static final double MOST_HIDDEN_IN_A_CROWD = 0.25; // of a name's plate

    private final Sprites<Name> sprites = new Sprites<>();
    private final Taken taken = new Taken();

    private record Name(String text, boolean bold) {}

    /** Writes the names of vehicles that are on the map. */
    void paint(MapPaint paint, List<ShownVehicle> vehicles) {
        double half = VehicleHulls.halfPx();
        taken.clear();
        for (ShownVehicle vehicle : vehicles) {
            taken.add(paint.frame().px(vehicle.at()) - half, paint.frame().py(vehicle.at()) - half, 2 * half, 2 * half);
        }
        boolean crowd = vehicles.size() > CROWD;
        List<ShownVehicle> order = new ArrayList<>(vehicles);
        if (crowd) {
            order.sort(Comparator.comparing(vehicle -> !isImportant(paint, vehicle))); // these have the first choice
        }
        for (ShownVehicle vehicle : order) {
            double most = crowd && !isImportant(paint, vehicle) ? MOST_HIDDEN_IN_A_CROWD : Double.POSITIVE_INFINITY;
            paint.paint(vehicle.id(), () -> write(paint, vehicle, most));
        }
    }

    private static boolean isImportant(MapPaint paint, ShownVehicle vehicle) {
        return vehicle.selected() || vehicle.isStale() || paint.isHighlighted(vehicle.id());
    }

    private void write(MapPaint paint, ShownVehicle vehicle, double mostHidden) {
        String text = vehicle.isStale()
                ? vehicle.shortName() + " · " + Math.round(vehicle.ageS()) + " s old"
                : vehicle.shortName();
        Sprite plate = plate(paint, new Name(text, vehicle.selected()));
        double x = paint.frame().px(vehicle.at());
        double y = paint.frame().py(vehicle.at());
        double w = plate.width();
        double h = plate.height();
        double apart = VehicleHulls.halfPx() + (vehicle.selected() ? VehicleHulls.RING_PX + 3 : 3);
        double[] corners = {
            x + apart,
            y - h / 2,
            x - apart - w,
            y - h / 2,
            x - w / 2,
            y + apart,
            x - w / 2,
            y - apart - h,
            x + apart,
            y + apart / 2,
            x + apart,
            y - apart / 2 - h,
            x - apart - w,
            y + apart / 2,
            x - apart - w,
            y - apart / 2 - h
        };
        double least = mostHidden * w * h;
        int best = -1;
        for (int i = 0; i < corners.length && least > 0; i += 2) {
            double hidden = taken.hidden(corners[i], corners[i + 1], w, h, least);
            if (hidden < least) {
                least = hidden;
                best = i;
            }
        }
        if (best >= 0) {
            taken.add(corners[best], corners[best + 1], w, h);
            plate.paint(paint.g(), corners[best], corners[best + 1]);
        }
    }

    private Sprite plate(MapPaint paint, Name name) {
        Graphics2D g = paint.g();
        Font before = g.getFont();
        paint.font(name.bold() ? Font.BOLD : Font.PLAIN);
        Rectangle2D room = paint.plate(name.text(), 0, 0);
        Sprite plate = sprites.get(
                g,
                name,
                room.getWidth(),
                room.getHeight(),
                own -> new MapPaint(own, paint.frame(), paint.highlighted()).write(name.text(), room));
        g.setFont(before);
        return plate;
    }

    /** Rectangles that are painted on already. */
    private static final class Taken {
        private double[] edges = new double[256]; // left, top, right, bottom of each
        private int used;

        void clear() {
            used = 0;
        }

        void add(double left, double top, double width, double height) {
            if (used + 4 > edges.length) {
                edges = java.util.Arrays.copyOf(edges, 2 * edges.length);
            }
            edges[used++] = left;
            edges[used++] = top;
            edges[used++] = left + width;
            edges[used++] = top + height;
        }

        /** How much of them a rectangle would hide, in square pixels; counted until it is not less than {@code enough}. */
        double hidden(double left, double top, double width, double height, double enough) {
            double hidden = 0;
            for (int i = 0; i < used && hidden < enough; i += 4) {
                double across = Math.min(left + width, edges[i + 2]) - Math.max(left, edges[i]);
                if (across > 0) {
                    double down = Math.min(top + height, edges[i + 3]) - Math.max(top, edges[i + 1]);
                    hidden += across * Math.max(0, down);
                }
            }
            return hidden;
        }
    }
}
