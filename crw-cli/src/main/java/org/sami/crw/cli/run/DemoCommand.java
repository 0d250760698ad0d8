package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.option.OutputOptions;
import org.sami.crw.cli.option.PlanSource;
import org.sami.crw.cli.option.SpeedConverter;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.sim.boat.BoatProcess;
import org.sami.crw.sim.run.settings.FleetSettings;
import org.sami.crw.sim.run.settings.RunSettings;
import org.sami.crw.sim.run.settings.Speed;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw demo}: the main job, to be watched: boats visit locations. */
@Command(
        name = "demo",
        mixinStandardHelpOptions = true,
        description =
                "Starts three simulated boats as processes of their own, runs the plan 'clv' on them over TCP on the"
                        + " loopback address, shows it, and writes a report with a picture; it takes about a minute. The"
                        + " boats end with it.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the mission ended",
            "3:it was aborted",
            "4:it failed",
            "5:it was stopped before its end",
            "6:it ended, with problems"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw demo --report demo",
            "  crw demo --speed max    the same plan on boats in this process, faster than real time"
        })
public final class DemoCommand implements Callable<Integer> {
    private static final String PLAN = "clv";

    /** The demonstration ends by itself, whatever happens in it. */
    private static final long LIMIT_MILLIS = 150_000;

    /** In process at 20 times the speed of the world this is 70 s. */
    private static final long FAST_LIMIT_MILLIS = 1_400_000;

    private static final long CONNECT_WITHIN_MILLIS = 20_000;
    private static final List<String> NAMES = List.of("anna", "bert", "cleo");
    private static final GeoPoint QUAY = GeoPoint.of(45.7, 10.72);
    private static final double SPACING_DEG = 1e-4;
    private static final Path BUILD = Path.of("build");

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--report",
            paramLabel = "DIR",
            description = "Where the report goes (default build/demo-report where there is a folder build, "
                    + "else a new temporary folder).")
    private @Nullable Path folder;

    @Option(
            names = "--speed",
            paramLabel = "X|max",
            converter = SpeedConverter.class,
            description = "Use boats in this process, twelve locations, and this many simulated seconds in one second.")
    private @Nullable Speed speed;

    @Override
    public Integer call() throws Exception {
        return speed == null ? onBoatsThatAreProcesses() : inThisProcess(speed);
    }

    private int inThisProcess(Speed chosen) throws IOException {
        return run(new FleetSettings(NAMES.size(), 12, 600, 1), chosen, FAST_LIMIT_MILLIS, List.of());
    }

    private int onBoatsThatAreProcesses() throws IOException, InterruptedException {
        List<BoatProcess> boats = new ArrayList<>();
        try {
            for (String name : NAMES) {
                GeoPoint berth = GeoPoint.of(QUAY.latDeg(), QUAY.lonDeg() + boats.size() * SPACING_DEG);
                boats.add(new BoatProcess(thisProgram(), name, berth));
            }
            List<BoatAddress> addresses = new ArrayList<>();
            for (BoatProcess boat : boats) {
                addresses.add(boat.awaitAddress());
                tell(NAMES.get(addresses.size() - 1) + " is process " + boat.pid() + ", listening on "
                        + addresses.get(addresses.size() - 1));
            }
            return run(new FleetSettings(boats.size(), 9, 60, 1), Speed.REAL, LIMIT_MILLIS, addresses);
        } finally {
            boats.forEach(BoatProcess::close);
        }
    }

    private void tell(String line) {
        PrintWriter err = spec.commandLine().getErr();
        err.println(line);
        err.flush();
    }

    /** The command line of this program, whatever started it. */
    private List<String> thisProgram() {
        return List.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-XX:+UseSerialGC",
                "-Xshare:auto",
                "-cp",
                System.getProperty("java.class.path"),
                spec.root().userObject().getClass().getName());
    }

    private int run(FleetSettings fleet, Speed rate, long limitMillis, List<BoatAddress> addresses) throws IOException {
        Path reports = folder != null
                ? folder
                : Files.isDirectory(BUILD) ? BUILD.resolve("demo-report") : Files.createTempDirectory("crw-demo");
        DomainLibrary library = PlanSource.library();
        PlanSource source = PlanSource.find(PLAN, library);
        Plan plan = source.choose(PLAN);
        RunSettings settings = RunSettings.of(plan.id(), plan.name(), fleet)
                .speed(rate)
                .limitMillis(limitMillis)
                .answerAfterMillis(addresses.isEmpty() ? 5_000 : 1_000)
                .connect(addresses)
                .build();
        return new Execution(spec.commandLine(), library, OutputOptions.toFolder(reports), CONNECT_WITHIN_MILLIS)
                .runNew(source, plan, settings, null);
    }
}
