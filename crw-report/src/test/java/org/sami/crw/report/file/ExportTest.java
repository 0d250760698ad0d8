package org.sami.crw.report.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Instant;
import java.time.ZoneId;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.sami.crw.report.MapArea;
import org.sami.crw.report.MapPoint;
import org.sami.crw.report.MapSpot;
import org.sami.crw.report.RunMap;
import org.sami.crw.report.RunOrigin;
import org.sami.crw.report.RunReport;
import org.sami.crw.report.SampleReport;
import org.sami.crw.report.TrackPoint;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/** The files that other programs draw: each is read back by a parser that knows nothing of its writer. */
class ExportTest {
    private static final Instant START = Instant.parse("2026-11-22T08:00:00.250Z");
    private static final RunReport REPORT = report();

    private static RunReport report() {
        RunReport sample = SampleReport.of(3, 12);
        MapArea explored = new MapArea(
                MapArea.Kind.EXPLORED,
                List.of(point(0, 0), point(0, 100), point(100, 100), point(100, 0)), // clockwise
                List.of(List.of(point(20, 20), point(40, 20), point(30, 40))));
        return sample.withOrigin(new RunOrigin(START, ZoneId.of("Europe/Rome"), "1"))
                .withMap(new RunMap(
                        List.of(explored),
                        List.of(new MapSpot(MapSpot.Kind.ASSEMBLY, "boat<2> & \"co\"\u0001", point(5, 5))),
                        List.of(),
                        sample.map().closest()));
    }

    private static MapPoint point(double eastM, double northM) {
        return new MapPoint(40 + northM / 111_000, -80 + eastM / 85_000, eastM, northM);
    }

    @Test
    void gpxHasEveryPointOfEveryTrackWithItsTime() throws Exception {
        Document gpx = xml(GpxFile.text(REPORT));

        assertThat(gpx.getDocumentElement().getNamespaceURI()).isEqualTo("http://www.topografix.com/GPX/1/1");
        assertThat(gpx.getDocumentElement().getAttribute("version")).isEqualTo("1.1");
        List<Element> tracks = elements(gpx.getDocumentElement(), "trk");
        assertThat(tracks).hasSize(3);
        for (int i = 0; i < 3; i++) {
            List<TrackPoint> track = REPORT.boats().get(i).track();
            List<Element> points = elements(tracks.get(i), "trkpt");
            assertThat(points).hasSameSizeAs(track);
            for (int p = 0; p < points.size(); p++) {
                same(points.get(p).getAttribute("lat"), track.get(p).latDeg());
                same(points.get(p).getAttribute("lon"), track.get(p).lonDeg());
                assertThat(Instant.parse(elements(points.get(p), "time").get(0).getTextContent()))
                        .isEqualTo(START.plusMillis(track.get(p).atMillis()));
            }
        }
        assertThat(elements(gpx.getDocumentElement(), "wpt")).hasSize(1 + 12 + 1);
        assertThat(elements(gpx.getDocumentElement(), "rtept")).hasSize(5 + 4);
    }

    @Test
    void gpxHasItsPartsInTheOrderOfItsSchema() throws Exception {
        Element root = xml(GpxFile.text(REPORT)).getDocumentElement();

        List<String> order = new ArrayList<>();
        NodeList children = root.getChildNodes();
        for (int i = 0; i < children.getLength(); i++) {
            if (children.item(i) instanceof Element child && !order.contains(child.getTagName())) {
                order.add(child.getTagName());
            }
        }
        assertThat(order).containsExactly("metadata", "wpt", "rte", "trk");
    }

    @Test
    void textThatXmlCannotHoldDoesNotBreakAFile() throws Exception {
        List<String> names = elements(xml(GpxFile.text(REPORT)).getDocumentElement(), "name").stream()
                .map(Element::getTextContent)
                .toList();

        assertThat(names).contains("assembly place of boat<2> & \"co\"?");
    }

    @Test
    void kmlHasTracksWithTimesAndClosedAreas() throws Exception {
        Document kml = xml(KmlFile.text(REPORT));

        assertThat(kml.getDocumentElement().getNamespaceURI()).isEqualTo("http://www.opengis.net/kml/2.2");
        List<Element> tracks = elements(kml.getDocumentElement(), "Track");
        assertThat(tracks).hasSize(3);
        List<TrackPoint> track = REPORT.boats().get(1).track();
        List<Element> times = elements(tracks.get(1), "when");
        List<Element> positions = elements(tracks.get(1), "coord");
        assertThat(times).hasSameSizeAs(track);
        assertThat(positions).hasSameSizeAs(track);
        for (int i = 0; i < track.size(); i++) {
            String[] position = positions.get(i).getTextContent().split(" ");
            same(position[0], track.get(i).lonDeg());
            same(position[1], track.get(i).latDeg());
            assertThat(Instant.parse(times.get(i).getTextContent()))
                    .isEqualTo(START.plusMillis(track.get(i).atMillis()));
        }
        for (Element ring : elements(kml.getDocumentElement(), "LinearRing")) {
            String[] corners =
                    elements(ring, "coordinates").get(0).getTextContent().split(" ");
            assertThat(corners[corners.length - 1]).isEqualTo(corners[0]);
        }
        assertThat(elements(kml.getDocumentElement(), "innerBoundaryIs")).hasSize(1);
        assertThat(elements(kml.getDocumentElement(), "Point")).hasSize(1 + 12 + 1);
    }

