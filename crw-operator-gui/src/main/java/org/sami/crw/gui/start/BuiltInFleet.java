package org.sami.crw.gui.start;

import java.io.IOException;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.SimulatedBoats;
import org.sami.spn.value.GeoPoint;

/** The five simulated robots that a window without real ones has, in the shallows of Katara Beach: where both kinds are together, three boats and two copters. */
final class BuiltInFleet {
    private static final GeoPoint QUAY = GeoPoint.of(25.3597, 51.5268);
    private static final double SPACING_DEG = 0.0002; // 22 m
    private static final int BOATS_OF_TEAM = 3;

    /** Boats, by their ids. */
    static final List<String> NAMES = List.of("anna", "bert", "carl", "dora", "emil");

    private BuiltInFleet() {}

    /** The names of those of a kind. */
    static List<String> names(RobotKind robots) {
        int boats = switch (robots) {
            case BOAT -> NAMES.size();
            case COPTER -> 0;
            case ROBOT -> BOATS_OF_TEAM;
        };
        return Stream.concat(
                        NAMES.stream().limit(boats),
                        IntStream.range(0, NAMES.size() - boats).mapToObj(RobotKind.COPTER::nameOf))
                .toList();
    }

    /**
     * Launches them.
     *
     * @param at where boats of earlier processes were last; who is not in it begins at the quay
     * @return their addresses
     * @throws IOException if they cannot have ports
     */
    static List<BoatAddress> launch(SimulatedBoats boats, RobotKind robots, Map<String, GeoPoint> at)
            throws IOException {
        Map<String, GeoPoint> places = new LinkedHashMap<>();
        for (String name : names(robots)) {
            places.put(name, GeoPoint.of(QUAY.latDeg() - places.size() * SPACING_DEG, QUAY.lonDeg()));
        }
        places.replaceAll((name, quay) -> at.getOrDefault(name, quay));
        List<BoatAddress> addresses = new ArrayList<>();
        for (Map.Entry<String, GeoPoint> place : places.entrySet()) {
            addresses.add(boats.launch(place.getKey(), place.getValue()));
        }
        return addresses;
    }
}
