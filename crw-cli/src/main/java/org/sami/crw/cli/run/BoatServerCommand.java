package org.sami.crw.cli.run;

import java.io.BufferedReader;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.function.DoubleSupplier;
import org.jspecify.annotations.Nullable;
import org.sami.boat.hull.host.HullBoat;
import org.sami.boat.link.BoatAnnouncement;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.SteadyClock;
import org.sami.crw.cli.board.HullOptions;
import org.sami.crw.cli.board.RealBoatRun;
import org.sami.crw.cli.option.ConditionsOptions;
import org.sami.crw.cli.option.PositionConverter;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.crw.sim.hull.Energy;
import org.sami.crw.sim.hull.HullConfig;
import org.sami.spn.value.GeoPoint;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.ParseResult;
import picocli.CommandLine.Spec;

/** {@code crw boat}: one boat, simulated or real, that is reached over TCP, until it is stopped. */
@Command(
        name = "boat",
        mixinStandardHelpOptions = true,
        description =
                "Runs one boat: its server listens on a TCP port of this machine. Its hull is simulated and moves in"
                        + " real time, or, with --board and --gps, a real one. Runs until Ctrl-C or a signal ends it.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:its standard input has ended (--while-input), or its motors are checked (--check-motors)",
            "2:wrong usage",
            "4:its port, its log, its board or its GPS is not available, or the check of its motors was left",
            "130:stopped by Ctrl-C",
            "143:stopped by a signal"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw boat --port 5001 --name anna --at 45.4,10.9",
            "  crw boat --port 5001 --name anna --at 45.4,10.9 --log boats   go on with its log after a restart",
            "  crw boat --port 5001 --name anna --at 45.4,10.9 --gps-noise 1 --current 0.3@90 --sensor temperature",
            "  crw boat --port 5001 --name anna --board /dev/ttyACM0 --gps gpsd --hull anna.json   a real boat",
            "  crw boat --port 5001 --name anna --board /dev/ttyACM0 --hull anna.json --check-motors",
            "  crw boat --port 5001 --name anna --at 45.4,10.9 --mavlink udp:127.0.0.1:14550   also in QGroundControl"
        })
public final class BoatServerCommand implements Callable<Integer> {
    private static final Set<String> OF_REAL_BOATS = Set.of(
            "--port",
            "--boat-keys",
            "--pair",
            "--observer",
            "--open",
            "--name",
            "--lost-link",
            "--log",
            "--log-size",
            "--bind",
            "--while-input",
            "--announce",
            "--board",
            "--gps",
            "--hull",
            "--check-motors",
            "--declination",
            "--mavlink",
            "--mavlink-id");
    private static final int MAX_PORT = 65_535;
    private static final double MOST_TOP_SPEED_MPS = 20;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Option(
            names = "--port",
            required = true,
            paramLabel = "P",
            description = "The port that it listens on; 0 takes a free one, which is printed.")
    private int port;

    @Option(
            names = "--name",
            required = true,
            paramLabel = "NAME",
            description = "The boat's name, unique in the fleet.")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private String name;

    @Option(
            names = "--at",
            paramLabel = "LAT,LON",
            converter = PositionConverter.class,
            description = "Where a simulated boat lies at the start, in degrees (WGS 84).")
    private @Nullable GeoPoint at;

