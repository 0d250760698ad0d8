package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.InterruptedIOException;
import java.io.PrintWriter;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.security.Identity;
import org.sami.crw.cli.key.PeopleOption;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.StopOnInterrupt;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.cli.pair.PairOption;
import org.sami.crw.cli.pair.PairedBase;
import org.sami.crw.console.Console;
import org.sami.crw.console.LineSource;
import org.sami.crw.console.PlainLines;
import org.sami.crw.proxy.key.BaseKeys;
import org.sami.crw.proxy.tcp.BaseProtection;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionListener;
import org.sami.pair.postgres.StandbyMonitor;
import org.sami.pair.postgres.StandbyPresence;
import org.sami.session.person.People;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.StandbyServer;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw serve}: a session without a window, for several people (docs/scale.md). */
@Command(
        name = "serve",
        mixinStandardHelpOptions = true,
        description = {
            "Opens a session and serves it to several people: a page for browsers, and the link of"
                    + " docs/session-link.md.",
            "Without people it listens on this machine only, and everybody on it is an operator. People and their keys:"
                    + " 'crw people add'.",
            "Ends with Ctrl-C; the boats of all missions are stopped then."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:it was ended",
            "1:the project has errors",
            "2:wrong usage, or there is no such file",
            "4:the address is taken, or an internal fault: the engine stopped, its journal could not be written; boats"
                    + " were stopped then"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw serve --journal 'postgresql://base-db/boats?user=pilot' --standby",
            "  crw serve --pair                                   on both bases of a pair (crw pair)",
            "  crw serve --connect 10.0.0.11:11411 --journal today.journal",
            "  crw serve --host 10.0.0.5 --port 8443 --near       people of ~/.config/sami/people log in by https",
            "  crw serve --script boats.txt                       commands of 'crw session' first, such as 'add boat'"
        })
public final class ServeCommand implements Callable<Integer> {
    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private SessionOptions options = new SessionOptions();

    @Mixin
    private PairOption pair = new PairOption();

    @Mixin
    private PeopleOption people = new PeopleOption();

    @Option(
            names = "--host",
            paramLabel = "ADDRESS",
            description = "The address of this machine at which it listens; other than loopback with people only, by"
                    + " HTTPS (default: ${DEFAULT-VALUE}).")
    private String host = "127.0.0.1";

    @Option(names = "--port", paramLabel = "N", description = "0 for any free one (default: ${DEFAULT-VALUE}).")
    private int port = 8080;

    @Option(
            names = "--map",
            paramLabel = "FILE",
            description = "The page's background map: raster tiles (MBTiles), as the operator's window takes them.")
    private @Nullable Path map;

    @Option(
            names = "--script",
            paramLabel = "FILE",
            description = "Carry out the commands of this file first, as 'crw session' does.")
    private @Nullable Path script;

    @Option(
            names = "--standby",
            description = "Wait while another base holds the session of --journal postgresql://..., read it meanwhile,"
                    + " and go on with it once that base's lease is over.")
    private boolean standby;

