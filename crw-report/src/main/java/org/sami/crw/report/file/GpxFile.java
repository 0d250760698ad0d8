package org.sami.crw.report.file;

import java.util.List;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapNames;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.TrackPoint;

/**
 * A run as GPX 1.1: a track for each boat, way points for locations, quay and points of the plan, a closed route for each area (the
 * format has no areas). Positions are WGS 84 in degrees; times are UTC, the start of the run plus its time, and missing where nobody
 * wrote down when it began. Tracks of robots that flew have elevations: metres above the place of the take-off, not above the sea.
 */
final class GpxFile {
    private static final String NAMESPACE = "http://www.topografix.com/GPX/1/1";

    private final RunReport report;
    private final XmlText xml = new XmlText("gpx", NAMESPACE);

    private GpxFile(RunReport report) {
        this.report = report;
    }

    static String text(RunReport report) {
        return new GpxFile(report).write();
    }

    private String write() {
        xml.attribute("version", "1.1").attribute("creator", "crw");
        xml.open("metadata").leaf("name", report.header().planName()).leaf("desc", MapNames.run(report));
        report.origin().ifPresent(origin -> xml.leaf("time", origin.startedAt().toString()));
        xml.close();
        report.header()
                .place()
                .quay()
                .ifPresent(quay -> wayPoint(
                        quay,
                        report.header().robots().say("quay"),
                        report.header().robots().say("where boats lay at the start")));
        report.locations()
                .forEach(location ->
                        wayPoint(MapNames.point(location), "location " + location.number(), MapNames.of(location)));
        report.map()
                .spots()
                .forEach(spot ->
                        wayPoint(spot.at(), MapNames.of(spot), spot.kind().words()));
        MapNames.areas(report).forEach(this::route);
        report.boats().forEach(this::track);
        return xml.end();
    }

    private void wayPoint(MapPoint at, String name, String description) {
        point("wpt", at.latDeg(), at.lonDeg())
                .leaf("name", name)
                .leaf("desc", description)
                .close();
    }

    private void route(MapArea area) {
        ring(area.kind().words(), area.outline());
        area.holes().forEach(hole -> ring(area.kind().words() + ", hole", hole));
    }

    private void ring(String name, List<MapPoint> points) {
        xml.open("rte").leaf("name", name);
        points.forEach(p -> point("rtept", p.latDeg(), p.lonDeg()).close());
        point("rtept", points.get(0).latDeg(), points.get(0).lonDeg()).close();
        xml.close();
    }

    private void track(BoatResult boat) {
        xml.open("trk").leaf("name", boat.id()).leaf("desc", MapNames.of(boat)).open("trkseg");
        boolean flew = boat.flew();
        for (TrackPoint at : boat.track()) {
            point("trkpt", at.latDeg(), at.lonDeg());
            if (flew) {
                xml.leaf("ele", metres(at.altM()));
            }
            report.origin()
                    .ifPresent(
                            origin -> xml.leaf("time", origin.at(at.atMillis()).toString()));
            xml.close();
        }
        xml.close().close();
    }

    private static String metres(double metres) {
        return CsvTable.fixed(metres, 2);
    }

    private XmlText point(String element, double latDeg, double lonDeg) {
        return xml.open(element, "lat", XmlText.degrees(latDeg), "lon", XmlText.degrees(lonDeg));
    }
}