    @Option(
            names = "--seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "Where chance comes from (default ${DEFAULT-VALUE}).")
    private long seed;

    @Option(
            names = "--battery",
            paramLabel = "PERCENT",
            defaultValue = "100",
            description = "Charge at the start (default ${DEFAULT-VALUE}).")
    private double batteryPercent;

    @Option(
            names = "--top-speed",
            paramLabel = "MPS",
            defaultValue = "" + MotionDefaults.FULL_THRUST_SPEED_MPS,
            description = "Speed at full thrust in still water (default ${DEFAULT-VALUE}).")
    private double topSpeedMps;

    @Option(
            names = "--range",
            paramLabel = "METRES",
            description = "How far a full battery takes it on average, which it tells its base (default 3500).")
    private @Nullable Double rangeM;

    @Option(
            names = "--energy",
            paramLabel = "drag,hotel=WATTS,battery=WH|MPS:WATTS,...,battery=WH",
            description =
                    "What it uses by its speed, which it tells its base: drag for a metre that costs four times as"
                            + " much at twice the speed, with a hotel load while afloat; or its own curve of power by speed, from"
                            + " 0 m/s (default: a metre costs the same at any speed, rest nothing; a battery has 148 Wh).")
    private @Nullable String energy;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private ConditionsOptions conditions;

    @Mixin
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private HullOptions hullOptions;

    @Option(
            names = "--field-seed",
            paramLabel = "S",
            defaultValue = "1",
            description = "What there is to be measured; boats with the same one measure the same water "
                    + "(default ${DEFAULT-VALUE}).")
    private long fieldSeed;

    @Option(
            names = "--lost-link",
            paramLabel = "ACTION",
            defaultValue = "hold",
            description = "What it does when the link to its commander is lost, until a command sets something else: "
                    + "hold, return, continue, drift (default ${DEFAULT-VALUE}).")
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private LostLinkAction lostLink;

    @Mixin
    private BoatLogOptions log = new BoatLogOptions();

    @Option(
            names = "--bind",
            paramLabel = "ADDRESS",
            description = "The address that it listens on (default: loopback, so that nothing leaves this machine). "
                    + "Another one needs --boat-keys or --open.")
    private InetAddress bind = InetAddress.getLoopbackAddress();

    @Mixin
    private BoatKeyOptions keys = new BoatKeyOptions();

    @Mixin
    private AnnounceOption announcing = new AnnounceOption();

    @Mixin
    private GroundStationOptions groundStations = new GroundStationOptions();

    @Option(
            names = "--while-input",
            description =
                    "End when the standard input ends: for programs that start boats and end them with themselves "
                            + "in whatever way.")
    private boolean whileInput;

    @Override
    public Integer call() throws IOException {
        checkPort();
        keys.check(bind);
        groundStations.check();
        if (hullOptions.isReal()) {
            return drive();
        }
        hullOptions.refuseWithoutBoard();
        BoatSettings settings = settings();
        Console console = new Console();
        SteadyClock clock = SteadyClock.ofThisMachine();
        PrintWriter out = spec.commandLine().getOut();
        try (StopOnInterrupt stop = new StopOnInterrupt();
                BoatOnTcp boat = new BoatOnTcp(settings, clock, console, keys.links(clock, console::say))) {
            console.listening(boat.address(), boat.restored(), boat.unreadLogLines());
            try (Closeable announcer = console.announce(boat.address(), "simulated", boat::batteryPercent);
                    Closeable shown = groundStations.show(name, clock, boat::attach, boat::detach, console::say)) {
                awaitEnd();
            }
        } catch (InterruptedException e) {
            out.printf("%s stops%n", name);
            out.flush();
        }
        return ExitCode.OK;
    }

    /** A real boat: its board and its GPS. */
    private int drive() throws IOException {
        ParseResult given = spec.commandLine().getParseResult();
        for (OptionSpec option : given.matchedOptions()) {
            if (!OF_REAL_BOATS.contains(option.longestName())) {
                throw new ParameterException(
                        spec.commandLine(),
                        option.longestName() + " is for a simulated boat, not for one with --board");
            }
        }
        try {
            BoatSettings.checkName(name);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
        if (hullOptions.checksMotors()) {
            BufferedReader answers = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
            boolean done =
                    hullOptions.checkMotors(name, answers, spec.commandLine().getOut());
            return done ? ExitCode.OK : ExitCode.FAILED;
        }
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            RealBoatRun run =
                    new RealBoatRun(name, new InetSocketAddress(bind, port), lostLink, log.folder(), log.bytes());
            Console console = new Console();
            run.run(
                    hullOptions,
                    spec.commandLine().getOut(),
                    console,
                    () -> keys.links(SteadyClock.ofThisMachine(), console::say),
                    this::awaitEnd);
        } catch (InterruptedException e) {
            spec.commandLine().getOut().printf("%s stops%n", name);
            spec.commandLine().getOut().flush();
        }
        return ExitCode.OK;
    }

    /** Until somebody stops the process, or its input ends. */
    private void awaitEnd() throws InterruptedException {
        if (whileInput) {
            awaitEndOfInput();
        } else {
            new CountDownLatch(1).await();
        }
    }

    /** The wait for input cannot be interrupted: a thread of its own has it. */
    private static void awaitEndOfInput() throws InterruptedException {
        CountDownLatch ended = new CountDownLatch(1);
        Thread reader = new Thread(
                () -> {
                    try {
                        System.in.transferTo(OutputStream.nullOutputStream());
                    } catch (IOException e) {
                        // its holder is gone
                    } finally {
                        ended.countDown();
                    }
                },
                "input");
        reader.setDaemon(true);
        reader.start();
        ended.await();
    }

    private void warnOfDamage(int lines) {
        if (lines > 0) {
            new Console()
                    .say("its log has " + lines + (lines == 1 ? " damaged line" : " damaged lines")
                            + ": its entries are lost, maybe a fleet stop too");
        }
    }

    private void checkPort() {
        if (port < 0 || port > MAX_PORT) {
            throw new ParameterException(spec.commandLine(), "--port: " + port + " is not in 0 to " + MAX_PORT);
        }
    }

    private BoatSettings settings() {
        if (at == null) {
            throw new ParameterException(
                    spec.commandLine(), "a simulated boat needs --at, a real one --board and --gps");
        }
        try {
            return new BoatSettings(
                    name,
                    new InetSocketAddress(bind, port),
                    at,
                    seed,
                    batteryPercent,
                    hull(),
                    conditions.conditions(),
                    fieldSeed,
                    lostLink,
                    log.folder(),
                    log.bytes());
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage());
        }
    }

