package org.sami.crw.cli.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleBiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;
import org.sami.crw.sim.run.settings.Site;
import org.sami.spn.value.GeoPoint;

/**
 * Runs on three kinds of boats at once: one that is simulated in the process of the run, one of ours over TCP, and one that speaks MAVLink and is twice as fast.
 * On calm water the first two know where they are, so their tracks in the report are the truth; of the third its simulator says it.
 */
final class MixedTeam implements AutoCloseable {
    private static final double VISIT_M = 3.5;
    private static final Pattern LANES = Pattern.compile("in (\\d+) m of track, for 3 boats at most (\\d+) m");
    private static final double TRACK_ROUNDING_M = 0.3; // tracks are thinned

    private final SimulatedBoatsOnTcp ours = new SimulatedBoatsOnTcp(1);
    private final GeoPoint centre;
    private final double areaM;
    private final String anna;
    private final String vehicle;
    private final ToDoubleBiFunction<Double, Double> vehicleNearestM;
    private final Map<String, List<GeoPoint>> tracks = new HashMap<>();
    private final Map<String, Double> distanceM = new HashMap<>();

    /**
     * Launches the boat over TCP.
     *
     * @param centre of the square in which they work
     * @param areaM its side, in metres
     * @param vehicle the address of the one that speaks MAVLink
     * @param vehicleNearestM how near that one truly came to a place, by latitude and longitude in degrees, in metres
     */
    MixedTeam(GeoPoint centre, double areaM, String vehicle, ToDoubleBiFunction<Double, Double> vehicleNearestM)
            throws IOException {
        this.centre = centre;
        this.areaM = areaM;
        this.vehicle = vehicle;
        this.vehicleNearestM = vehicleNearestM;
        LocalFrame frame = frame();
        anna = ours.launch("anna", GeoPoint.of(frame.latDeg(-15, -areaM / 2), frame.lonDeg(-15, -areaM / 2)))
                .toString();
    }

    /** Runs a plan on all three to its end; the report goes into a folder that is not there yet. Gives what is printed. */
    String run(Path report, String plan, String... more) throws IOException {
        List<String> arguments = new ArrayList<>(List.of(
                "run",
                plan,
                "--boats",
                "1",
                "--connect",
                anna + "," + vehicle,
                "--connect-within",
                "300",
                "--at",
                Site.words(centre),
                "--area",
                String.valueOf(areaM),
                "--conditions",
                "calm",
                "--answer-after",
                "1",
                "--report",
                report.toString()));
        arguments.addAll(List.of(more));

        CommandResult ran = CommandResult.crw(arguments.toArray(String[]::new));

        assertThat(ran.exitCode()).as(ran.out() + ran.err()).isZero();
        rows(report, "tracks.csv")
                .forEach(row -> tracks.computeIfAbsent(row[0], boat -> new ArrayList<>())
                        .add(GeoPoint.of(Double.parseDouble(row[2]), Double.parseDouble(row[3]))));
        rows(report, "boats.csv").forEach(row -> distanceM.put(row[0], Double.parseDouble(row[2])));
        return ran.out();
    }

    /** The rows of a table of the report, without its head. */
    private static List<String[]> rows(Path report, String table) throws IOException {
        return Files.readAllLines(report.resolve(table)).stream()
                .skip(1)
                .map(row -> row.split(",", -1))
                .toList();
    }

    /** Each location was truly visited by one of them. */
    void assertVisited(Path report, int locations) throws IOException {
        assertThat(rows(report, "locations.csv"))
                .hasSize(locations)
                .allSatisfy(row -> assertThat(nearestM(Double.parseDouble(row[1]), Double.parseDouble(row[2])))
                        .isLessThan(VISIT_M));
    }

    /** The boat that is as fast as both others together has half of the lanes, less what it loses in turns with its circle of 2 m: the others turn on the spot. */
    static void assertFastBoatHasNearlyHalfOfTheLanes(String out) {
        Matcher said = LANES.matcher(out);
        assertThat(said.find()).as(out).isTrue();
        double part = Double.parseDouble(said.group(2)) / Double.parseDouble(said.group(1));
        assertThat(part).as(said.group()).isBetween(0.48, 0.497);
    }

    /** How far a boat of ours has driven, in metres. */
    double distanceM(String boat) {
        return distanceM.getOrDefault(boat, 0.0);
    }

    /** How near any of them truly came to a place, in metres. */
    double nearestM(double latDeg, double lonDeg) {
        double oursM = Math.min(nearestM("boat1", latDeg, lonDeg), nearestM("anna", latDeg, lonDeg));
        return Math.min(oursM, vehicleNearestM.applyAsDouble(latDeg, lonDeg));
    }

    private double nearestM(String boat, double latDeg, double lonDeg) {
        LocalFrame frame = frame();
        double eastM = frame.eastM(latDeg, lonDeg);
        double northM = frame.northM(latDeg, lonDeg);
        List<GeoPoint> track = tracks.getOrDefault(boat, List.of());
        double least = Double.MAX_VALUE;
        for (int i = 1; i < track.size(); i++) {
            least = Math.min(least, toSegmentM(eastM, northM, track.get(i - 1), track.get(i)));
        }
        return least;
    }

    private double toSegmentM(double eastM, double northM, GeoPoint from, GeoPoint to) {
        LocalFrame frame = frame();
        double fromEastM = frame.eastM(from.latDeg(), from.lonDeg());
        double fromNorthM = frame.northM(from.latDeg(), from.lonDeg());
        double alongEastM = frame.eastM(to.latDeg(), to.lonDeg()) - fromEastM;
        double alongNorthM = frame.northM(to.latDeg(), to.lonDeg()) - fromNorthM;
        double squared = alongEastM * alongEastM + alongNorthM * alongNorthM;
        double dot = (eastM - fromEastM) * alongEastM + (northM - fromNorthM) * alongNorthM;
        double part = squared == 0 ? 0 : Math.max(0, Math.min(1, dot / squared));
        return Math.hypot(eastM - fromEastM - part * alongEastM, northM - fromNorthM - part * alongNorthM)
                + TRACK_ROUNDING_M;
    }

    /** How far from all true tracks a place of the square may lie at most, in metres: the worst of places that are 2 m apart. */
    double leastCoveredM() {
        LocalFrame frame = frame();
        double worst = 0;
        for (double eastM = -areaM / 2 + 1; eastM < areaM / 2; eastM += 2) {
            for (double northM = -areaM / 2 + 1; northM < areaM / 2; northM += 2) {
                worst = Math.max(worst, nearestM(frame.latDeg(eastM, northM), frame.lonDeg(eastM, northM)));
            }
        }
        return worst;
    }

    private LocalFrame frame() {
        return new LocalFrame(centre.latDeg(), centre.lonDeg());
    }

    @Override
    public void close() {
        ours.close();
    }
}
