package org.sami.crw.sim.report;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;

/** Tracks, locations, starts and ends on the map. */
final class FleetDrawing {
    /** Discs have room for numbers up to here; beyond, locations are dots (locations.csv has the numbers). */
    private static final int NUMBERED_LOCATIONS = 150;

    private static final int NAMED_BOATS = 30;
    private static final int NAMED_AT_START = 6;

    private final RunReport report;
    private final Rectangle frame;
    private final MapScale scale;
    private final LabelSpace labels;
    private final double locationRadius;

    FleetDrawing(RunReport report, Rectangle frame, MapScale scale) {
        this.report = report;
        this.frame = frame;
        this.scale = scale;
        this.labels = new LabelSpace(frame);
        int locations = report.locations().size();
        locationRadius = locations <= 60 ? Signs.LOCATION_RADIUS : locations <= NUMBERED_LOCATIONS ? 10 : 4;
    }

    void draw(Graphics2D g) {
        Shape before = g.getClip();
        g.clip(frame);
        List<BoatResult> boats = report.boats();
        for (int i = 0; i < boats.size(); i++) {
            track(g, i, boats.get(i).track());
        }
        report.locations().forEach(location -> location(g, location));
        for (int i = 0; i < boats.size(); i++) {
            ends(g, i, boats.get(i).track());
        }
        for (int i = 0; i < boats.size() && boats.size() <= NAMED_BOATS; i++) {
            name(g, i, boats.get(i));
        }
        g.setClip(before);
    }

    private void track(Graphics2D g, int boat, List<TrackPoint> track) {
        if (track.isEmpty()) {
            return;
        }
        Path2D line = new Path2D.Double();
        for (TrackPoint point : track) {
            Point2D at = at(point);
            if (line.getCurrentPoint() == null) {
                line.moveTo(at.getX(), at.getY());
            } else {
                line.lineTo(at.getX(), at.getY());
            }
        }
        g.setColor(Palette.color(boat));
        g.setStroke(Palette.line(boat));
        g.draw(line);
    }

    private void location(Graphics2D g, LocationResult location) {
        Point2D at = scale.at(location.eastM(), location.northM());
        int boat = boatIndex(location.visitedBy());
        labels.take(at, locationRadius + 3);
        String number = report.locations().size() <= NUMBERED_LOCATIONS ? String.valueOf(location.number()) : "";
        Signs.location(g, at, number, location.visited() ? Palette.color(boat) : null, locationRadius);
    }

    private int boatIndex(String id) {
        List<String> ids = report.boats().stream().map(BoatResult::id).toList();
        return Math.max(0, ids.indexOf(id));
    }

    private void ends(Graphics2D g, int boat, List<TrackPoint> track) {
        if (track.isEmpty()) {
            return;
        }
        Color color = Palette.color(boat);
        TrackPoint last = track.get(track.size() - 1);
        Signs.start(g, at(track.get(0)), color);
        Point2D end = beside(at(last), bearing(track));
        Signs.boat(g, end, bearing(track), color);
        labels.take(at(track.get(0)), 9);
        labels.take(end, 12);
    }

    /** A boat mostly ends on its last location; its sign is moved ahead so that both can be seen. */
    private Point2D beside(Point2D end, double bearingRad) {
        boolean covers = report.locations().stream()
                .anyMatch(l -> scale.at(l.eastM(), l.northM()).distance(end) < 2 * locationRadius);
        return covers
                ? new Point2D.Double(
                        end.getX() + 2 * locationRadius * Math.sin(bearingRad),
                        end.getY() - 2 * locationRadius * Math.cos(bearingRad))
                : end;
    }

    /** The name stands at the start, for boats mostly end where there is little room; that of many at the end. */
    private void name(Graphics2D g, int boat, BoatResult result) {
        if (result.track().isEmpty()) {
            return;
        }
        g.setFont(MapPicture.font(Font.BOLD, 14));
        FontMetrics metrics = g.getFontMetrics();
        double width = metrics.stringWidth(result.id()) + 8.0;
        int named = report.boats().size() <= NAMED_AT_START ? 0 : result.track().size() - 1;
        Rectangle2D box = labels.place(at(result.track().get(named)), width, metrics.getHeight());
        g.setColor(new Color(255, 255, 255, 200));
        g.fill(box);
        g.setColor(Palette.color(boat).darker());
        g.drawString(result.id(), (float) box.getX() + 4, (float) (box.getMaxY() - metrics.getDescent()));
    }