    private HullConfig hull() {
        if (!(topSpeedMps <= MOST_TOP_SPEED_MPS)) {
            throw new IllegalArgumentException(
                    "the top speed is at most " + MOST_TOP_SPEED_MPS + " m/s, not " + topSpeedMps);
        }
        HullConfig hull = HullConfig.DEFAULT.withTopSpeedMps(topSpeedMps);
        HullConfig ranging = rangeM == null ? hull : hull.withRangeM(rangeM);
        if (energy == null) {
            return ranging;
        }
        Energy use = Energy.parse(energy);
        if (use.isCurve() && rangeM != null) {
            throw new IllegalArgumentException("--energy: a range follows from the boat's curve: give one of the two");
        }
        return ranging.with(use);
    }

    /** Says on standard error who comes and goes. */
    private final class Console implements RealBoatRun.Console {
        private final PrintWriter err = spec.commandLine().getErr();

        @Override
        public void listening(InetSocketAddress address, int restored, int unreadLogLines) {
            PrintWriter out = spec.commandLine().getOut();
            out.printf("%s listens on %s:%d%n", name, address.getAddress().getHostAddress(), address.getPort());
            if (restored > 0) {
                out.printf("%s goes on with its log: %d commands; it does not move%n", name, restored);
            }
            out.flush();
            keys.qrCode(name, address).ifPresent(code -> say("or scan this, or copy its text:\n" + code));
            warnOfDamage(unreadLogLines);
        }

        @Override
        public Closeable announce(InetSocketAddress address, String hull, DoubleSupplier batteryPercent) {
            return announcing.open(address, () -> announcement(hull, batteryPercent.getAsDouble()), this::say);
        }

        @Override
        public Closeable show(HullBoat boat, SteadyClock clock) {
            return groundStations.show(name, clock, boat::attach, boat::detach, this::say);
        }

        private BoatAnnouncement announcement(String hull, double percent) {
            BoatAnnouncement boat = keys.announcement(name, hull);
            return percent >= 0 && percent <= 100
                    ? boat.withBattery((int) Math.round(percent))
                    : boat; // else not known
        }

        @Override
        public void connected(String client) {
            say(client + " has connected");
        }

        @Override
        public void closed(String client, String why) {
            say(client + " is gone: " + why);
        }

        @Override
        public void failed(String what, Throwable cause) {
            say(what + ": " + cause);
        }

        @Override
        public void recovered(String what) {
            say(what);
        }

        @Override
        public void say(String text) {
            synchronized (err) {
                err.println(name + ": " + text);
                err.flush();
            }
        }
    }
}
