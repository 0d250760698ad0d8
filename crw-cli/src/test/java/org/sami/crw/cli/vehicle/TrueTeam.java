package org.sami.crw.cli.vehicle;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.cli.CommandResult;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.CommandOutcome;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.testing.SimulatorTruth;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Boats with the real firmware in a session that an operator's console leads, with a no-go area before them. Places are metres east and north of the middle of
 * where the boats start. Where they truly were, their simulators say.
 */
final class TrueTeam implements AutoCloseable {
    /** West, south, east and north edge of the no-go area, in metres. */
    static final List<Double> NO_GO = List.of(-20.0, 30.0, 20.0, 45.0);

    private static final double APART_DEG = 0.0003;
    private static final double START_S = 300;

    /** They keep no logs on board: beginning one may hold up a simulated boat when it is armed, so that it disarms itself. */
    private static final String WITHOUT_LOGS = "LOG_BACKEND_TYPE 0\n";

    private static final int BATTERY_RESET = 42_651; // ArduPilot's own command
    private static final int ALL_BATTERIES = 0xFF;
    private static final ObjectMapper JSON = new ObjectMapper();

    private final int first;
    private final int count;
    private final Path work;
    private final LocalFrame frame;
    private final NoGoRectangle noGo;
    private final ArduPilotBoats boats;
    private final List<SimulatorTruth> truths = new ArrayList<>();

    /** Starts boats, of which the first has a number. */
    TrueTeam(int first, int count, int speed, Path work) throws IOException {
        this.first = first;
        this.count = count;
        this.work = work;
        frame = new LocalFrame(45.7, 10.72 + APART_DEG * (first + (count - 1) / 2.0));
        noGo = new NoGoRectangle(frame, NO_GO.get(0), NO_GO.get(1), NO_GO.get(2), NO_GO.get(3));
        boats = ArduPilotBoats.with(WITHOUT_LOGS, first, count, speed, work);
        for (int i = first; i < first + count; i++) {
            truths.add(truth(i));
        }
    }

    /** The port opens a moment after the start. */
    private static SimulatorTruth truth(int number) {
        List<SimulatorTruth> open = new ArrayList<>();
        Await.until("boat " + number + " listens", () -> {
            try {
                return open.add(new SimulatorTruth(ArduPilotBoats.secondPort(number), number + 1));
            } catch (IOException notYet) {
                return false;
            }
        });
        return open.get(0);
    }

    /** What the session calls a boat, by its place in the team from 0. */
    String name(int boat) {
        return "mav" + (first + boat + 1);
    }

    /** A place as it is typed. */
    String typed(double eastM, double northM) {
        return String.format(Locale.ROOT, "%.7f,%.7f", frame.latDeg(eastM, northM), frame.lonDeg(eastM, northM));
    }

    /** Several as they are typed. */
    String typed(List<double[]> places) {
        return places.stream().map(at -> typed(at[0], at[1])).collect(Collectors.joining(";"));
    }

    /** Leads a session of a plan by commands, after all boats are there and the no-go area is drawn, until no mission runs. */
    CommandResult lead(String plan, List<String> commands) throws IOException {
        List<String> script = new ArrayList<>();
        script.add("wait boats " + count + " within " + (int) START_S);
        script.add("set @noGo '" + noGo.typed() + "'");
        script.addAll(commands);
        script.add("wait ended within 600");
        script.add("quit");
        CommandResult led = CommandResult.crw(
                "session",
                NoGoRectangle.project("crw", plan, "[]", work).toString(),
                "--connect",
                IntStream.range(first, first + count)
                        .mapToObj(i -> ArduPilotBoats.address(i) + "/" + (i + 1))
                        .collect(Collectors.joining(",")),
                "--script",
                Files.write(work.resolve("script"), script).toString(),
                "--journal",
                work.resolve("journal").toString());
        CommandResult.crw(
                "export",
                work.resolve("journal").toString(),
                work.resolve("export").toString());
        return led;
    }

