package org.sami.crw.report.picture;

import java.awt.Color;
import java.awt.Font;
import java.awt.FontMetrics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;

/** Tracks, locations, points of the plan, starts and ends on the map. */
final class FleetDrawing {
    /** Discs have room for numbers up to here; beyond, locations are dots (locations.csv has the numbers). */
    private static final int NUMBERED_LOCATIONS = 150;

    private static final double BOAT_RADIUS = 12;
    private static final int NAMED_BOATS = 30;
    private static final int NAMED_AT_START = 6;

    private final RunReport report;
    private final Rectangle frame;
    private final MapScale scale;
    private final LabelSpace labels;
    private final double locationRadius;
    private final Map<Integer, Point2D> ends = new HashMap<>(); // where each boat's sign stands

    FleetDrawing(RunReport report, Rectangle frame, MapScale scale) {
        this.report = report;
        this.frame = frame;
        this.scale = scale;
        this.labels = new LabelSpace(frame);
        int locations = report.locations().size();
        locationRadius = locations <= NUMBERED_LOCATIONS ? MapSymbols.LOCATION_RADIUS : 4;
    }

    void draw(Graphics2D g) {
        Shape before = g.getClip();
        g.clip(frame);
        List<BoatResult> boats = report.boats();
        for (int i = 0; i < boats.size(); i++) {
            track(g, boats.get(i));
        }
        report.map().spots().forEach(spot -> spot(g, spot));
        report.locations().forEach(location -> labels.take(at(location), 2));
        report.locations().forEach(location -> location(g, location));
        report.map().closest().underWay().ifPresent(near -> labels.take(at(near.where()), 14));
        for (int i = 0; i < boats.size(); i++) {
            ends(g, i, boats.get(i).track());
        }
        for (int i = 0; i < boats.size() && boats.size() <= NAMED_BOATS; i++) {
            name(g, i, boats.get(i));
        }
        report.header().place().quay().ifPresent(quay -> quay(g, at(quay)));
        report.map().closest().underWay().ifPresent(near -> MapSymbols.approach(g, at(near.where())));
        g.setClip(before);
    }

    private void track(Graphics2D g, BoatResult boat) {
        if (boat.track().isEmpty()) {
            return;
        }
        Path2D line = new Path2D.Double();
        for (TrackPoint point : boat.track()) {
            Point2D at = at(point);
            if (line.getCurrentPoint() == null) {
                line.moveTo(at.getX(), at.getY());
            } else {
                line.lineTo(at.getX(), at.getY());
            }
        }
        MapColors.track(g, line, boat.mark());
    }

    private void spot(Graphics2D g, MapSpot spot) {
        if (spot.kind() == MapSpot.Kind.ASSEMBLY) {
            MapSymbols.assembly(g, at(spot.at()), color(spot.boat()));
        } else {
            MapSymbols.planPoint(g, at(spot.at()));
        }
        labels.take(at(spot.at()), 9);
    }

    /** A disc that would cover another is drawn next to its location, with a line to it. */
    private void location(Graphics2D g, LocationResult location) {
        Point2D at = at(location);
        boolean numbered = report.locations().size() <= NUMBERED_LOCATIONS;
        Color visitor = location.visit().map(visit -> color(visit.boat())).orElse(null);
        Point2D disc = numbered ? labels.disc(at, locationRadius) : at;
        if (disc.distance(at) > 1) {
            g.setColor(MapColors.INK);
            g.setStroke(MapColors.dashed(1.2f));
            g.draw(new Line2D.Double(at, disc));
            MapSymbols.location(g, at, "", visitor, 4);
        }
        MapSymbols.location(g, disc, numbered ? String.valueOf(location.number()) : "", visitor, locationRadius);
    }

    /** The quay's sign is next to the boats that begin there. */
    private void quay(Graphics2D g, Point2D at) {
        Rectangle2D box = labels.place(at, 20, 20);
        Point2D sign = new Point2D.Double(box.getCenterX(), box.getCenterY());
        g.setColor(MapColors.INK);
        g.setStroke(MapColors.dashed(1.2f));
        g.draw(new Line2D.Double(at, sign));
        MapSymbols.quay(g, sign);
    }

    private Color color(String id) {
        return MapColors.color(report.boats().stream()
                .filter(boat -> boat.id().equals(id))
                .mapToInt(BoatResult::mark)
                .findFirst()
                .orElse(0));
    }

    private void ends(Graphics2D g, int boat, List<TrackPoint> track) {
        if (track.isEmpty()) {
            return;
        }
        Color color = MapColors.color(report.boats().get(boat).mark());
        TrackPoint last = track.get(track.size() - 1);
        MapSymbols.start(g, at(track.get(0)), color);
        // a boat mostly ends on its last location: its sign stands ahead, so that both can be seen
        Point2D end = labels.ahead(at(last), BOAT_RADIUS, bearing(track));
        ends.put(boat, end);
        MapSymbols.boat(g, end, bearing(track), color);
        labels.take(at(track.get(0)), 9);
    }

    /** The name stands at the start, for boats mostly end where there is little room; that of many at the end. */
    private void name(Graphics2D g, int boat, BoatResult result) {
        if (result.track().isEmpty()) {
            return;
        }
        g.setFont(DrawnText.font(Font.BOLD, 14));
        FontMetrics metrics = g.getFontMetrics();
        double width = metrics.stringWidth(result.id()) + 8.0;
        boolean atStart = report.boats().size() <= NAMED_AT_START;
        Point2D sign = atStart ? at(result.track().get(0)) : Objects.requireNonNull(ends.get(boat), "end");
        Rectangle2D box = labels.place(sign, width, metrics.getHeight());
        Color color = MapColors.color(result.mark()).darker();
        if (!atStart) {
            line(g, sign, box, color);
        }
        g.setColor(new Color(255, 255, 255, 200));
        g.fill(box);
        g.setColor(color);
        g.drawString(result.id(), (float) box.getX() + 4, (float) (box.getMaxY() - metrics.getDescent()));
    }

    /** From the rim of a sign to its name, if that stands apart. */
    private static void line(Graphics2D g, Point2D sign, Rectangle2D box, Color color) {
        double east = box.getCenterX() - sign.getX();
        double south = box.getCenterY() - sign.getY();
        double part = Math.min(1, BOAT_RADIUS / Math.max(1, Math.hypot(east, south)));
        g.setColor(color);
        g.setStroke(MapColors.dashed(1));
        g.draw(new Line2D.Double(
                sign.getX() + part * east, sign.getY() + part * south, box.getCenterX(), box.getCenterY()));
    }

    private Point2D at(LocationResult location) {
        return scale.at(location.eastM(), location.northM());
    }

    private Point2D at(MapPoint point) {
        return scale.at(point.eastM(), point.northM());
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
}