    @Test
    void kmlWithoutAStartHasLines() throws Exception {
        Document kml = xml(KmlFile.text(SampleReport.of(2, 4)));

        assertThat(elements(kml.getDocumentElement(), "Track")).isEmpty();
        assertThat(elements(kml.getDocumentElement(), "LineString")).hasSize(2);
        assertThat(elements(xml(GpxFile.text(SampleReport.of(2, 4))).getDocumentElement(), "time"))
                .isEmpty();
    }

    @Test
    void geoJsonHasAFeatureForEachThingOnTheMap() throws Exception {
        JsonNode json = new ObjectMapper().readTree(GeoJsonFile.text(REPORT));

        assertThat(json.get("type").asText()).isEqualTo("FeatureCollection");
        List<JsonNode> tracks = features(json, "track");
        assertThat(tracks).hasSize(3);
        List<TrackPoint> track = REPORT.boats().get(0).track();
        JsonNode line = tracks.get(0).at("/geometry/coordinates");
        assertThat(tracks.get(0).at("/geometry/type").asText()).isEqualTo("LineString");
        assertThat(line).hasSameSizeAs(track);
        for (int i = 0; i < track.size(); i++) {
            same(line.get(i).get(0).asText(), track.get(i).lonDeg());
            same(line.get(i).get(1).asText(), track.get(i).latDeg());
            assertThat(tracks.get(0).at("/properties/atS").get(i).asDouble())
                    .isEqualTo(track.get(i).atMillis() / 1000.0);
            assertThat(Instant.parse(
                            tracks.get(0).at("/properties/times").get(i).asText()))
                    .isEqualTo(START.plusMillis(track.get(i).atMillis()));
        }
        assertThat(features(json, "location"))
                .hasSize(12)
                .filteredOn(f -> !f.at("/properties/visited").asBoolean())
                .singleElement()
                .satisfies(f -> assertThat(f.at("/properties/number").asInt()).isEqualTo(3));
        assertThat(features(json, "quay")).hasSize(1);
        assertThat(features(json, "assembly place")).hasSize(1);
    }

    @Test
    void geoJsonAreasAreClosedAndTurnTheWayTheStandardSays() throws Exception {
        JsonNode json = new ObjectMapper().readTree(GeoJsonFile.text(REPORT));

        JsonNode rings = features(json, "explored area").get(0).at("/geometry/coordinates");
        assertThat(rings).hasSize(2);
        assertThat(rings.get(0)).hasSize(5);
        assertThat(rings.get(0).get(4)).isEqualTo(rings.get(0).get(0));
        assertThat(turn(rings.get(0))).as("the outline is counterclockwise").isPositive();
        assertThat(turn(rings.get(1))).as("a hole is clockwise").isNegative();
    }

    private static double turn(JsonNode ring) {
        double twice = 0;
        for (int i = 0; i + 1 < ring.size(); i++) {
            JsonNode a = ring.get(i);
            JsonNode b = ring.get(i + 1);
            twice += (a.get(0).asDouble() + 80) * (b.get(1).asDouble() - 40)
                    - (b.get(0).asDouble() + 80) * (a.get(1).asDouble() - 40);
        }
        return twice;
    }

    private static List<JsonNode> features(JsonNode json, String kind) {
        List<JsonNode> features = new ArrayList<>();
        json.get("features").forEach(feature -> {
            if (feature.at("/properties/kind").asText().equals(kind)) {
                features.add(feature);
            }
        });
        return features;
    }

    private static void same(String degrees, double value) {
        assertThat(Double.parseDouble(degrees)).isCloseTo(value, within(0.51e-7));
    }

    private static Document xml(String text) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        return factory.newDocumentBuilder().parse(new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    private static List<Element> elements(Element in, String localName) {
        NodeList nodes = in.getElementsByTagNameNS("*", localName);
        List<Element> elements = new ArrayList<>();
        for (int i = 0; i < nodes.getLength(); i++) {
            elements.add((Element) nodes.item(i));
        }
        return elements;
    }
}