    private Point2D at(TrackPoint point) {
        return scale.at(point.eastM(), point.northM());
    }

    /** The way of the last metre or more, clockwise from north, in radians. */
    private static double bearing(List<TrackPoint> track) {
        TrackPoint last = track.get(track.size() - 1);
        for (int i = track.size() - 2; i >= 0; i--) {
            double east = last.eastM() - track.get(i).eastM();
            double north = last.northM() - track.get(i).northM();
            if (Math.hypot(east, north) > 1) {
                return Math.atan2(east, north);
            }
        }
        return 0;
    }

    /** The signs of the map; the legend shows the same. */
    static final class Signs {
        static final double LOCATION_RADIUS = 12;

        private Signs() {}

        /** A numbered location: filled with the visitor's colour and ticked, or empty with a dashed rim. */
        static void location(Graphics2D g, Point2D at, String number, Color visitor, double radius) {
            Shape disc = circle(at, radius);
            g.setColor(visitor == null ? Palette.PAPER : visitor);
            g.fill(disc);
            g.setColor(Palette.INK);
            g.setStroke(visitor == null ? Palette.dashed(1.8f, 4, 3) : Palette.dashed(1.2f));
            g.draw(disc);
            g.setColor(visitor == null ? Palette.INK : Palette.textOn(visitor));
            g.setFont(MapPicture.font(Font.BOLD, number.length() > 2 || radius < LOCATION_RADIUS ? 10 : 13));
            FontMetrics metrics = g.getFontMetrics();
            g.drawString(number, (float) (at.getX() - metrics.stringWidth(number) / 2.0), (float)
                    (at.getY() + (metrics.getAscent() - metrics.getDescent()) / 2.0));
            if (visitor != null && !number.isEmpty()) {
                tick(g, new Point2D.Double(at.getX() + radius - 2, at.getY() - radius + 2));
            }
        }

        private static void tick(Graphics2D g, Point2D at) {
            g.setColor(Palette.PAPER);
            g.fill(circle(at, 7));
            g.setColor(Palette.INK);
            g.setStroke(Palette.dashed(1));
            g.draw(circle(at, 7));
            Path2D tick = new Path2D.Double();
            tick.moveTo(at.getX() - 3.4, at.getY());
            tick.lineTo(at.getX() - 1, at.getY() + 3);
            tick.lineTo(at.getX() + 3.6, at.getY() - 3.2);
            g.setStroke(Palette.dashed(2));
            g.draw(tick);
        }

        /** Where a boat started: a square. */
        static void start(Graphics2D g, Point2D at, Color color) {
            Rectangle2D square = new Rectangle2D.Double(at.getX() - 6, at.getY() - 6, 12, 12);
            g.setColor(color);
            g.fill(square);
            g.setColor(Palette.INK);
            g.setStroke(Palette.dashed(1.4f));
            g.draw(square);
        }

        /** Where a boat is at the end: an arrowhead in the direction of its way. */
        static void boat(Graphics2D g, Point2D at, double bearingRad, Color color) {
            Path2D hull = new Path2D.Double();
            hull.moveTo(0, -13);
            hull.lineTo(8, 9);
            hull.lineTo(0, 4);
            hull.lineTo(-8, 9);
            hull.closePath();
            Graphics2D turned = (Graphics2D) g.create();
            turned.translate(at.getX(), at.getY());
            turned.rotate(bearingRad);
            turned.setColor(color);
            turned.fill(hull);
            turned.setColor(Palette.INK);
            turned.setStroke(Palette.dashed(1.6f));
            turned.draw(hull);
            turned.dispose();
        }

        private static Shape circle(Point2D at, double radius) {
            return new Ellipse2D.Double(at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
        }
    }
}