    /** The place in which each boat was to assemble, as the journal says, in metres east and north. */
    Map<String, double[]> stations() throws IOException {
        Map<String, double[]> stations = new LinkedHashMap<>();
        for (JsonNode feature : features("assembly place")) {
            JsonNode at = feature.path("geometry").path("coordinates");
            String name = feature.path("properties").path("name").asText();
            stations.put(name.substring(name.lastIndexOf(' ') + 1), metres(at.get(1), at.get(0)));
        }
        return stations;
    }

    /** All points of all paths that missions gave to each boat, as the journal says, in metres east and north. */
    Map<String, List<double[]>> paths() throws IOException {
        Map<String, List<double[]>> paths = new LinkedHashMap<>();
        for (JsonNode feature : features("path")) {
            List<double[]> path = paths.computeIfAbsent(
                    feature.path("properties").path("boat").asText(), boat -> new ArrayList<>());
            feature.path("geometry").path("coordinates").forEach(at -> path.add(metres(at.get(1), at.get(0))));
        }
        return paths;
    }

    private List<JsonNode> features(String kind) throws IOException {
        List<JsonNode> features = new ArrayList<>();
        JsonNode map = JSON.readTree(Files.readString(work.resolve("export").resolve("map.geojson")));
        for (JsonNode feature : map.path("features")) {
            if (feature.path("properties").path("kind").asText().equals(kind)) {
                features.add(feature);
            }
        }
        return features;
    }

    private double[] metres(JsonNode latDeg, JsonNode lonDeg) {
        return new double[] {
            frame.eastM(latDeg.asDouble(), lonDeg.asDouble()), frame.northM(latDeg.asDouble(), lonDeg.asDouble())
        };
    }

    /** Where a boat truly was, in metres east and north, from one of its reports on. */
    List<double[]> track(int boat, int fromSample) {
        return truths.get(boat).placesFrom(fromSample).stream()
                .map(at -> new double[] {frame.eastM(at[0], at[1]), frame.northM(at[0], at[1])})
                .toList();
    }

    /** How many reports have come of a boat. */
    int samples(int boat) {
        return truths.get(boat).samples();
    }

    /** How near any boat truly came to a place, in metres. */
    double nearestM(double[] place) {
        return IntStream.range(0, count)
                .mapToDouble(boat -> nearestM(boat, place))
                .min()
                .orElseThrow();
    }

    /** How near a boat truly came to a place, in metres. */
    double nearestM(int boat, double[] place) {
        return truths.get(boat).nearestM(frame.latDeg(place[0], place[1]), frame.lonDeg(place[0], place[1]));
    }

    /** What is not known of where the boats truly were, a line for each; empty where all is known. */
    List<String> gaps() {
        return IntStream.range(0, count)
                .boxed()
                .flatMap(boat -> truths.get(boat).gap().map(why -> name(boat) + ": " + why).stream())
                .toList();
    }

    /** The reports of all boats, and those of them within the no-go area. */
    long[] allAndInside() {
        long all = 0;
        long inside = 0;
        for (int boat = 0; boat < count; boat++) {
            List<double[]> track = truths.get(boat).placesFrom(0);
            all += track.size();
            inside += noGo.inside(track);
        }
        return new long[] {all, inside};
    }

    /** Sets what the autopilot of a boat takes its battery's charge for, in percent, by its third link, as its owner does. */
    void charge(int boat, double percent) {
        String address = "mavlink:tcp:127.0.0.1:" + ArduPilotBoats.thirdPort(first + boat);
        VehicleId id = new VehicleId(first + boat + 1, 1);
        try (MavlinkBase owner = new MavlinkBase(List.of(AddressText.parse(address)), ProcessClock::ms)) {
            Await.until("it is heard", () -> !owner.vehicles().join().isEmpty());
            CommandOutcome set = owner.command(
                            id, VehicleCommand.of(BATTERY_RESET, "set the charge", ALL_BATTERIES, percent))
                    .join();
            if (!set.isAccepted()) {
                throw new AssertionError(set.inWords());
            }
        }
    }

    @Override
    public void close() throws Exception {
        for (SimulatorTruth truth : truths) {
            truth.close();
        }
        boats.close();
    }
}
