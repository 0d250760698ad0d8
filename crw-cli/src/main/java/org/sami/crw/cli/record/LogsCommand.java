package org.sami.crw.cli.record;

import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sami.boat.link.KeptFile;
import org.sami.crw.cli.option.BoatAddresses;
import org.sami.crw.cli.option.LinkOptions;
import org.sami.crw.cli.output.ExitCode;
import org.sami.crw.proxy.file.FleetFileFetch;
import org.sami.crw.proxy.tcp.BaseProtection;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/** {@code crw logs}: the logs of boats, fetched over their links. */
@Command(
        name = "logs",
        mixinStandardHelpOptions = true,
        description =
                "Fetches the logs of the boats at these addresses into a folder, all at once, during a mission too. Goes on where an "
                        + "earlier fetch ended, and fetches only what is new.",
        exitCodeListHeading = "%nExit codes:%n",
        exitCodeList = {
            "0:the logs of all boats are in the folder",
            "2:wrong usage",
            "4:a boat did not give its logs; those of the others are in the folder"
        },
        footerHeading = "%nExamples:%n",
        footer = {"  crw logs 127.0.0.1:5001 127.0.0.1:5002 --out logs"})
public final class LogsCommand implements Callable<Integer> {
    private static final long BETWEEN_LINES_NANOS = 2_000_000_000L;

    @Spec
    @SuppressWarnings("NullAway.Init") // picocli sets it
    private CommandSpec spec;

    @Mixin
    private LinkOptions links = new LinkOptions();

    @Mixin
    private BoatAddresses boats = new BoatAddresses();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            required = true,
            description = "The folder; each boat gets a folder of its name in it.")
    private @Nullable Path folder;

    private long shownNanos = System.nanoTime(); // guarded by this

    @Override
    public Integer call() throws InterruptedException {
        links.use();
        Path out = folder == null ? Path.of("") : folder;
        if (Files.exists(out) && !Files.isDirectory(out)) {
            throw new ParameterException(spec.commandLine(), "--out: " + out + " is no folder");
        }
        FleetFileFetch fetch = new FleetFileFetch(boats.addresses(), BaseProtection.ofThisProcess(), this::show);
        List<FleetFileFetch.Answer> answers = fetch.fetch(KeptFile.LOG, out);
        PrintWriter lines = spec.commandLine().getOut();
        answers.forEach(answer -> lines.println(words(answer)));
        lines.flush();
        return answers.stream().allMatch(FleetFileFetch.Answer::done) ? ExitCode.OK : ExitCode.FAILED;
    }

    private static String words(FleetFileFetch.Answer answer) {
        String boat = answer.address() + "  " + (answer.boatId().isEmpty() ? "" : answer.boatId() + ": ");
        if (!answer.done()) {
            return boat + String.join("; ", answer.faults());
        } else if (answer.files().isEmpty()) {
            return boat + "it keeps no log";
        }
        String files = answer.files().size() == 1
                ? answer.files().get(0).toString()
                : answer.files().size() + " files in " + answer.files().get(0).getParent();
        return boat + files + (answer.bytes() == 0 ? ", nothing new" : ", " + answer.bytes() + " bytes fetched");
    }

    private synchronized void show(String boatId, String name, long here, long bytes) {
        long now = System.nanoTime();
        if (now - shownNanos >= BETWEEN_LINES_NANOS) {
            shownNanos = now;
            PrintWriter err = spec.commandLine().getErr();
            err.println(boatId + ": " + name + ", " + 100 * here / Math.max(1, bytes) + " % of " + bytes + " bytes");
            err.flush();
        }
    }
}
