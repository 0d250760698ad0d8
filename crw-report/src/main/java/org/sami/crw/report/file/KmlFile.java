package org.sami.crw.report.file;

import java.awt.Color;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapNames;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.report.picture.MapColors;

/**
 * A run as KML 2.2, with Google's extension for tracks with times: boats, locations, areas and points in folders. Positions are
 * WGS 84 in degrees, at the height of the water or the ground; tracks of robots that flew are so high above it as the robots were above
 * the place of their take-off. Times are UTC, the start of the run plus its time. Where nobody wrote down when it began, tracks are lines without times.
 */
final class KmlFile {
    private static final String NAMESPACE = "http://www.opengis.net/kml/2.2";
    private static final String EXTENSION = "http://www.google.com/kml/ext/2.2";

    private static final String OVER_GROUND = "relativeToGround"; // KML has no height above a take-off

    private final RunReport report;
    private final XmlText xml = new XmlText("kml", NAMESPACE);

    private KmlFile(RunReport report) {
        this.report = report;
    }

    static String text(RunReport report) {
        return new KmlFile(report).write();
    }

    private String write() {
        xml.prefix("gx", EXTENSION);
        xml.open("Document").leaf("name", report.header().planName()).leaf("description", MapNames.run(report));
        for (int i = 0; i < report.boats().size(); i++) {
            style("boat" + i, MapColors.color(report.boats().get(i).mark()), 255, 3);
        }
        for (MapArea.Kind kind : MapArea.Kind.values()) {
            style("area-" + kind.name().toLowerCase(Locale.ROOT), MapColors.area(kind), 70, 2);
        }
        folder(report.header().robots().say("boats"), this::tracks);
        folder("locations", this::locations);
        folder("areas", () -> MapNames.areas(report).forEach(this::area));
        folder("points", this::points);
        xml.close();
        return xml.end();
    }

    private void folder(String name, Runnable content) {
        xml.open("Folder").leaf("name", name);
        content.run();
        xml.close();
    }

    private void style(String id, Color color, int fillAlpha, int width) {
        xml.open("Style", "id", id);
        xml.open("LineStyle")
                .leaf("color", hex(color, 255))
                .leaf("width", String.valueOf(width))
                .close();
        xml.open("PolyStyle").leaf("color", hex(color, fillAlpha)).close();
        xml.close();
    }

    /** Opacity, blue, green, red. */
    private static String hex(Color color, int alpha) {
        return String.format("%02x%02x%02x%02x", alpha, color.getBlue(), color.getGreen(), color.getRed());
    }

    private void tracks() {
        for (int i = 0; i < report.boats().size(); i++) {
            BoatResult boat = report.boats().get(i);
            placemark(boat.id(), MapNames.of(boat), Optional.of("boat" + i));
            if (report.origin().isPresent()) {
                timedTrack(boat, report.origin().get());
            } else {
                line(boat);
            }
            xml.close();
        }
    }

    /** First all times, then all positions, as the extension wants them. */
    private void timedTrack(BoatResult boat, RunOrigin origin) {
        boolean flew = boat.flew();
        xml.open("gx:Track");
        if (flew) {
            xml.leaf("altitudeMode", OVER_GROUND);
        }
        boat.track()
                .forEach(point -> xml.leaf("when", origin.at(point.atMillis()).toString()));
        boat.track().forEach(point -> xml.leaf("gx:coord", position(point, flew, " ", " 0")));
        xml.close();
    }

    private void line(BoatResult boat) {
        boolean flew = boat.flew();
        xml.open("LineString").leaf("tessellate", "1");
        if (flew) {
            xml.leaf("altitudeMode", OVER_GROUND);
        }
        xml.leaf("coordinates", coordinates(boat.track().stream().map(point -> position(point, flew, ",", ""))));
        xml.close();
    }

    private static String position(TrackPoint point, boolean flew, String between, String onGround) {
        return degrees(point.latDeg(), point.lonDeg(), between)
                + (flew ? between + CsvTable.fixed(point.altM(), 2) : onGround);
    }

    private void locations() {
        for (LocationResult location : report.locations()) {
            placemark("location " + location.number(), MapNames.of(location), Optional.empty());
            point(location.latDeg(), location.lonDeg());
            xml.close();
        }
    }

    private void points() {
        report.header().place().quay().ifPresent(quay -> {
            placemark(
                    report.header().robots().say("quay"),
                    report.header().robots().say("where boats lay at the start"),
                    Optional.empty());
            point(quay.latDeg(), quay.lonDeg());
            xml.close();
        });
        for (MapSpot spot : report.map().spots()) {
            placemark(MapNames.of(spot), spot.kind().words(), Optional.empty());
            point(spot.at().latDeg(), spot.at().lonDeg());
            xml.close();
        }
    }

    private void area(MapArea area) {
        placemark(
                area.kind().words(),
                area.kind().words(),
                Optional.of("area-" + area.kind().name().toLowerCase(Locale.ROOT)));
        xml.open("Polygon");
        ring("outerBoundaryIs", area.outline());
        area.holes().forEach(hole -> ring("innerBoundaryIs", hole));
        xml.close().close();
    }

    private void ring(String element, List<MapPoint> points) {
        Stream<MapPoint> closed = Stream.concat(points.stream(), Stream.of(points.get(0)));
        xml.open(element).open("LinearRing");
        xml.leaf("coordinates", coordinates(closed.map(p -> degrees(p.latDeg(), p.lonDeg(), ","))));
        xml.close().close();
    }

    private void placemark(String name, String description, Optional<String> style) {
        xml.open("Placemark").leaf("name", name).leaf("description", description);
        style.ifPresent(id -> xml.leaf("styleUrl", "#" + id));
    }

    private void point(double latDeg, double lonDeg) {
        xml.open("Point").leaf("coordinates", degrees(latDeg, lonDeg, ",")).close();
    }

    private static String coordinates(Stream<String> positions) {
        return positions.collect(Collectors.joining(" "));
    }

    /** Longitude comes first. */
    private static String degrees(double latDeg, double lonDeg, String between) {
        return XmlText.degrees(lonDeg) + between + XmlText.degrees(latDeg);
    }
}