    @Option(
            names = "--bases",
            paramLabel = "ADDRESS",
            split = ",",
            description = "All bases of the session, this one too, as fronts reach them, with the SHA-256 that each"
                    + " prints: wss://HOST:PORT=SHA-256, or ws://HOST:PORT on this machine. Fronts that lose one go to"
                    + " the next.")
    private List<String> bases = new ArrayList<>();

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (script != null && !Files.isReadable(script)) {
            throw new UsageFault("--script: " + script + " cannot be read");
        }
        named(); // what is wrong with options is said before anything begins
        checkPeople();
        Optional<PairedBase> paired = pair.open(line -> print(spec.commandLine().getOut(), "pair: " + line));
        paired.ifPresent(base -> {
            options.keepIn(base.journal());
            print(spec.commandLine().getOut(), "pair: the session is kept in " + base.journal());
        });
        boolean waits = paired.map(PairedBase::standsBy).orElse(standby);
        if (standby && !waits) {
            throw new UsageFault("this base has the session's database; --standby is for the other base of the pair");
        }
        if (waits && script != null) {
            throw new UsageFault(
                    "--script is carried out by the base that begins the session, not by one that stands by");
        }
        try (StopOnInterrupt stop = new StopOnInterrupt()) {
            if (waits) {
                return takeOver(paired, stop);
            }
            return options.open(false, (session, begin) -> run(session, begin, address(), paired, stop));
        }
    }

    private int takeOver(Optional<PairedBase> paired, StopOnInterrupt stop) throws IOException, InterruptedException {
        PrintWriter out = spec.commandLine().getOut();
        ServerAddress here = address();
        SessionBases named = named();
        Optional<StandbyPresence> presence = paired.map(PairedBase::standBy);
        try (OpenedMap background = OpenedMap.of(Optional.ofNullable(map));
                StandbyServer waiting =
                        UsageFault.of(() -> StandbyServer.start(people.people(), here, background.tiles(), named))) {
            print(out, "standby: it answers at " + waiting.url() + ", and serves the session there once it holds it");
            waiting.certificate().ifPresent(print -> print(out, "its certificate has the SHA-256 " + print));
            ServerAddress there =
                    new ServerAddress(here.host(), waiting.listensAt().getPort(), here.identity());
            return options.takeOver(
                    line -> {
                        if (isOfLease(line)) {
                            waiting.say(line);
                        }
                        print(out, "standby: " + line);
                    },
                    (session, begin) -> {
                        presence.ifPresent(StandbyPresence::close);
                        waiting.close();
                        return run(session, begin, there, paired, stop);
                    });
        } catch (InterruptedIOException ended) {
            Thread.interrupted(); // by Ctrl-C, while it waited: nothing was begun
            presence.ifPresent(StandbyPresence::leave);
            return ExitCode.OK;
        } finally {
            presence.ifPresent(StandbyPresence::close);
        }
    }

    private int run(
            Session session,
            SessionOpening.Begin begin,
            ServerAddress at,
            Optional<PairedBase> paired,
            StopOnInterrupt stop)
            throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        People who = people.people();
        SessionBases named = named();
        CountDownLatch broken = new CountDownLatch(1);
        AtomicBoolean replaced = new AtomicBoolean();
        Runnable onReplaced = () -> {
            replaced.set(true);
            broken.countDown();
        };
        try (OpenedMonitor monitor = OpenedMonitor.of(paired, session, line -> print(out, line), onReplaced);
                OpenedMap background = OpenedMap.of(Optional.ofNullable(map));
                SessionServer server =
                        UsageFault.of(() -> SessionServer.start(session, who, at, background.tiles(), named))) {
            session.addListener(new SessionListener() {
                @Override
                public void onBroken(String reason) {
                    print(out, "crw: the session cannot go on: " + reason);
                    broken.countDown();
                }
            });
            begin.begin(line -> print(out, line));
            print(
                    out,
                    "the session is at " + server.url() + (who.needKeys() ? "" : ", for whoever is on this machine"));
            server.certificate().ifPresent(print -> print(out, "its certificate has the SHA-256 " + print));
            waitFor(session, broken, out, stop);
            boolean stoodStill = session.models().health().snapshot().missionsStandStill();
            session.leave(replaced.get() ? BoatsAtEnd.GO_ON : BoatsAtEnd.STOP).forEach(line -> print(out, line));
            return replaced.get() || stoodStill || session.faults().failure().isPresent()
                    ? ExitCode.FAILED
                    : ExitCode.OK;
        }
    }

    /** Looks after the standby of a pair, or after none. */
    private record OpenedMonitor(Optional<StandbyMonitor> monitor) implements AutoCloseable {
        static OpenedMonitor of(
                Optional<PairedBase> paired, Session session, Consumer<String> lines, Runnable onReplaced)
                throws IOException {
            return new OpenedMonitor(
                    paired.isPresent()
                            ? Optional.of(paired.get().monitor(session, lines, onReplaced))
                            : Optional.empty());
        }

        @Override
        public void close() {
            monitor.ifPresent(StandbyMonitor::close);
        }
    }

    /** Whether a line says who holds the session, for fronts; what else a standby says is for whoever sits at it. */
    private static boolean isOfLease(String line) {
        return line.startsWith("the session ")
                || line.startsWith("the database ")
                || line.startsWith("nobody ")
                || line.startsWith("nothing comes from ");
    }

    private void waitFor(Session session, CountDownLatch broken, PrintWriter out, StopOnInterrupt stop)
            throws IOException {
        try (Console console = new Console(session)) {
            if (script != null) {
                try (LineSource lines = new PlainLines("--script: " + script, Files.newBufferedReader(script), out)) {
                    console.run(lines);
                }
            }
            if (!stop.getAsBoolean()) {
                broken.await();
            }
        } catch (InterruptedException ended) {
            Thread.interrupted(); // by Ctrl-C: boats are left in order
        }
    }

    private SessionBases named() {
        try {
            return SessionBases.parse(bases);
        } catch (IllegalArgumentException unfit) {
            throw new UsageFault("--bases: " + unfit.getMessage());
        }
    }

    private void checkPeople() {
        if (!host().isLoopbackAddress() && !people.people().needKeys()) {
            throw new UsageFault("--host " + host + ": without people a session is served on this machine only;"
                    + " 'crw people add NAME' lists one");
        }
    }

    private InetAddress host() {
        try {
            return InetAddress.getByName(host);
        } catch (UnknownHostException unknown) {
            throw new UsageFault("--host: there is no address '" + host + "'");
        }
    }

    private ServerAddress address() throws IOException {
        InetAddress at = host();
        Optional<Identity> identity = at.isLoopbackAddress()
                ? Optional.empty()
                : Optional.of(new BaseKeys(BaseProtection.ofThisProcess().keysFolder())
                        .open()
                        .identity());
        return new ServerAddress(at, port, identity);
    }

    private static synchronized void print(PrintWriter out, String line) {
        out.println(line);
        out.flush();
    }
}
