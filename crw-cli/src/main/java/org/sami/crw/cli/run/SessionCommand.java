package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.cli.output.Terminal;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.console.Console;
import org.sami.crw.console.LineSource;
import org.sami.crw.console.PlainLines;
import org.sami.crw.console.TerminalLines;
import org.sami.crw.session.Session;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code crw session}: a session that a person runs by typed commands, or a script does (docs/console.md). */
@Command(
        name = "session",
        mixinStandardHelpOptions = true,
        description = {
            "Opens a session and reads commands from standard input: any number of missions of the project's plans, on"
                    + " one fleet.",
            "Boats can be connected, added and dropped meanwhile. At a terminal lines are edited and completed (Tab); "
                    + "'help' lists the commands.",
            "Ends with 'quit' or the end of the input; the boats of all missions are stopped then.",
            "With --session it is the console of a session that 'crw serve' runs in another process, which goes on when"
                    + " the console is left."
        },
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:it was ended, and every command was carried out",
            "1:the project has errors",
            "2:wrong usage, or there is no such file",
            "4:an internal fault: the engine stopped, its journal could not be written, memory ran out; boats were"
                    + " stopped then; or the session elsewhere cannot be taken part in",
            "6:it was ended, but commands were not carried out"
        },
        footerHeading = "%nExamples:%n",
        footer = {
            "  crw session --connect 10.0.0.11:11411,10.0.0.12:11411 --journal today.journal",
            "  crw session --near                               all boats near that are paired",
            "  crw session my-project.json",
            "  crw session --session wss://10.0.0.5:8443 --person anna --key-file anna.key",
            "  echo 'add boat 45.70,10.72 3' | crw session station-keep"
        })
public final class SessionCommand implements Callable<Integer> {
    private static final int WITH_FAULTS = 6;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private SessionOptions options = new SessionOptions();

    @Mixin
    private RemoteOptions remote = new RemoteOptions();

    @Option(
            names = "--script",
            paramLabel = "FILE",
            description = "Read commands from this file instead of standard input.")
    private @Nullable Path script;

    @Override
    public Integer call() throws IOException, InterruptedException {
        if (script != null && !Files.isReadable(script)) {
            throw new UsageFault("--script: " + script + " cannot be read");
        }
        boolean attended = script == null && Terminal.onStandardInputAndOutput();
        remote.check(spec.commandLine(), Set.of("--script"));
        if (remote.isGiven()) {
            return new RemoteConsole(spec.commandLine().getOut(), attended).run(remote, this::lines, WITH_FAULTS);
        }
        return options.open(attended, (session, begin) -> run(session, begin, attended));
    }

    private int run(Session session, SessionOpening.Begin begin, boolean attended) throws IOException {
        try (Console console = new Console(session);
                LineSource lines = lines(console)) {
            ConsoleEnd end = new ConsoleEnd(console, lines, attended);
            session.addListener(end);
            begin.begin(lines::print);
            int faults = end.run();
            boolean stoodStill = session.models().health().snapshot().missionsStandStill(); // waiting for its journal
            session.leave().forEach(lines::print);
            if (stoodStill || session.faults().failure().isPresent()) {
                return ExitCode.FAILED;
            }
            return faults == 0 ? ExitCode.OK : WITH_FAULTS;
        }
    }

    private LineSource lines(Console console) throws IOException {
        PrintWriter out = spec.commandLine().getOut();
        if (script != null) {
            return new PlainLines("--script: " + script, Files.newBufferedReader(script), out);
        }
        if (Terminal.onStandardInputAndOutput()) {
            return new TerminalLines("crw> ", console::completions, history());
        }
        return new PlainLines("standard input", new InputStreamReader(System.in, StandardCharsets.UTF_8), out);
    }

    /** Where typed lines are kept, in the folder of the command's configuration. */
    private static Path history() {
        return Path.of(System.getProperty("user.home"), ".config", "sami", "crw-session-history");
    }
}
