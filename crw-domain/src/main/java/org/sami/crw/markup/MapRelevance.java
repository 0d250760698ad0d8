package org.sami.crw.markup;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/**
 * What of the map an interaction is about (markups Relevant Proxy, Relevant Area and Relevant Information).
 *
 * @param boats which boats are shown and highlighted, and what of them; empty where the markup is absent
 * @param area which part of the map is shown; empty where the markup is absent
 * @param information which readings are drawn; empty where the markup is absent
 */
public record MapRelevance(Optional<Boats> boats, Optional<Area> area, Optional<Information> information) {
    /** Nothing of the map is asked for. */
    public static final MapRelevance NONE = new MapRelevance(Optional.empty(), Optional.empty(), Optional.empty());

    private static final String PROXY = "RelevantProxy";
    private static final String AREA = "RelevantArea";
    private static final String INFORMATION = "RelevantInformation";
    private static final String SOURCE = "source";

    /** Which boats. */
    public enum ProxySet {
        /** Those that the interaction is about. */
        RELEVANT_PROXIES,
        /** All that are known. */
        ALL_PROXIES
    }

    /** Which part of the map. */
    public enum AreaSource {
        AREA,
        POINT,
        ALL_PROXIES,
        RELEVANT_PROXIES
    }

    /** What is to become of the part that is shown already, so that it has the relevant part in it. */
    public enum Modification {
        EXPAND,
        REDUCE
    }

    /** Which map. */
    public enum MapType {
        SATELLITE,
        POLITICAL
    }

    /** How readings are drawn. */
    public enum Visualization {
        HEATMAP,
        CONTOUR,
        THRESHOLD
    }

    /**
     * Boats that are shown and highlighted.
     *
     * @param boats their ids
     * @param showPath whether with past and planned paths
     * @param showDiagnostic whether with battery, speed and link
     * @param showData whether with their readings
     * @param showPictures whether with the pictures that they took last
     */
    public record Boats(
            List<String> boats, boolean showPath, boolean showDiagnostic, boolean showData, boolean showPictures) {
        public Boats {
            boats = List.copyOf(boats);
        }

        /** Boats without pictures. */
        public Boats(List<String> boats, boolean showPath, boolean showDiagnostic, boolean showData) {
            this(boats, showPath, showDiagnostic, showData, false);
        }
    }

    /**
     * A part of the map.
     *
     * @param area for source AREA, where the markup gives it
     * @param point for source POINT, where the markup gives it
     * @param boats the boats that it surrounds, for the other sources
     */
    public record Area(
            AreaSource source,
            Optional<GeoArea> area,
            Optional<GeoPoint> point,
            List<String> boats,
            Optional<Modification> modification,
            MapType mapType) {
        public Area {
            Objects.requireNonNull(source, "source");
            Objects.requireNonNull(area, "area");
            Objects.requireNonNull(point, "point");
            boats = List.copyOf(boats);
            Objects.requireNonNull(modification, "modification");
            Objects.requireNonNull(mapType, "mapType");
        }
    }

    /**
     * Readings that are drawn.
     *
     * @param sensor whose
     */
    public record Information(String sensor, Visualization visualization) {
        public Information {
            Objects.requireNonNull(sensor, "sensor");
            Objects.requireNonNull(visualization, "visualization");
        }
    }

    public MapRelevance {
        Objects.requireNonNull(boats, "boats");
        Objects.requireNonNull(area, "area");
        Objects.requireNonNull(information, "information");
    }

    /** Boats, with the pictures that they took last. */
    public static MapRelevance ofPictures(List<String> boats) {
        Boats shown = new Boats(boats, false, false, false, true);
        return new MapRelevance(Optional.of(shown), Optional.empty(), Optional.empty());
    }

    /**
     * What the markups of an interaction say.
     *
     * @param relevant the boats that the interaction is about
     * @param all the boats that are known
     */
    public static MapRelevance of(MarkupReader markups, List<String> relevant, List<String> all) {
        Optional<Boats> boats = markups.constant(PROXY, "proxy", ProxySet.class)
                .map(set -> new Boats(
                        set == ProxySet.ALL_PROXIES ? all : relevant,
                        markups.flag(PROXY, "showPath"),
                        markups.flag(PROXY, "showDiagnostic"),
                        markups.flag(PROXY, "showData"),
                        markups.flag(PROXY, "showPictures")));
        Optional<Area> area = markups.constant(AREA, SOURCE, AreaSource.class)
                .map(source -> new Area(
                        source,
                        markups.option(AREA, "area")
                                .filter(GeoArea.class::isInstance)
                                .map(GeoArea.class::cast),
                        markups.option(AREA, "point")
                                .filter(GeoPoint.class::isInstance)
                                .map(GeoPoint.class::cast),
                        around(source, relevant, all),
                        markups.constant(AREA, "modification", Modification.class),
                        markups.constant(AREA, "mapType", MapType.class).orElse(MapType.SATELLITE)));
        Optional<Information> information = markups.markup(INFORMATION)
                .map(spec -> new Information(
                        markups.text(INFORMATION, SOURCE),
                        markups.constant(INFORMATION, "visualization", Visualization.class)
                                .orElse(Visualization.HEATMAP)));
        return new MapRelevance(boats, area, information);
    }

    private static List<String> around(AreaSource source, List<String> relevant, List<String> all) {
        return switch (source) {
            case AREA, POINT -> List.of();
            case ALL_PROXIES -> all;
            case RELEVANT_PROXIES -> relevant;
        };
    }
}
