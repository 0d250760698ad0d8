package org.sami.crw.cli.run;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.Optional;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.atomic.AtomicBoolean;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.console.Console;
import org.sami.crw.console.LineSource;
import org.sami.crw.operator.OperatorModels;
import org.sami.session.client.PersonRights;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.SessionAddress;

/** The console of {@code crw session} on a session in another process. Leaving it leaves the session as it is. */
final class RemoteConsole implements RemoteListener {
    private final PrintWriter out;
    private final boolean attended;
    private final AtomicBoolean broken = new AtomicBoolean();
    private volatile Optional<LineSource> shown = Optional.empty();
    private volatile Optional<ConsoleEnd> end = Optional.empty();

    /** Opens the lines of a console. */
    @FunctionalInterface
    interface Lines {
        /** Those that the console reads. */
        LineSource of(Console console) throws IOException;
    }

    RemoteConsole(PrintWriter out, boolean attended) {
        this.out = out;
        this.attended = attended;
    }

    /**
     * Runs it until its lines end, or the session is left.
     *
     * @param withFaults what to give where commands were not carried out
     */
    int run(RemoteOptions options, Lines source, int withFaults) throws IOException, InterruptedException {
        ExecutorService front = Executors.newSingleThreadExecutor(work -> {
            Thread one = new Thread(work, "session");
            one.setDaemon(true);
            return one;
        });
        try (RemoteSession session = options.open(front, this);
                Console console = new Console(session);
                LineSource lines = source.of(console)) {
            shown = Optional.of(lines);
            ConsoleEnd running = new ConsoleEnd(console, lines, attended);
            end = Optional.of(running);
            lines.print("at " + session.address() + ": " + waiting(session.models())
                    + "; the session goes on when this console is left");
            int faults = broken.get() ? 0 : running.run();
            return broken.get() ? ExitCode.FAILED : faults == 0 ? ExitCode.OK : withFaults;
        } finally {
            front.shutdown();
        }
    }

    private static String waiting(OperatorModels models) {
        int missions = models.missions().snapshot().running().size();
        int decisions = models.decisions().pending().size();
        return missions
                + (missions == 1 ? " mission runs, " : " missions run, ")
                + decisions
                + (decisions == 1 ? " decision waits" : " decisions wait");
    }

    private void print(String line) {
        shown.ifPresentOrElse(lines -> lines.print(line), () -> {
            out.println(line);
            out.flush();
        });
    }

    @Override
    public void lost(String words) {
        print(words);
    }

    @Override
    public void back(SessionAddress base) {
        if (shown.isPresent()) { // else the first line says where it is
            print("connected again, at " + base);
        }
    }

    @Override
    public void rights(PersonRights now) {
        print("your role in this session is " + now.role() + " now");
    }

    @Override
    public void news(String text) {
        print(text);
    }

    @Override
    public void ended(String why) {
        broken.set(true);
        print("crw: " + why + (attended ? " (Enter leaves)" : ""));
        end.ifPresent(ConsoleEnd::end);
    }
}
